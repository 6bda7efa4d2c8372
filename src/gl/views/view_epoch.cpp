#include "gl/views/view_epoch.h"

#include <algorithm>
#include <cmath>

namespace gluray::gl {
bool areNear(const glm::dmat4& a, const glm::dmat4& b) {
  constexpr double kRounding = 1e-4;
  const double distance = std::max(glm::length(glm::dvec3(a[3])), glm::length(glm::dvec3(b[3])));
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 3; ++r)
      if (!(std::abs(a[c][r] - b[c][r]) <= kRounding * (c == 3 ? distance : 1))) return false;
  return true;
}

namespace {

Likeness likenessOfVolumes(const scene::Snapshot& earlier, const scene::Snapshot& now) {
  if (earlier.volumes.size() != now.volumes.size()) return Likeness::none;
  const auto gridOf = [](const scene::Snapshot& s) { return s.volumes.front().medium->volume.grid; };
  return gridOf(earlier) == gridOf(now) ? Likeness::same : Likeness::resembles;
}

}  // namespace

Likeness likenessOf(const scene::Snapshot& earlier, const scene::Snapshot& now) {
  if (!now.volumes.empty() || !earlier.volumes.empty()) return likenessOfVolumes(earlier, now);
  const bool layers = !earlier.layers == !now.layers && (!now.layers || earlier.layers->of == now.layers->of);
  if (!layers || earlier.instances.empty() || now.instances.empty()) return Likeness::none;
  if (earlier.instances[0].mesh->geometryId == now.instances[0].mesh->geometryId) return Likeness::same;
  return earlier.instances.size() == now.instances.size() ? Likeness::resembles : Likeness::none;
}

Repetition repetitionOf(const ViewEpoch& last, size_t repeated, const scene::Snapshot& now) {
  const auto& batches = last.batches;
  for (size_t i = repeated; i < batches.size(); ++i)
    if (likenessOf(*batches[i].snapshot, now) == Likeness::same) return {i + 1, &batches[i]};
  // Geometry that changes in every frame is found by its turn.
  if (repeated < batches.size() && likenessOf(*batches[repeated].snapshot, now) == Likeness::resembles)
    return {repeated + 1, &batches[repeated]};
  return {repeated, nullptr};
}

void Movement::compare(const scene::Snapshot& before, const scene::Snapshot& now) {
  const size_t count = std::min(before.instances.size(), now.instances.size());
  for (size_t i = 0; i < count && moved_.size() < kMax; ++i)
    compare(before.instances[i].eyeFromObject, now.instances[i].eyeFromObject);
  const size_t volumes = std::min(before.volumes.size(), now.volumes.size());
  for (size_t i = 0; i < volumes; ++i) compare(before.volumes[i].eyeFromData, now.volumes[i].eyeFromData);
}

std::optional<glm::dmat4> Movement::shared() const {
  std::ptrdiff_t most = 0;
  const glm::dmat4* found = nullptr;
  for (const glm::dmat4& candidate : moved_) {
    const auto votes =
        std::count_if(moved_.begin(), moved_.end(), [&](const auto& m) { return areNear(candidate, m); });
    if (votes > most) most = votes, found = &candidate;
  }
  return found ? std::optional(*found) : std::nullopt;
}

bool isStill(const scene::Snapshot& before, const scene::Snapshot& now) {
  return std::equal(before.instances.begin(), before.instances.end(), now.instances.begin(),
                    now.instances.end(),
                    [](const auto& a, const auto& b) { return a.eyeFromObject == b.eyeFromObject; }) &&
         std::equal(before.volumes.begin(), before.volumes.end(), now.volumes.begin(), now.volumes.end(),
                    [](const auto& a, const auto& b) { return a.eyeFromData == b.eyeFromData; });
}

}  // namespace gluray::gl
