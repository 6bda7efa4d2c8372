#include "render/fxaa.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/fxaa.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Luminosity of a row's pixels, in the order of operations that software OpenGLs have: where contrasts are
/// equal the rounding decides.
HWY_ATTR void luminosityOfRow(const uint32_t* pixels, size_t count, float* out) {
  const hn::ScalableTag<float> d;
  const hn::RebindToUnsigned<decltype(d)> du;
  const hn::RebindToSigned<decltype(d)> di;
  const auto byteMask = hn::Set(du, 255u);
  const auto unit = hn::Set(d, 1.0f / 255), r = hn::Set(d, 0.299f), g = hn::Set(d, 0.587f),
             b = hn::Set(d, 0.114f);
  const size_t step = hn::Lanes(d);
  size_t i = 0;
  for (; i + step <= count; i += step) {
    const auto p = hn::LoadU(du, pixels + i);
    const auto channel = [&](auto v) HWY_ATTR {
      return hn::Mul(hn::ConvertTo(d, hn::BitCast(di, hn::And(v, byteMask))), unit);
    };
    const auto sum = hn::Add(
        hn::Add(hn::Mul(channel(hn::ShiftRight<16>(p)), b), hn::Mul(channel(hn::ShiftRight<8>(p)), g)),
        hn::Mul(channel(p), r));
    hn::StoreU(sum, d, out + i);
  }
  for (; i < count; ++i) {
    const uint32_t p = pixels[i];
    const auto channel = [](uint32_t v) { return static_cast<float>(v & 255) * (1.0f / 255); };
    out[i] = (channel(p >> 16) * 0.114f + channel(p >> 8) * 0.587f) + channel(p) * 0.299f;
  }
}

/// A row's luminosity and that of the rows below and above.
struct Rows {
  const float *below, *row, *above;
  size_t width;
};

/// Collects the columns in [from, to) whose contrast to the four neighbours reaches the thresholds. `columns`
/// has room for a vector more than those. Returns how many.
HWY_ATTR size_t columnsOfContrast(const scene::Fxaa& settings, const Rows& rows, size_t from, size_t to,
                                  int32_t* columns) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  const size_t step = hn::Lanes(d);
  size_t found = 0;
  for (size_t i = from; i < to;) {
    if (i > 0 && i + step <= to && i + step < rows.width) {
      const auto c = hn::LoadU(d, rows.row + i), n = hn::LoadU(d, rows.below + i),
                 s = hn::LoadU(d, rows.above + i), w = hn::LoadU(d, rows.row + i - 1),
                 e = hn::LoadU(d, rows.row + i + 1);
      const auto least = hn::Min(c, hn::Min(hn::Min(n, s), hn::Min(w, e)));
      const auto most = hn::Max(c, hn::Max(hn::Max(n, s), hn::Max(w, e)));
      const auto threshold =
          hn::Max(hn::Set(d, settings.hardContrast), hn::Mul(hn::Set(d, settings.relativeContrast), most));
      const auto reached = hn::RebindMask(di, hn::Ge(hn::Sub(most, least), threshold));
      found += hn::CompressStore(hn::Iota(di, static_cast<int32_t>(i)), reached, di, columns + found);
      i += step;
    } else {
      const float neighbours[] = {rows.row[i], rows.below[i], rows.above[i], rows.row[i > 0 ? i - 1 : 0],
                                  rows.row[std::min(i + 1, rows.width - 1)]};
      const auto [least, most] = std::minmax_element(std::begin(neighbours), std::end(neighbours));
      if (*most - *least >= std::max(settings.hardContrast, settings.relativeContrast * *most))
        columns[found++] = static_cast<int32_t>(i);
      ++i;
    }
  }
  return found;
}

/// The filter for as many pixels of a row as a vector has lanes, in the order of operations that the program
/// has. Pixels beyond the border are the nearest within.
class Filter {
 public:
  using D = hn::ScalableTag<float>;
  using Unsigned = hn::RebindToUnsigned<D>;
  using Signed = hn::RebindToSigned<D>;
  using V = hn::Vec<D>;
  using I = hn::Vec<Signed>;
  using M = hn::Mask<D>;

  HWY_ATTR Filter(const scene::Fxaa& settings, const FxaaPicture& picture)
      : settings_(settings), picture_(picture) {}

  /// The new colours of the pixels in these columns.
  HWY_ATTR void run(const int32_t* columns, int row, uint32_t* colors) const {
    const I x = hn::LoadU(di_, columns), y = hn::Set(di_, row), one = hn::Set(di_, 1);
    const I left = hn::Sub(x, one), right = hn::Add(x, one), down = hn::Sub(y, one), up = hn::Add(y, one);
    const V c = luminosity(x, y), n = luminosity(x, down), s = luminosity(x, up), w = luminosity(left, y),
            e = luminosity(right, y);
    const V ns = hn::Add(n, s), we = hn::Add(w, e);
    const V nw = luminosity(left, down), ne = luminosity(right, down), sw = luminosity(left, up),
            se = luminosity(right, up);
    const V vertical = bend({n, c, s}, {hn::Add(nw, ne), we, hn::Add(sw, se)});
    const V horizontal = bend({w, c, e}, {hn::Add(nw, sw), ns, hn::Add(ne, se)});
    const M alongX = hn::Ge(horizontal, vertical);
    const V first = hn::IfThenElse(alongX, n, w), second = hn::IfThenElse(alongX, s, e);
    const M towardsFirst = hn::Ge(hn::AbsDiff(c, first), hn::AbsDiff(c, second));
    Edge edge;
    edge.x = x, edge.y = y, edge.alongX = alongX, edge.own = c;
    edge.across = hn::IfThenElse(towardsFirst, first, second);
    edge.side = hn::IfThenElse(hn::RebindMask(di_, towardsFirst), hn::Set(di_, -1), one);
    const auto here = hn::GatherIndex(du_, picture_.pixels, index(x, y));
    Color color = alongEdge(edge, here);

    const V least = hn::Min(c, hn::Min(hn::Min(n, s), hn::Min(w, e)));
    const V most = hn::Max(c, hn::Max(hn::Max(n, s), hn::Max(w, e)));
    const V blend = subpixelBlend(c, hn::Add(ns, we), hn::Sub(most, least));
    const M blends = hn::Gt(blend, hn::Zero(d_));
    if (!hn::AllFalse(d_, blends)) {
      const Color around = mean3x3(x, y);
      for (int i = 0; i < 3; ++i)
        color.channel[i] =
            hn::IfThenElse(blends, mix(color.channel[i], around.channel[i], blend), color.channel[i]);
    }
    auto packed = hn::And(here, hn::Set(du_, 0xFF000000u));
    packed = hn::Or(packed, byteOf(color.channel[0]));
    packed = hn::Or(packed, hn::ShiftLeft<8>(byteOf(color.channel[1])));
    packed = hn::Or(packed, hn::ShiftLeft<16>(byteOf(color.channel[2])));
    hn::StoreU(packed, du_, colors);
  }

 private:
  struct Three {
    V before, middle, after;
  };
  struct Color {
    V channel[3];
  };
  /// Where an edge runs beside pixels: along x or along y, and on which side (-1, 1) across.
  struct Edge {
    I x, y, side;
    M alongX;
    V own, across;  // luminosity of the pixel, and across the edge
  };
  /// Where an edge ends in one direction: pixels away, and the luminosity there on the pixel's side.
  struct End {
    V distance, luminosity;
  };

  HWY_ATTR I index(I x, I y) const {
    const I zero = hn::Zero(di_);
    x = hn::Min(hn::Max(x, zero), hn::Set(di_, picture_.width - 1));
    y = hn::Min(hn::Max(y, zero), hn::Set(di_, picture_.height - 1));
    return hn::Add(hn::Mul(y, hn::Set(di_, picture_.width)), x);
  }
  HWY_ATTR V luminosity(I x, I y) const { return hn::GatherIndex(d_, picture_.luminosity, index(x, y)); }
  HWY_ATTR Color rgb(hn::Vec<Unsigned> pixels) const {
    const auto channel = [&](hn::Vec<Unsigned> v) HWY_ATTR {
      const auto byte = hn::BitCast(di_, hn::And(v, hn::Set(du_, 255u)));
      return hn::Mul(hn::ConvertTo(d_, byte), hn::Set(d_, 1.0f / 255));
    };
    return {{channel(pixels), channel(hn::ShiftRight<8>(pixels)), channel(hn::ShiftRight<16>(pixels))}};
  }
  HWY_ATTR static V mix(V a, V b, V part) {
    return hn::Add(hn::Mul(a, hn::Sub(hn::Set(D(), 1), part)), hn::Mul(b, part));
  }
  /// 0 .. 1 as a byte: to the nearest, halves upwards.
  HWY_ATTR hn::Vec<Unsigned> byteOf(V value) const {
    const V v = hn::Mul(hn::Min(hn::Max(value, hn::Zero(d_)), hn::Set(d_, 1)), hn::Set(d_, 255));
    const I whole = hn::ConvertTo(di_, v);
    const auto up = hn::RebindMask(di_, hn::Ge(hn::Sub(v, hn::ConvertTo(d_, whole)), hn::Set(d_, 0.5f)));
    return hn::BitCast(du_, hn::Add(whole, hn::IfThenElseZero(up, hn::Set(di_, 1))));
  }

  /// How much the luminosity bends across three rows or columns: twice each, from the sum of its neighbours.
  HWY_ATTR V bend(const Three& of, const Three& beside) const {
    const V twice = hn::Set(d_, 2);
    const V middle = hn::AbsDiff(beside.middle, hn::Mul(twice, of.middle));
    const V sum =
        hn::Add(hn::Add(hn::Mul(twice, middle), hn::AbsDiff(beside.before, hn::Mul(twice, of.before))),
                hn::AbsDiff(beside.after, hn::Mul(twice, of.after)));
    return hn::Div(sum, hn::Set(d_, 12));
  }
  HWY_ATTR V subpixelBlend(V c, V neighbours, V range) const {
    const V contrast = hn::Div(hn::AbsDiff(hn::Mul(hn::Set(d_, 0.25f), neighbours), c), range);
    const V blend = hn::Max(hn::Zero(d_), hn::Sub(contrast, hn::Set(d_, settings_.subpixelContrast)));
    const V steeper = hn::Mul(blend, hn::Set(d_, 1 / (1 - settings_.subpixelContrast)));
    return hn::Min(hn::Set(d_, settings_.subpixelBlendLimit), steeper);
  }
  HWY_ATTR Color mean3x3(I x, I y) const {
    Color sum = {{hn::Zero(d_), hn::Zero(d_), hn::Zero(d_)}};
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const I at = index(hn::Add(x, hn::Set(di_, dx)), hn::Add(y, hn::Set(di_, dy)));
        const Color one = rgb(hn::GatherIndex(du_, picture_.pixels, at));
        for (int i = 0; i < 3; ++i) sum.channel[i] = hn::Add(sum.channel[i], one.channel[i]);
      }
    for (V& channel : sum.channel) channel = hn::Mul(channel, hn::Set(d_, 1.0f / 9));
    return sum;
  }

  HWY_ATTR End follow(const Edge& edge, int direction) const {
    const auto alongX = hn::RebindMask(di_, edge.alongX);
    const I step = hn::Set(di_, direction);
    const I dx = hn::IfThenElseZero(alongX, step), dy = hn::IfThenZeroElse(alongX, step);
    const I sideX = hn::IfThenZeroElse(alongX, edge.side), sideY = hn::IfThenElseZero(alongX, edge.side);
    End end = {hn::Set(d_, 1), hn::Zero(d_)};
    M goesOn = hn::Eq(end.distance, end.distance);
    I x = edge.x, y = edge.y;
    for (int i = 0; i < settings_.endpointSearchIterations; ++i) {
      x = hn::Add(x, dx), y = hn::Add(y, dy);
      const V own = luminosity(x, y), there = luminosity(hn::Add(x, sideX), hn::Add(y, sideY));
      end.luminosity = hn::IfThenElse(goesOn, own, end.luminosity);
      const M ends = hn::Or(hn::Gt(hn::AbsDiff(there, edge.across), hn::AbsDiff(there, edge.own)),
                            hn::Gt(hn::AbsDiff(own, edge.own), hn::AbsDiff(own, edge.across)));
      goesOn = hn::AndNot(ends, goesOn);
      if (hn::AllFalse(d_, goesOn)) break;
      end.distance = hn::Add(end.distance, hn::IfThenElseZero(goesOn, hn::Set(d_, 1)));
    }
    return end;
  }

  /// Whether the first of two ends is nearer. The program compares texture coordinates that it came by in
  /// steps; among equal distances the rounding of its floats decides.
  HWY_ATTR M isNearer(const Edge& edge, V before, V after) const {
    const M alongX = edge.alongX, equal = hn::Eq(before, after);
    if (hn::AllFalse(d_, equal)) return hn::Lt(before, after);
    const V step = hn::IfThenElse(alongX, hn::Set(d_, 1.0f / static_cast<float>(picture_.width)),
                                  hn::Set(d_, 1.0f / static_cast<float>(picture_.height)));
    const I at = hn::IfThenElse(hn::RebindMask(di_, alongX), edge.x, edge.y);
    const V place = hn::Mul(hn::Add(hn::ConvertTo(d_, at), hn::Set(d_, 0.5f)), step);
    V n = hn::Sub(place, step), p = hn::Add(place, step);
    for (int i = 1; i < settings_.endpointSearchIterations + 1; ++i) {
      const V more = hn::IfThenElseZero(hn::Lt(hn::Set(d_, static_cast<float>(i)), before), step);
      n = hn::Sub(n, more), p = hn::Add(p, more);
    }
    const M rounded = hn::Lt(hn::Sub(place, n), hn::Sub(p, place));
    return hn::Or(hn::And(equal, rounded), hn::AndNot(equal, hn::Lt(before, after)));
  }

  /// The colours between the pixels and those across the edge.
  HWY_ATTR Color alongEdge(const Edge& edge, hn::Vec<Unsigned> here) const {
    const End n = follow(edge, -1), p = follow(edge, 1);
    const M nIsNearest = isNearer(edge, n.distance, p.distance);
    const V distance = hn::IfThenElse(nIsNearest, n.distance, p.distance);
    const V there = hn::IfThenElse(nIsNearest, n.luminosity, p.luminosity);
    const M crosses = hn::Lt(hn::AbsDiff(there, edge.across), hn::AbsDiff(there, edge.own));
    Color color = rgb(here);
    if (hn::AllFalse(d_, crosses)) return color;
    const V offset = hn::Sub(hn::Set(d_, 0.5f), hn::Div(distance, hn::Add(n.distance, p.distance)));
    const auto alongX = hn::RebindMask(di_, edge.alongX);
    const I x = hn::Add(edge.x, hn::IfThenZeroElse(alongX, edge.side));
    const I y = hn::Add(edge.y, hn::IfThenElseZero(alongX, edge.side));
    const Color across = rgb(hn::GatherIndex(du_, picture_.pixels, index(x, y)));
    for (int i = 0; i < 3; ++i)
      color.channel[i] =
          hn::IfThenElse(crosses, mix(color.channel[i], across.channel[i], offset), color.channel[i]);
    return color;
  }

  static constexpr D d_{};
  static constexpr Unsigned du_{};
  static constexpr Signed di_{};
  const scene::Fxaa& settings_;
  const FxaaPicture& picture_;
};

/// Filters a row into `out`.
HWY_ATTR void filterRow(const scene::Fxaa& settings, const FxaaPicture& picture, int y, uint32_t* out) {
  constexpr size_t kAtOnce = 512, kMostLanes = HWY_MAX_BYTES / sizeof(float);
  const auto width = static_cast<size_t>(picture.width), lanes = hn::Lanes(Filter::D());
  const float* row = picture.luminosity + static_cast<size_t>(y) * width;
  const Rows rows = {y > 0 ? row - width : row, row, y + 1 < picture.height ? row + width : row, width};
  std::copy_n(picture.pixels + static_cast<size_t>(y) * width, width, out);
  const Filter filter(settings, picture);
  int32_t columns[kAtOnce + kMostLanes];
  uint32_t colors[kMostLanes];
  for (size_t from = 0; from < width; from += kAtOnce) {
    const size_t count = columnsOfContrast(settings, rows, from, std::min(from + kAtOnce, width), columns);
    if (count > 0) std::fill_n(columns + count, lanes, columns[count - 1]);  // lanes beyond the last
    for (size_t i = 0; i < count; i += lanes) {
      filter.run(columns + i, y, colors);
      for (size_t lane = 0; lane < std::min(lanes, count - i); ++lane) out[columns[i + lane]] = colors[lane];
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::render {

HWY_EXPORT(luminosityOfRow);
HWY_EXPORT(filterRow);

void fxaa(const scene::Fxaa& settings, const uint32_t* in, int width, int height, uint32_t* out,
          FxaaMemory& memory) {
  const auto w = static_cast<size_t>(width), h = static_cast<size_t>(height);
  if (memory.luminosity.size() < w * h) memory.luminosity.resize(w * h);
  float* luminosity = memory.luminosity.data();
  const FxaaPicture picture = {in, luminosity, width, height};
  constexpr size_t kRows = 16;
  tbb::parallel_for(tbb::blocked_range<size_t>(0, h, kRows), [&](const auto& rows) {
    for (size_t y = rows.begin(); y != rows.end(); ++y)
      HWY_DYNAMIC_DISPATCH(luminosityOfRow)(in + y * w, w, luminosity + y * w);
  });
  tbb::parallel_for(tbb::blocked_range<size_t>(0, h, kRows), [&](const auto& rows) {
    for (size_t y = rows.begin(); y != rows.end(); ++y)
      HWY_DYNAMIC_DISPATCH(filterRow)(settings, picture, static_cast<int>(y), out + y * w);
  });
}

}  // namespace gluray::render
#endif
