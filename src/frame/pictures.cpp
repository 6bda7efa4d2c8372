#include "frame/pictures.h"

#include <utility>

namespace gluray::frame {

Pictures::Result Pictures::of(const scene::Snapshot& snapshot, bool mayRepeat,
                              std::optional<uint32_t> missColor) {
  Result result;
  const bool ahead = ahead_ && ahead_->has(snapshot);
  // A finished full structure takes memory beside the fast one until a trace installs it: do not repeat then.
  const bool repeats = mayRepeat && !ahead && !(improves_ && improves_());
  if (const auto* known = repeats ? last_.of(snapshot, missColor) : nullptr) {
    result.repeated = true, result.picture = known;
    return result;
  }
  LastPictures::Picture& fresh = last_.next();
  fresh.image.missColor = missColor.value_or(0);
  const bool done = ahead ? ahead_->take(fresh.image, result.cost, result.why)
                          : trace_(snapshot, fresh.image, result.cost, result.why);
  if (!done) return result;
  last_.keep(snapshot);
  result.picture = &fresh;
  return result;
}

bool Pictures::startAhead(scene::SnapshotPtr snapshot, uint32_t missColor, TraceAhead::Late late) {
  if (!ahead_) ahead_ = std::make_unique<TraceAhead>(trace_);
  return ahead_->start(std::move(snapshot), missColor, std::move(late));
}

void Pictures::dropAhead() noexcept {
  if (ahead_) ahead_->drop();
}

}  // namespace gluray::frame
