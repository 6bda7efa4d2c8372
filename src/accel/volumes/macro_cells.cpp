#include "accel/volumes/macro_cells.h"

#include "parallel/arena.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace gluray::accel {
namespace {

using scene::VoxelGrid;

template <class Stored>
class Scan {
 public:
  Scan(const VoxelGrid& grid, int channel, const glm::ivec3& cells)
      : grid_(grid),
        values_(reinterpret_cast<const Stored*>(grid.channel(channel))),
        cells_(cells),
        divisor_(scene::divisorOf(grid.type)) {}

  /// False: a value is not finite; then the range is everything.
  bool rangeOf(const glm::ivec3& cell, MacroCells::Range& range) const {
    const glm::ivec3 first = cell * MacroCells::kSide,
                     last = glm::min(first + MacroCells::kSide, grid_.size - 1);
    constexpr float kMost = std::numeric_limits<float>::infinity();
    float least = kMost, most = -kMost;
    bool numbers = true;
    for (int z = first.z; z <= last.z; ++z)
      for (int y = first.y; y <= last.y; ++y) {
        const size_t row =
            (static_cast<size_t>(z) * static_cast<size_t>(grid_.size.y) + static_cast<size_t>(y)) *
            static_cast<size_t>(grid_.size.x);
        for (int x = first.x; x <= last.x; ++x) {
          const float v = static_cast<float>(values_[row + static_cast<size_t>(x)]);
          least = std::min(least, v), most = std::max(most, v);
          numbers &= v - v == 0;
        }
      }
    const bool isSigned =
        grid_.type == VoxelGrid::Type::signedByte || grid_.type == VoxelGrid::Type::signedWord;
    const auto valueOf = [&](float v) { return isSigned ? std::max(v / divisor_, -1.0f) : v / divisor_; };
    range = numbers ? MacroCells::Range{valueOf(least), valueOf(most)} : MacroCells::Range{-kMost, kMost};
    return numbers;
  }

  bool all(std::vector<MacroCells::Range>& ranges) const {
    std::atomic<bool> finite{true};
    sharedArena()->execute([&] {
      tbb::parallel_for(0, cells_.y * cells_.z, [&](int row) {
        const int y = row % cells_.y, z = row / cells_.y;
        for (int x = 0; x < cells_.x; ++x)
          if (!rangeOf(
                  {x, y, z},
                  ranges[static_cast<size_t>(row) * static_cast<size_t>(cells_.x) + static_cast<size_t>(x)]))
            finite.store(false, std::memory_order_relaxed);
      });
    });
    return finite;
  }

 private:
  const VoxelGrid& grid_;
  const Stored* values_;
  const glm::ivec3& cells_;
  float divisor_;
};

}  // namespace

MacroCells::MacroCells(const VoxelGrid& grid, int channel) : size_(glm::max((grid.size - 2) / kSide, 0) + 1) {
  ranges_.resize(static_cast<size_t>(size_.x) * static_cast<size_t>(size_.y) * static_cast<size_t>(size_.z));
  switch (grid.type) {
    case VoxelGrid::Type::byte: finite_ = Scan<uint8_t>(grid, channel, size_).all(ranges_); break;
    case VoxelGrid::Type::signedByte: finite_ = Scan<int8_t>(grid, channel, size_).all(ranges_); break;
    case VoxelGrid::Type::word: finite_ = Scan<uint16_t>(grid, channel, size_).all(ranges_); break;
    case VoxelGrid::Type::signedWord: finite_ = Scan<int16_t>(grid, channel, size_).all(ranges_); break;
    case VoxelGrid::Type::single: finite_ = Scan<float>(grid, channel, size_).all(ranges_); break;
  }
}

}  // namespace gluray::accel
