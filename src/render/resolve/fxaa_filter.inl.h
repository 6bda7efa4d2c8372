// The FXAA filter for a vector of pixels. Part of anti_alias.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_FXAA_FILTER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_FXAA_FILTER_INL_H_
#undef GLURAY_RENDER_FXAA_FILTER_INL_H_
#else
#define GLURAY_RENDER_FXAA_FILTER_INL_H_
#endif

#include "render/resolve/fxaa_image.h"
#include "scene/fxaa.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class V>
HWY_INLINE V leastOf(V c, V n, V s, V w, V e) {
  return hn::Min(c, hn::Min(hn::Min(n, s), hn::Min(w, e)));
}
template <class V>
HWY_INLINE V mostOf(V c, V n, V s, V w, V e) {
  return hn::Max(c, hn::Max(hn::Max(n, s), hn::Max(w, e)));
}

/// Filters as many pixels of a row as a vector has lanes, with the program's order of operations. Clamps
/// pixels beyond the border to it.
class Filter {
 public:
  using D = hn::ScalableTag<float>;
  using Unsigned = hn::RebindToUnsigned<D>;
  using Signed = hn::RebindToSigned<D>;
  using V = hn::Vec<D>;
  using I = hn::Vec<Signed>;
  using M = hn::Mask<D>;

  HWY_ATTR Filter(const scene::Fxaa& settings, const FxaaImage& image) : settings_(settings), image_(image) {}

  /// Computes the new colours of the pixels in these columns.
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
    const auto here = hn::GatherIndex(du_, image_.pixels, index(x, y));
    Color color = alongEdge(edge, here);

    const V range = hn::Sub(mostOf(c, n, s, w, e), leastOf(c, n, s, w, e));
    const V blend = subpixelBlend(c, hn::Add(ns, we), range);
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
  /// Edges beside pixels: direction (along x or y), and side (-1, 1) of the pixel.
  struct Edge {
    I x, y, side;
    M alongX;
    V own, across;  // luminosity of the pixel, and across the edge
  };
  /// End of an edge in one direction: distance in pixels, and luminosity there on the pixel's side.
  struct End {
    V distance, luminosity;
  };

  HWY_ATTR I index(I x, I y) const {
    const I zero = hn::Zero(di_);
    x = hn::Min(hn::Max(x, zero), hn::Set(di_, image_.width - 1));
    y = hn::Min(hn::Max(y, zero), hn::Set(di_, image_.height - 1));
    return hn::Add(hn::Mul(y, hn::Set(di_, image_.width)), x);
  }
  HWY_ATTR V luminosity(I x, I y) const { return hn::GatherIndex(d_, image_.luminosity, index(x, y)); }
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
  /// Converts 0 .. 1 to a byte: rounds to nearest, halves up.
  HWY_ATTR hn::Vec<Unsigned> byteOf(V value) const {
    const V v = hn::Mul(hn::Min(hn::Max(value, hn::Zero(d_)), hn::Set(d_, 1)), hn::Set(d_, 255));
    const I whole = hn::ConvertTo(di_, v);
    const auto up = hn::RebindMask(di_, hn::Ge(hn::Sub(v, hn::ConvertTo(d_, whole)), hn::Set(d_, 0.5f)));
    return hn::BitCast(du_, hn::Add(whole, hn::IfThenElseZero(up, hn::Set(di_, 1))));
  }

  /// Absolute second differences of luminosity in three rows or columns, summed with weights 1, 2, 1.
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
        const Color one = rgb(hn::GatherIndex(du_, image_.pixels, at));
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

  /// Whether the first of two ends is nearer. The program compares texture coordinates that it accumulated in
  /// steps, so its float rounding decides between equal distances.
  HWY_ATTR M isNearer(const Edge& edge, V before, V after) const {
    const M alongX = edge.alongX, equal = hn::Eq(before, after);
    if (hn::AllFalse(d_, equal)) return hn::Lt(before, after);
    const V step = hn::IfThenElse(alongX, hn::Set(d_, 1.0f / static_cast<float>(image_.width)),
                                  hn::Set(d_, 1.0f / static_cast<float>(image_.height)));
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

  /// Blends the pixels' colours with those across the edge.
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
    const Color across = rgb(hn::GatherIndex(du_, image_.pixels, index(x, y)));
    for (int i = 0; i < 3; ++i)
      color.channel[i] =
          hn::IfThenElse(crosses, mix(color.channel[i], across.channel[i], offset), color.channel[i]);
    return color;
  }

  static constexpr D d_{};
  static constexpr Unsigned du_{};
  static constexpr Signed di_{};
  const scene::Fxaa& settings_;
  const FxaaImage& image_;
};

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
