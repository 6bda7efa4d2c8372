#include "cluster/peers/tile_depths.h"

#include "cluster/stream/byte_stream.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace gluray::cluster {
namespace {

using render::kTileSize;
using render::Tile;

constexpr int kNothing = 0xFFFF, kMost = kNothing - 1;  // steps
constexpr size_t kSide = kTileSize;
using Steps = std::array<uint16_t, kSide * kSide>;  // rows of kSide; kNothing: no surface, or too far away

/// From the depths of a part to steps, and back.
class Scale {
 public:
  explicit Scale(const render::DrawnPart& part)
      : nearest_(part.nearest), step_((part.farthest - part.nearest) / kMost) {}
  float depthOf(int steps) const { return nearest_ + static_cast<float>(steps) * step_; }
  /// The first step that is not before the depth.
  int stepOf(float depth) const {
    if (!(depth <= depthOf(kMost))) return kNothing;
    if (!(step_ > 0)) return kMost;
    int steps = std::max(static_cast<int>(std::ceil((depth - nearest_) / step_)), 0);
    while (steps < kMost && depthOf(steps) < depth) ++steps;
    return steps > kMost || depthOf(steps) < depth ? kNothing : steps;
  }

 private:
  float nearest_, step_;
};

float keyOf(float depth, bool largestWins) { return largestWins ? 1 - depth : depth; }

/// Calls act(index in Steps, depth) for the pixels of a tile that show surfaces.
template <class Act>
void eachDepth(const Image& image, const Tile& tile, const Act& act) {
  for (int y = tile.y0; y < tile.y1; ++y) {
    const float* const row = image.depth.data() + static_cast<size_t>(y) * static_cast<size_t>(image.width);
    for (int x = tile.x0; x < tile.x1; ++x)
      if (row[x] != Image::kMiss)
        act(static_cast<size_t>(y - tile.y0) * kSide + static_cast<size_t>(x - tile.x0), row[x]);
  }
}

/// What the neighbours before a pixel say about it: planes continue.
int predicted(const Steps& steps, size_t at, int before) {
  const size_t x = at % kSide;
  const int left = x > 0 ? steps[at - 1] : kNothing, below = at >= kSide ? steps[at - kSide] : kNothing;
  const int corner = x > 0 && at >= kSide ? steps[at - kSide - 1] : kNothing;
  if (left == kNothing) return below == kNothing ? before : below;
  if (below == kNothing || corner == kNothing) return left;
  return std::clamp(left + below - corner, 0, kMost);
}

void putNumber(ByteWriter& out, uint32_t value) {
  for (; value > 0x7F; value >>= 7) out.put(static_cast<uint8_t>(value | 0x80));
  out.put(static_cast<uint8_t>(value));
}

uint32_t takeNumber(ByteReader& in) {
  uint32_t value = 0;
  for (int shift = 0; shift < 21; shift += 7) {
    const auto byte = in.get<uint8_t>();
    value |= (byte & 0x7Fu) << shift;
    if (byte < 0x80) return value;
  }
  throw Malformed("a depth is too large");
}

enum Row : uint8_t { kNone, kWhole, kSome };  // which pixels of a row show surfaces

void putRow(ByteWriter& out, uint32_t shown) {
  const Row row = shown == 0 ? kNone : shown == ~0u ? kWhole : kSome;
  out.put(static_cast<uint8_t>(row));
  if (row == kSome) out.put(shown);
}

uint32_t takeRow(ByteReader& in) {
  switch (in.get<uint8_t>()) {
    case kNone: return 0;
    case kWhole: return ~0u;
    case kSome: return in.get<uint32_t>();
    default: throw Malformed("a row of depths has no form");
  }
}

uint32_t shownIn(const Steps& steps, size_t row) {
  uint32_t shown = 0;
  for (size_t x = 0; x < kSide; ++x) shown |= uint32_t{steps[row * kSide + x] != kNothing} << x;
  return shown;
}

Steps unpacked(std::span<const std::byte> packed) {
  Steps steps;
  steps.fill(kNothing);
  ByteReader in(packed);
  int before = 0;
  for (size_t row = 0; row < kSide && in.left() > 0; ++row) {
    for (uint32_t left = takeRow(in); left; left &= left - 1) {
      const size_t at = row * kSide + static_cast<size_t>(std::countr_zero(left));
      const uint32_t number = takeNumber(in);
      const int off = static_cast<int>(number >> 1) ^ -static_cast<int>(number & 1);
      const int value = predicted(steps, at, before) + off;
      if (value < 0 || value > kMost) throw Malformed("a depth is out of range");
      steps[at] = static_cast<uint16_t>(before = value);
    }
  }
  if (in.left() > 0) throw Malformed("a tile of depths is too long");
  return steps;
}

}  // namespace

std::vector<std::byte> packDepths(const Image& image, const Tile& tile, const render::DrawnPart& part,
                                  bool largestWins) {
  const Scale scale(part);
  Steps steps;
  steps.fill(kNothing);
  eachDepth(image, tile, [&](size_t at, float depth) {
    steps[at] = static_cast<uint16_t>(scale.stepOf(keyOf(depth, largestWins)));
  });
  ByteWriter out;
  size_t rows = kSide;  // without the empty ones at the end
  while (rows > 0 && shownIn(steps, rows - 1) == 0) --rows;
  int before = 0;
  for (size_t row = 0; row < rows; ++row) {
    const uint32_t shown = shownIn(steps, row);
    putRow(out, shown);
    for (uint32_t left = shown; left; left &= left - 1) {
      const size_t at = row * kSide + static_cast<size_t>(std::countr_zero(left));
      const int off = steps[at] - predicted(steps, at, before);
      putNumber(out, static_cast<uint32_t>(off < 0 ? 2 * -off - 1 : 2 * off));
      before = steps[at];
    }
  }
  return out.takeBytes();
}

void addHidden(std::span<const std::byte> packed, const render::DrawnPart& part, const Image& image,
               const Tile& tile, bool largestWins, float step, render::HiddenPixels& hidden) {
  if (packed.empty()) return;
  const Steps steps = unpacked(packed);
  const Scale scale(part);
  eachDepth(image, tile, [&](size_t at, float depth) {
    if (steps[at] != kNothing && scale.depthOf(steps[at]) + step < keyOf(depth, largestWins))
      hidden.hide(static_cast<int>(at % kSide), static_cast<int>(at / kSide));
  });
}

}  // namespace gluray::cluster
