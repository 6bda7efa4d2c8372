// Traces passes over one snapshot and keeps their mean. One thread at a time.
#pragma once
#include "frame/refinement/refinement.h"
#include "frame/tracing/tracer.h"

#include <string>

namespace gluray::frame {

/// Whether passes make pictures of the snapshot better, and there is memory for their sums.
bool isRefinable(const scene::Snapshot& snapshot);

/// Whether a picture of these passes is finished: as little noise as `noise` allows, or `refine.passes`.
bool isFinished(const Refinement& refinement, const Settings& settings);

/// Fewer passes tell little about noise: well distributed rays may agree by chance.
inline constexpr uint32_t kMinPasses = 4;

class Refiner {
 public:
  /// Continues `refinement`, whose passes, if any, were over an equal snapshot; it must outlive this.
  Refiner(const scene::Snapshot& snapshot, Refinement& refinement);
  /// Traces one more pass; misses of byte colours get `missColor`. False, with a line in `error`: nothing was
  /// added. Adds to `cost`.
  bool pass(const Trace& trace, uint32_t missColor, scene::TraceCost& cost, std::string& error);
  /// Writes the mean into `out`; misses get out.missColor. Call after pass(). Throws std::bad_alloc.
  void show(Image& out) const;
  /// Whether show() may be called.
  bool hasPass() const { return whole_; }
  bool finished() const { return isFinished(refinement_, snapshot_.settings); }
  /// After pass(): the picture that another process makes; null: passes are made here. It is none of them.
  const Image* elsewhere() const { return elsewhere_ ? &image_ : nullptr; }
  /// Whether that is finished.
  bool finishedElsewhere() const { return finishedElsewhere_; }
  const Refinement& refinement() const { return refinement_; }

 private:
  bool traceGuides(const Trace& trace, scene::TraceCost& cost, std::string& error);

  scene::Snapshot snapshot_;  // with wide colours where these are not those of the picture
  bool wide_;                 // the picture's colours are wide
  Refinement& refinement_;
  Image image_;         // of the last pass
  bool whole_ = false;  // image_ has all tiles
  bool filters_;        // pictures are smoothed
  bool elsewhere_ = false, finishedElsewhere_ = false;
};

}  // namespace gluray::frame
