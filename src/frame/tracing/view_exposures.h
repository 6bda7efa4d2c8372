// Automatic exposures of views (setting auto-exposure). Used by one thread at a time.
#pragma once
#include "scene/snapshot.h"

#include <cstdint>
#include <map>
#include <optional>

namespace gluray::frame {

/// All batches and passes of a frame of a view have one exposure: that of the first batch whose exposure can
/// be measured.
class ViewExposures {
 public:
  /// The factor of linear light for the batch's lit surfaces; `meter`: measures it, none where it cannot.
  template <class Meter>
  float exposureOf(const scene::Snapshot& s, const Meter& meter) {
    if (known_.size() > kMaxViews) known_.clear();  // windows come and go
    Known& known = known_[s.view];
    if (known.viewFrame != s.viewFrame || s.viewFrame == 0) known = {s.viewFrame, std::nullopt};
    if (!known.factor) known.factor = meter();
    return known.factor.value_or(1);
  }
  void clear() { known_.clear(); }

 private:
  static constexpr size_t kMaxViews = 64;
  struct Known {
    uint64_t viewFrame = 0;
    std::optional<float> factor;
  };
  std::map<uint64_t, Known> known_;
};

}  // namespace gluray::frame
