#include "render/volumes/visible_cells.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

constexpr uint8_t kFar = 255;

/// Makes distances to the nearest 0 of distances that are 0 or kFar: a sweep forward and one back, in which a
/// cell is at most one farther away than each neighbour that the sweep has visited.
class DistanceSweeps {
 public:
  DistanceSweeps(std::vector<uint8_t>& distances, const glm::ivec3& size)
      : distances_(distances), size_(size) {
    for (int z = 0; z < size_.z; ++z)
      for (int y = 0; y < size_.y; ++y)
        for (int x = 0; x < size_.x; ++x) visit({x, y, z}, -1);
    for (int z = size_.z - 1; z >= 0; --z)
      for (int y = size_.y - 1; y >= 0; --y)
        for (int x = size_.x - 1; x >= 0; --x) visit({x, y, z}, 1);
  }

 private:
  uint8_t& at(const glm::ivec3& cell) {
    const size_t row =
        static_cast<size_t>(cell.z) * static_cast<size_t>(size_.y) + static_cast<size_t>(cell.y);
    return distances_[row * static_cast<size_t>(size_.x) + static_cast<size_t>(cell.x)];
  }
  void meet(uint8_t& own, const glm::ivec3& neighbour) {
    if (glm::any(glm::lessThan(neighbour, glm::ivec3(0))) ||
        glm::any(glm::greaterThanEqual(neighbour, size_)))
      return;
    own = static_cast<uint8_t>(std::min<int>(own, at(neighbour) + 1));
  }
  void visit(const glm::ivec3& cell, int side) {
    uint8_t& own = at(cell);
    if (own == 0) return;
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) meet(own, cell + glm::ivec3(x, y, side));
    for (int x = -1; x <= 1; ++x) meet(own, cell + glm::ivec3(x, side, 0));
    meet(own, cell + glm::ivec3(side, 0, 0));
  }

  std::vector<uint8_t>& distances_;
  const glm::ivec3 size_;
};

}  // namespace

NonzeroRanges::NonzeroRanges(const scene::VolumeTable& table) {
  before_.assign(table.values.size() + 1, 0);
  for (size_t i = 0; i < table.values.size(); ++i) before_[i + 1] = before_[i] + (table.values[i] != 0);
}

bool NonzeroRanges::any(float least, float most) const {
  const auto entries = static_cast<float>(before_.size() - 1);
  if (!(entries > 0)) return false;
  // With a margin of one entry, for rounding.
  const auto entryAt = [&](float v, float more) {
    return static_cast<size_t>(std::clamp(std::floor(v * entries - 0.5f) + more, 0.0f, entries - 1));
  };
  const size_t first = entryAt(std::isnan(least) ? 0 : least, -1),
               last = entryAt(std::isnan(most) ? 1 : most, 2);
  return before_[last + 1] > before_[first];
}

namespace {

/// The largest opacity of each column: of a scalar with any gradient or label.
scene::VolumeTable opacitiesOf(const scene::VolumeTable2D& table) {
  scene::VolumeTable most;
  most.values.assign(static_cast<size_t>(table.size.x), 0.0f);
  for (size_t i = 0; i < table.values.size(); ++i) {
    float& opacity = most.values[i % most.values.size()];
    opacity = std::max(opacity, table.values[i].a);
  }
  return most;
}

/// Marks cells in which samples of a channel can be seen by 0.
void markVisible(const accel::MacroCells& cells, const scene::VolumeChannel& channel,
                 const NonzeroRanges& opaque, std::vector<uint8_t>& distances) {
  for (size_t i = 0; i < distances.size(); ++i) {
    const accel::MacroCells::Range& range = cells.ranges()[i];
    const float a = range.least * channel.scale + channel.bias, b = range.most * channel.scale + channel.bias;
    if (opaque.any(std::min(a, b), std::max(a, b))) distances[i] = 0;
  }
}

}  // namespace

std::vector<uint8_t> emptySpace(const std::vector<accel::MacroCells>& cells, const scene::Volume& volume) {
  std::vector<uint8_t> distances(cells.front().ranges().size(), kFar);
  const bool each = volume.use == scene::VolumeChannels::independent;
  for (size_t c = 0; c < volume.channels.size(); ++c) {
    const scene::VolumeChannel& channel = volume.channels[c];
    using Use = scene::VolumeChannels;
    if (volume.use == Use::table || volume.use == Use::labels)
      markVisible(cells[c], channel, NonzeroRanges(opacitiesOf(*volume.table)), distances);
    if (volume.use != Use::table && (each || c == scene::opacityChannelOf(volume.use)))
      markVisible(cells[c], channel, NonzeroRanges(channel.opacity), distances);
  }
  DistanceSweeps(distances, cells.front().size());
  return distances;
}

}  // namespace gluray::render
