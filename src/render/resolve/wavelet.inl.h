// The edge-stopping wavelet filter. Compiled once for each instruction set.
#if defined(GLURAY_RENDER_RESOLVE_WAVELET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_RESOLVE_WAVELET_INL_H_
#undef GLURAY_RENDER_RESOLVE_WAVELET_INL_H_
#else
#define GLURAY_RENDER_RESOLVE_WAVELET_INL_H_
#endif

#include "render/resolve/unmix.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

constexpr float kKernel[] = {1.0f / 16, 1.0f / 4, 3.0f / 8, 1.0f / 4, 1.0f / 16};

/// (1 - x)^2 for x in 0 .. 1, and 0 beyond: Tukey's biweight, of a squared ratio.
HWY_INLINE Float biweight(Float x) {
  const Float rest = hn::Max(hn::Sub(splat(1), x), hn::Zero(FloatTag()));
  return hn::Mul(rest, rest);
}

HWY_INLINE Float luminance(Float r, Float g, Float b) {
  return hn::MulAdd(r, splat(0.2126f), hn::MulAdd(g, splat(0.7152f), hn::Mul(b, splat(0.0722f))));
}

HWY_INLINE Float luminanceAt(float* const (&in)[4], int j) {
  return luminance(at(in[0], j), at(in[1], j), at(in[2], j));
}

/// What a pixel's neighbours are compared with.
struct WaveletCenter {
  Float a, b, c, distance, z, reflectance[3];
  Float flatness[2];  // 1 / square of the farthest from the plane, of neighbours one step and two steps away
};

HWY_ATTR inline WaveletCenter waveletCenter(const WaveletPlanes& p, int i, int step) {
  constexpr float kOffPlane = 0.75f, kOffFar = 0.09f;  // pixels, and more for each pixel away
  constexpr float kSpreads = 2;
  WaveletCenter m{at(p.a, i), at(p.b, i),
                  at(p.c, i), at(p.distance, i),
                  at(p.z, i), {at(p.red[0], i), at(p.red[1], i), at(p.red[2], i)},
                  {}};
  for (int steps = 1; steps <= 2; ++steps) {
    const float reach = kOffPlane + kOffFar * static_cast<float>(steps * step);
    const Float end = hn::MulAdd(at(p.spread, i), splat(kSpreads), splat(reach));
    m.flatness[steps - 1] = hn::Div(splat(1), hn::Mul(end, end));
  }
  return m;
}

/// How much of a neighbour (dx, dy) pixels away, one step or two, shows the same surface, 0 .. 1, in
/// proportion to its coverage.
HWY_ATTR inline Float likeness(const WaveletPlanes& p, const WaveletCenter& m, int j, int dx, int dy,
                               int steps) {
  constexpr float kReflectance = 0.1f;
  const FloatTag d;
  const Float nearness = at(p.nearness, j);
  const Float along =
      hn::MulAdd(m.a, splat(static_cast<float>(dx)), hn::Mul(m.b, splat(static_cast<float>(dy))));
  const Float off = hn::MulAdd(m.c, hn::NegMulAdd(m.distance, nearness, splat(1)), along);
  const Float level = biweight(hn::Mul(hn::Mul(off, off), m.flatness[steps - 1]));
  // cos^32: half at twelve degrees
  Float cosine = hn::MulAdd(m.a, at(p.a, j), hn::MulAdd(m.b, at(p.b, j), hn::Mul(m.z, at(p.z, j))));
  cosine = hn::Min(hn::Max(cosine, hn::Zero(d)), splat(1));
  for (int i = 0; i < 5; ++i) cosine = hn::Mul(cosine, cosine);
  Float differs = hn::Zero(d);
  for (int channel = 0; channel < 3; ++channel) {
    const Float difference = hn::Sub(at(p.red[channel], j), m.reflectance[channel]);
    differs = hn::Max(differs, hn::Mul(difference, difference));
  }
  const Float same = biweight(hn::Mul(differs, splat(1 / (kReflectance * kReflectance))));
  const Float like = hn::Mul(hn::Mul(cosine, same), hn::Mul(level, hn::Abs(at(p.cover, j))));
  return hn::IfThenElseZero(hn::Gt(nearness, hn::Zero(d)), like);
}

/// Larger of two distances in steps, at least one.
inline int stepsOf(int u, int v) { return std::max({std::abs(u), std::abs(v), 1}); }

/// Calls each(dx, dy) for 5 x 5 pixels.
template <class Each>
HWY_ATTR HWY_INLINE void eachNeighbour(Each&& each) {
  for (int y = -2; y <= 2; ++y)
    for (int x = -2; x <= 2; ++x) each(x, y);
}

/// Variances of single pixels are known badly: means over neighbours, of any surface where the pixel mixes
/// surfaces. `known`: otherwise their light's variance. Source and destination are sets of `light`.
HWY_ATTR inline void smoothVariance(WaveletPlanes& p, bool known) {
  const FloatTag d;
  for (int row = 2; row < kSide - 2; ++row) {
    for (int x = 2; x < kSide - 2; x += lanesOfVector()) {
      const int i = row * kStride + x;
      const WaveletCenter m = waveletCenter(p, i, 1);
      const auto mixes = hn::Lt(at(p.cover, i), hn::Zero(d));
      Float weights = hn::Zero(d), sum = hn::Zero(d), squares = hn::Zero(d), variance = hn::Zero(d);
      eachNeighbour([&](int dx, int dy) HWY_ATTR {
        const int j = i + dy * kStride + dx;
        const Float shows = hn::Abs(at(p.cover, j));
        const Float w = hn::IfThenElse(mixes, shows, likeness(p, m, j, dx, dy, stepsOf(dx, dy)));
        const Float l = luminanceAt(p.light[0], j);
        weights = hn::Add(weights, w);
        variance = hn::MulAdd(w, at(p.light[0][3], j), variance);
        sum = hn::MulAdd(w, l, sum), squares = hn::MulAdd(w, hn::Mul(l, l), squares);
      });
      const Float inverse = hn::Div(splat(1), hn::Max(weights, splat(1e-20f)));
      const Float mean = hn::Mul(sum, inverse);
      const Float spread = hn::Max(hn::NegMulAdd(mean, mean, hn::Mul(squares, inverse)), hn::Zero(d));
      put(known ? hn::Mul(variance, inverse) : spread, p.light[1][3], i);
    }
  }
  std::copy_n(p.light[1][3], kArea, p.light[0][3]);
}

/// Weighted sums of light and of variances.
struct LightSums {
  Float weights, light[3], variance;
  HWY_INLINE void add(Float w, float* const (&in)[4], int j) {
    weights = hn::Add(weights, w);
    for (int c = 0; c < 3; ++c) light[c] = hn::MulAdd(w, at(in[c], j), light[c]);
    variance = hn::MulAdd(hn::Mul(w, w), at(in[3], j), variance);
  }
};

/// A pixel, and how light is compared with its light.
struct LightCenter {
  WaveletCenter surface;
  Float luminance;
  Float scale;  // of squared differences, so that weights end at 1
};

/// Adds the neighbours (u, v) and (-u, -v) steps away. Light that rises as much on one side as it falls on
/// the other is kept by their mean: what counts of both is how much the three bend, and of the rest of either
/// how much it differs.
HWY_INLINE void addPair(const WaveletPlanes& p, float* const (&in)[4], const LightCenter& m, int i, int u,
                        int v, int step, LightSums& sums) {
  constexpr float kBend = 0.25f;
  const int dx = u * step, dy = v * step, j[] = {i + dy * kStride + dx, i - dy * kStride - dx};
  const Float likes[] = {likeness(p, m.surface, j[0], dx, dy, stepsOf(u, v)),
                         likeness(p, m.surface, j[1], -dx, -dy, stepsOf(u, v))};
  const Float differences[] = {hn::Sub(luminanceAt(in, j[0]), m.luminance),
                               hn::Sub(luminanceAt(in, j[1]), m.luminance)};
  const Float bend = hn::Add(differences[0], differences[1]);
  const Float straight = biweight(hn::Mul(hn::Mul(bend, bend), hn::Mul(m.scale, splat(kBend))));
  const Float both = hn::Mul(hn::Min(likes[0], likes[1]), straight);
  const Float kernel = splat(kKernel[u + 2] * kKernel[v + 2]);
  for (int side = 0; side < 2; ++side) {
    const Float alone = biweight(hn::Mul(hn::Mul(differences[side], differences[side]), m.scale));
    sums.add(hn::Mul(kernel, hn::MulAdd(hn::Sub(likes[side], both), alone, both)), in, j[side]);
  }
}

/// One round: the set `from` of light to the other one. `margin`: rows and columns about the tile that later
/// rounds read.
HWY_ATTR inline void waveletRound(WaveletPlanes& p, int from, int step, int margin) {
  constexpr float kDeviations = 50;  // squared: five of the difference of two pixels
  const FloatTag d;
  const int first = WaveletTile::kReach - margin, last = WaveletTile::kReach + WaveletTile::kSize + margin;
  float* const(&in)[4] = p.light[from];
  float* const(&out)[4] = p.light[1 - from];
  for (int row = first; row < last; ++row) {
    for (int x = first; x < last; x += lanesOfVector()) {
      const int i = row * kStride + x;
      const Float variance = at(in[3], i);
      const Float scale = hn::Div(splat(1), hn::MulAdd(variance, splat(kDeviations), splat(1e-12f)));
      const LightCenter m{waveletCenter(p, i, step), luminanceAt(in, i), scale};
      LightSums sums{hn::Zero(d), {hn::Zero(d), hn::Zero(d), hn::Zero(d)}, hn::Zero(d)};
      sums.add(hn::Mul(splat(kKernel[2] * kKernel[2]), hn::Abs(at(p.cover, i))), in, i);
      for (int v = 0; v <= 2; ++v)
        for (int u = v ? -2 : 1; u <= 2; ++u) addPair(p, in, m, i, u, v, step, sums);
      const auto any = hn::Gt(sums.weights, hn::Zero(d));
      const Float inverse = hn::Div(splat(1), hn::Max(sums.weights, splat(1e-20f)));
      for (int c = 0; c < 3; ++c)
        put(hn::IfThenElse(any, hn::Mul(sums.light[c], inverse), at(in[c], i)), out[c], i);
      put(hn::IfThenElse(any, hn::Mul(sums.variance, hn::Mul(inverse, inverse)), variance), out[3], i);
    }
  }
}

/// Writes a pixel with the share of its smoothed light. `set`: the last round's light; the other set has that
/// of the round before it, also around the tile. `square`: its variance before.
HWY_ATTR inline void blendPixel(const NoisyImage& in, int x, int y, const WaveletPlanes& p, int set, int i,
                                float square, float* to) {
  const float* const from =
      in.color + 4 * (static_cast<size_t>(y) * static_cast<size_t>(in.width) + static_cast<size_t>(x));
  std::copy_n(from, 4, to);
  Demodulation d;
  const float share = square > 0 ? std::max(1 - in.target * in.target / square, 0.0f) : 0;
  if (!(share > 0 && p.distance[i] > 0) || !demodulate(in, x, y, d)) return;
  float light[3] = {p.light[set][0][i], p.light[set][1][i], p.light[set][2][i]};
  if (d.onCatcher) return void(to[3] = from[3] + share * (light[0] * d.factor[0] - from[3]));
  float noisy[3];
  for (int c = 0; c < 3; ++c) noisy[c] = (std::min(from[c], in.most) - d.behind[c]) / d.factor[c];
  if (p.cover[i] < 0) unmix(p, i, 1 - set, noisy, square / (d.scale() * d.scale()), light);
  for (int c = 0; c < 3; ++c) {
    const float own = std::min(from[c], in.most);
    to[c] = own + share * (light[c] * d.factor[c] + d.behind[c] - own);
  }
  if (float caught; d.cover < 1 && !in.backdrop && catcherLight(p, i, 1 - set, caught))
    to[3] = from[3] + share * (d.cover + (1 - d.cover) * caught - from[3]);
}

/// `variances`: of the tile's pixels, before they were smoothed.
HWY_ATTR inline void blendPixels(const NoisyImage& in, const WaveletTile& tile, const WaveletPlanes& p,
                                 int set, const float* variances, float* out) {
  for (int y = 0; y < WaveletTile::kSize && tile.y + y < in.height; ++y)
    for (int x = 0; x < WaveletTile::kSize && tile.x + x < in.width; ++x) {
      const int i = (WaveletTile::kReach + y) * kStride + WaveletTile::kReach + x;
      const int at = y * WaveletTile::kSize + x;
      blendPixel(in, tile.x + x, tile.y + y, p, set, i, variances[at], out + 4 * at);
    }
}

/// Keeps the variances of the tile's displayed colours. Returns whether any pixel has more noise than the
/// target.
HWY_ATTR inline bool keepVariances(const NoisyImage& in, const WaveletTile& tile, const WaveletPlanes& p,
                                   float* variances) {
  bool any = false;
  std::fill_n(variances, WaveletTile::kSize * WaveletTile::kSize, 0.0f);
  for (int y = 0; y < WaveletTile::kSize && tile.y + y < in.height; ++y)
    for (int x = 0; x < WaveletTile::kSize && tile.x + x < in.width; ++x) {
      const int i = (WaveletTile::kReach + y) * kStride + WaveletTile::kReach + x;
      Demodulation d;
      if (!(p.distance[i] > 0) || !demodulate(in, tile.x + x, tile.y + y, d)) continue;
      const float square = p.light[0][3][i] * d.scale() * d.scale();
      variances[y * WaveletTile::kSize + x] = square;
      any |= square > in.target * in.target;
    }
  return any;
}

HWY_ATTR bool smoothTile(const NoisyImage& in, const WaveletTile& tile, float* memory, float* out) {
  WaveletPlanes p(memory);
  if (!unpackPlanes(in, tile, p)) return false;
  smoothVariance(p, in.noise != nullptr);
  float* const variances = memory + WaveletPlanes::kCount * kArea;
  if (!keepVariances(in, tile, p, variances)) return false;
  int set = 0, margin = WaveletTile::kReach - 2;  // variances take two
  for (int step = 1; step <= WaveletTile::kLastStep; step *= 2) {
    margin -= 2 * step;
    waveletRound(p, set, step, margin);
    set = 1 - set;
  }
  blendPixels(in, tile, p, set, variances, out);
  return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
