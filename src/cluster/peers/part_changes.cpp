#include "cluster/peers/part_changes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gluray::cluster {
namespace {

/// Whether two motions of a part are equal up to the rounding of matrices. What is no number has changed.
bool isSameMotion(const glm::dmat4& a, const glm::dmat4& b) {
  constexpr double kRounded = 1e-4;
  for (int column = 0; column < 4; ++column) {
    const double size = std::max(1.0, std::max(glm::length(a[column]), glm::length(b[column])));
    if (!(glm::length(a[column] - b[column]) <= kRounded * size)) return false;
  }
  return true;
}

glm::dmat4 motionOf(const PartState& earlier, const PartState& now) {
  return earlier.eyeFromLargest * glm::inverse(now.eyeFromLargest);
}

}  // namespace

void PartChanges::find(uint64_t name) {
  const auto known = std::ranges::find(views_, name, &View::name);
  if (known != views_.end()) return views_.splice(views_.begin(), views_, known);
  if (views_.size() >= kMaxViews) views_.pop_back();
  views_.emplace_front().name = name;
}

PartState PartChanges::show(const scene::Snapshot& snapshot, const render::FrameData* frame) {
  find(snapshot.view);
  View& view = this->view();
  if (snapshot.number != 0 && snapshot.number == view.number) return view.own;  // another pass over it
  render::Placement now;
  if (frame) now.rememberScene(snapshot);
  const bool both = !now.objects.empty() && !view.placement.objects.empty();
  const bool changed = both ? render::Reprojection(view.placement, view.space, now, *frame).changed
                            : now.objects.size() != view.placement.objects.size();
  if (changed) view.own.changes = ++changes_;  // views that were forgotten count on
  using Object = render::Placement::Object;
  const auto largest = std::ranges::max_element(now.objects, {}, &Object::triangles);
  view.own.eyeFromLargest = largest == now.objects.end() ? glm::dmat4(1) : largest->eyeFromObject;
  view.space = frame ? render::PixelSpace(*frame) : render::PixelSpace();
  view.placement = std::move(now), view.number = snapshot.number;
  return view.own;
}

bool PartChanges::changed(std::vector<PartState> parts) {
  now_ = std::move(parts);
  const auto isSamePart = [](const PartState& a, const PartState& b) {
    return a.rank == b.rank && a.changes == b.changes;
  };
  const std::vector<PartState>& kept = view().kept;
  if (!std::ranges::equal(kept, now_, isSamePart)) return true;
  for (size_t i = 1; i < now_.size(); ++i)
    if (!isSameMotion(motionOf(kept[0], now_[0]), motionOf(kept[i], now_[i]))) return true;
  return kept.empty();
}

}  // namespace gluray::cluster
