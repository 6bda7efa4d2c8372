// The edge-stopping filter of visibility. Compiled once for each instruction set.
#if defined(GLURAY_RENDER_FILTER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_FILTER_INL_H_
#undef GLURAY_RENDER_FILTER_INL_H_
#else
#define GLURAY_RENDER_FILTER_INL_H_
#endif

#include "render/moving/filter.h"
#include "render/moving/visibility_pixels.inl.h"
#include "render/tiles/tile.h"

#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

constexpr int kReach = 4, kNarrow = 2;                 // pixels about one that count: at most; usually
constexpr int kUnpackedRows = kTileSize + 2 * kReach;  // of a tile with its surroundings
constexpr int kPadded = kTileSize + kLanes;  // columns: whole vectors about any pixel's surroundings
// Weights by distance: both kinds see each of the 4 x 4 directions of a packet equally often.
constexpr float kNarrowWeights[] = {1, 1, 0.5f, 0, 0}, kWideWeights[] = {1, 1, 1, 1, 0.5f};
constexpr float kFewSamples = 8;  // pixels with so few are smoothed over more of their neighbours

using UnpackedRow = float[kPadded];

/// A tile's part of the buffer, unpacked; pixel (x, y) of the tile is at [y + kReach][x + kReach].
struct UnpackedTile {
  alignas(64) UnpackedRow depth[kUnpackedRows], samples[kUnpackedRows], x[kUnpackedRows], y[kUnpackedRows],
      z[kUnpackedRows];
  alignas(64) UnpackedRow visibility[2][kUnpackedRows];
  bool shows = false;  // anything
};

HWY_ATTR inline void unpackTile(const VisibilityBuffer& buffer, const Tile& tile, UnpackedTile& out) {
  const WordTag d;
  const int left = tile.x0 - kReach, from = std::max(left, 0),
            to = std::min(left + kUnpackedRows, buffer.width);
  Words any = hn::Zero(d);
  alignas(64) uint32_t words[2 * kPadded] = {};
  for (int row = 0; row < kUnpackedRows; ++row) {
    const int y = tile.y0 - kReach + row;
    if (y >= 0 && y < buffer.height) {
      const size_t first =
          static_cast<size_t>(y) * static_cast<size_t>(buffer.width) + static_cast<size_t>(from);
      std::memcpy(words + 2 * (from - left), buffer.words.data() + 2 * first,
                  8 * static_cast<size_t>(to - from));
    } else {
      std::memset(words, 0, sizeof words);
    }
    for (int x = 0; x < kPadded; x += lanesOfVector()) {
      Words word0, word1;
      hn::LoadInterleaved2(d, words + 2 * x, word0, word1);
      any = hn::Or(any, word1);
      const VisibilityPixels p = VisibilityPixels::unpacked(word0, word1);
      store(p.depth, out.depth[row] + x), store(p.samples, out.samples[row] + x);
      store(p.normal.x, out.x[row] + x), store(p.normal.y, out.y[row] + x), store(p.normal.z, out.z[row] + x);
      store(p.first, out.visibility[0][row] + x), store(p.second, out.visibility[1][row] + x);
    }
  }
  out.shows = !hn::AllTrue(d, hn::Eq(any, hn::Zero(d)));
}

HWY_ATTR inline void unpackMore(const VisibilityBuffer& buffer, const Tile& tile, int channel,
                                UnpackedTile& out) {
  const std::vector<uint16_t>& plane = buffer.more[static_cast<size_t>(channel - 2)];
  const int left = tile.x0 - kReach, from = std::max(left, 0),
            to = std::min(left + kUnpackedRows, buffer.width);
  for (int row = 0; row < kUnpackedRows; ++row) {
    const int y = tile.y0 - kReach + row;
    if (y < 0 || y >= buffer.height) continue;  // has no samples
    const uint16_t* in = plane.data() + static_cast<size_t>(y) * static_cast<size_t>(buffer.width);
    for (int x = from; x < to; ++x)
      out.visibility[0][row][x - left] = static_cast<float>(in[x]) * (1 / VisibilityBuffer::kLargestMore);
  }
}

HWY_INLINE Float loadAt(const float* p) { return hn::LoadU(FloatTag(), p); }

/// A pixel's point, and the plane on which its neighbours must lie.
struct Center {
  Float depth, reach;  // reach: of the plane, eye space
  Float3 normal;
  Float alongRay;  // dot(normal, ray)
};

HWY_ATTR inline Center centerAt(const PixelSpace& space, const UnpackedTile& tile, int x0, int y0, int row,
                                int x) {
  constexpr float kOnPlane = 0.5f;  // pixels
  Center c;
  c.depth = loadAt(tile.depth[row] + x);
  c.normal = {loadAt(tile.x[row] + x), loadAt(tile.y[row] + x), loadAt(tile.z[row] + x)};
  const Float column = hn::Add(hn::ConvertTo(FloatTag(), hn::Iota(IntTag(), x0 + x - kReach)), splat(0));
  const glm::vec3 rowRay = space.ray + static_cast<float>(y0 + row - kReach) * space.rayY;
  c.alongRay = dot(c.normal, add(splat(rowRay), scaled(splat(space.rayX), column)));
  c.reach = hn::Mul(splat(kOnPlane), hn::MulAdd(c.depth, splat(space.perDepth), splat(space.pixel)));
  return c;
}

/// 1 where the pixels `step` columns or rows away show the same surface, else 0. `base`, `ray`: change of
/// PixelSpace's for one column or row.
HWY_ATTR inline Float sameSurface(const Center& c, const UnpackedTile& tile, int row, int x, float step,
                                  const glm::vec3& base, const glm::vec3& ray) {
  constexpr float kSameNormal = 0.8f;  // cosine
  const Float depth = loadAt(tile.depth[row] + x);
  const Float3 normal{loadAt(tile.x[row] + x), loadAt(tile.y[row] + x), loadAt(tile.z[row] + x)};
  const Float aside = hn::MulAdd(depth, dot(c.normal, splat(step * ray)), dot(c.normal, splat(step * base)));
  const Float off = hn::MulAdd(hn::Sub(depth, c.depth), c.alongRay, aside);
  const auto same = hn::And(hn::Le(hn::Abs(off), c.reach), hn::Gt(dot(normal, c.normal), splat(kSameNormal)));
  return hn::IfThenElseZero(same, splat(1));
}

/// Samples of pixels, of which at most `most` count.
HWY_INLINE Float samplesAt(const UnpackedTile& tile, int row, int x, float most) {
  return hn::Min(loadAt(tile.samples[row] + x), splat(most));
}

/// Sums over the pixels of rows.
struct Sums {
  alignas(64) float weight[kUnpackedRows][kTileSize], value[kUnpackedRows][kTileSize],
      square[kUnpackedRows][kTileSize];
};
/// Which pixels of rows and columns show the same surface as the middle one.
struct Sides {
  // Bit t: tap t counts; the middle one always does, and has none.
  alignas(64) uint8_t rows[kUnpackedRows][kTileSize], columns[kTileSize][kTileSize];
  int least = 0;  // of the four nearest: so many must count where pixels farther away do
  float most = VisibilityBuffer::kMaxSamples;  // samples of a pixel of the channel that knows least
};

/// The bit of a tap, 0 .. 2 * kReach.
constexpr int bitOf(int tap) { return 1 << (tap < kReach ? tap : tap - 1); }

HWY_ATTR inline void storeBits(Ints bits, uint8_t* to) {
  const hn::Rebind<uint8_t, IntTag> bytes;
  hn::StoreU(hn::DemoteTo(bytes, bits), bytes, to);
}
using FloatMask = hn::Mask<FloatTag>;

/// Pixels that are smoothed over more of their neighbours: those of few samples.
HWY_INLINE FloatMask isWide(Float samples) { return hn::Le(samples, splat(kFewSamples)); }
/// The same, if `bits` say that `least` of the four nearest neighbours in a line show the same surface.
HWY_INLINE FloatMask isWide(Float samples, Ints bits, int least) {
  const auto one = hn::Set(IntTag(), 1);
  Ints count = hn::Zero(IntTag());
  count = hn::Add(count, hn::And(hn::ShiftRight<2>(bits), one));
  count = hn::Add(count, hn::And(hn::ShiftRight<3>(bits), one));
  count = hn::Add(count, hn::And(hn::ShiftRight<4>(bits), one));
  count = hn::Add(count, hn::And(hn::ShiftRight<5>(bits), one));
  const auto enough = hn::Gt(count, hn::Set(IntTag(), least - 1));
  return hn::And(isWide(samples), hn::RebindMask(FloatTag(), enough));
}
static_assert(bitOf(kReach - 2) == 1 << 2 && bitOf(kReach + 2) == 1 << 5);

HWY_INLINE Float weightOf(Ints bits, FloatMask wide, int tap) {
  const int distance = tap < kReach ? kReach - tap : tap - kReach;
  const Float weight = hn::IfThenElse(wide, splat(kWideWeights[distance]), splat(kNarrowWeights[distance]));
  if (distance == 0) return weight;
  const auto counts = hn::TestBit(bits, hn::Set(IntTag(), bitOf(tap)));
  return hn::IfThenElseZero(hn::RebindMask(FloatTag(), counts), weight);
}

/// The taps that may count where some pixel is wide or none is.
struct TapRange {
  int first, last;
  HWY_INLINE explicit TapRange(FloatMask wide) {
    const int reach = hn::AllFalse(FloatTag(), wide) ? kNarrow : kReach;
    first = kReach - reach, last = kReach + reach;
  }
};
HWY_ATTR inline Ints loadBits(const uint8_t* from) {
  const hn::Rebind<uint8_t, IntTag> bytes;
  return hn::PromoteTo(IntTag(), hn::LoadU(bytes, from));
}

HWY_ATTR inline void findSides(const PixelSpace& space, const UnpackedTile& tile, const Tile& at,
                               Sides& sides) {
  const IntTag d;
  const auto bit = [&](Float same, int tap) HWY_ATTR {
    const auto counts = hn::RebindMask(d, hn::Ne(same, hn::Zero(FloatTag())));
    return hn::IfThenElseZero(counts, hn::Set(d, bitOf(tap)));
  };
  for (int row = 0; row < kUnpackedRows; ++row) {
    for (int x = 0; x < kTileSize; x += lanesOfVector()) {
      const Center c = centerAt(space, tile, at.x0, at.y0, row, x + kReach);
      Ints rows = hn::Zero(d), columns = rows;
      const bool inside = row >= kReach && row < kUnpackedRows - kReach;
      const TapRange taps(isWide(samplesAt(tile, row, x + kReach, sides.most)));
      for (int tap = taps.first; tap <= taps.last; ++tap) {
        if (tap == kReach) continue;
        const int step = tap - kReach;
        const auto fstep = static_cast<float>(step);
        rows = hn::Or(rows,
                      bit(sameSurface(c, tile, row, x + kReach + step, fstep, space.baseX, space.rayX), tap));
        if (inside)
          columns =
              hn::Or(columns,
                     bit(sameSurface(c, tile, row + step, x + kReach, fstep, space.baseY, space.rayY), tap));
      }
      storeBits(rows, sides.rows[row] + x);
      if (inside) storeBits(columns, sides.columns[row - kReach] + x);
    }
  }
}

HWY_ATTR inline void sumRows(const UnpackedTile& tile, const UnpackedRow* visibility, const Sides& sides,
                             float most, Sums& out) {
  const FloatTag d;
  for (int row = 0; row < kUnpackedRows; ++row) {
    for (int x = 0; x < kTileSize; x += lanesOfVector()) {
      const Ints bits = loadBits(sides.rows[row] + x);
      const FloatMask wide = isWide(samplesAt(tile, row, x + kReach, most), bits, sides.least);
      const TapRange taps(wide);
      Float weight = hn::Zero(d), value = weight, square = weight;
      for (int tap = taps.first; tap <= taps.last; ++tap) {
        const Float f = loadAt(visibility[row] + x + tap);
        const Float w = hn::Mul(weightOf(bits, wide, tap), samplesAt(tile, row, x + tap, most));
        weight = hn::Add(weight, w), value = hn::MulAdd(w, f, value),
        square = hn::MulAdd(hn::Mul(w, f), f, square);
      }
      store(weight, out.weight[row] + x), store(value, out.value[row] + x),
          store(square, out.square[row] + x);
    }
  }
}

/// The mean where neighbours are alike but for noise, the pixel's own value where they differ.
HWY_INLINE Float balanced(Float own, Float samples, Float mean, Float meanSquare) {
  // A sample is 0 or 1, or between: its variance is at most mean * (1 - mean).
  const Float noise = hn::Div(hn::Mul(mean, hn::Sub(splat(1), mean)), hn::Max(samples, splat(1)));
  const Float spread = hn::NegMulAdd(mean, mean, meanSquare);
  const Float real = hn::Max(hn::NegMulAdd(splat(2), noise, spread), hn::Zero(FloatTag()));
  const Float share = hn::Div(real, hn::Add(hn::Add(real, noise), splat(1e-6f)));
  return hn::MulAdd(share, hn::Sub(own, mean), mean);
}

HWY_ATTR inline void sumColumns(const UnpackedTile& tile, const UnpackedRow* visibility, const Sides& sides,
                                float most, const Sums& sums, int row, Float* out, int x) {
  const FloatTag d;
  const Ints bits = loadBits(sides.columns[row] + x);
  const Float samples = samplesAt(tile, row + kReach, x + kReach, most);
  const FloatMask wide = isWide(samples, bits, sides.least);
  const TapRange taps(wide);
  Float weight = hn::Zero(d), value = weight, square = weight;
  for (int tap = taps.first; tap <= taps.last; ++tap) {
    const Float w = weightOf(bits, wide, tap);
    weight = hn::MulAdd(w, load(sums.weight[row + tap] + x), weight);
    value = hn::MulAdd(w, load(sums.value[row + tap] + x), value);
    square = hn::MulAdd(w, load(sums.square[row + tap] + x), square);
  }
  const Float inverse = hn::Div(splat(1), hn::Max(weight, splat(1e-3f)));
  const Float own = loadAt(visibility[row + kReach] + x + kReach);
  *out = balanced(own, samples, hn::Mul(value, inverse), hn::Mul(square, inverse));
}

HWY_ATTR inline void filterChannel(const UnpackedTile& tile, const UnpackedRow* visibility,
                                   const Sides& sides, Sums& sums, const MovingFrame& moving, int number,
                                   TileVisibility& out) {
  const float most = moving.mostKnownOf(number);
  sumRows(tile, visibility, sides, most, sums);
  alignas(64) float line[kTileSize];
  for (int row = 0; row < kTileSize; ++row) {
    for (int x = 0; x < kTileSize; x += lanesOfVector()) {
      Float filtered;
      sumColumns(tile, visibility, sides, most, sums, row, &filtered, x);
      store(filtered, line + x);
    }
    // Lanes are in Z order of 2 x 2 quads.
    const int lane = (row & 1) * 2 + (row & 2) * 4;
    for (int x = 0; x < kTileSize; x += 2)
      std::memcpy(moving.channels.rowOf(out.packets[row / 4 * TileVisibility::kColumns + x / 4], number) +
                      lane + (x & 2) * 2,
                  line + x, 8);
  }
}

HWY_ATTR void filterTile(const MovingFrame& moving, const Tile& at, TileVisibility& out) {
  UnpackedTile tile;
  unpackTile(*moving.visibility, at, tile);
  if (!tile.shows) return;
  // Where surfaces are as small as pixels, neighbours farther away show others by chance. That matters less
  // than noise while nothing is known of earlier frames.
  constexpr int kMin = 3;
  Sides sides;
  sides.least = moving.earlier ? kMin : 0;
  for (int f = 0; f < moving.channels.count(); ++f) sides.most = std::min(sides.most, moving.mostKnownOf(f));
  findSides(moving.space, tile, at, sides);
  Sums sums;
  for (int f = 0; f < moving.channels.count(); ++f) {
    if (f >= 2) unpackMore(*moving.visibility, at, f, tile);
    filterChannel(tile, tile.visibility[f == 1], sides, sums, moving, f, out);
  }
  for (Visibility& packet : out.packets) moving.channels.spread(packet);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
