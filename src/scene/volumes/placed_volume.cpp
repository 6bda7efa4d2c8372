#include "scene/volumes/placed_volume.h"

#include <algorithm>

namespace gluray::scene {
namespace {

template <class T>
bool alike(const std::shared_ptr<const T>& a, const std::shared_ptr<const T>& b) {
  return a == b || (a && b && *a == *b);
}

bool alike(const VolumeChannel& a, const VolumeChannel& b) {
  return a.scale == b.scale && a.bias == b.bias && a.range == b.range && a.opacity == b.opacity &&
         alike(a.gradientOpacity, b.gradientOpacity) && a.weight == b.weight;
}

bool alike(const std::optional<VolumeClipping>& a, const std::optional<VolumeClipping>& b) {
  if (!a || !b) return !a && !b;
  return a->planes == b->planes && a->spaceFromTexture == b->spaceFromTexture;
}

bool alike(const Volume& a, const Volume& b) {
  const auto sameChannel = [](const VolumeChannel& x, const VolumeChannel& y) { return alike(x, y); };
  return a.grid == b.grid && a.linear == b.linear && a.use == b.use &&
         std::equal(a.channels.begin(), a.channels.end(), b.channels.begin(), b.channels.end(),
                    sameChannel) &&
         a.labels.voxels == b.labels.voxels && a.labels.rows == b.labels.rows &&
         a.labels.share == b.labels.share && alike(a.table, b.table) &&
         a.gradientChannel == b.gradientChannel && a.cellStep == b.cellStep &&
         a.cellSpacing == b.cellSpacing && alike(a.cropping, b.cropping) && a.mask == b.mask &&
         a.maskLinear == b.maskLinear;
}

}  // namespace

bool blockAlike(const Medium& a, const Medium& b) {
  return a.textureFromData == b.textureFromData && a.step == b.step && a.lower == b.lower &&
         a.upper == b.upper && alike(a.clipping, b.clipping) && alike(a.volume, b.volume);
}

bool PlacedVolume::operator==(const PlacedVolume& other) const {
  return eyeFromData == other.eyeFromData &&
         (medium == other.medium || (medium && other.medium && blockAlike(*medium, *other.medium)));
}

}  // namespace gluray::scene
