#include "render/exposure/light_meter.h"

#include "base/image.h"
#include "render/resolve/tone.h"
#include "render/tile_tracer.h"
#include "scene/effects.h"
#include "scene/srgb.h"
#include "settings/samples.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gluray::render {
namespace {

// Pixels of the small images.
constexpr double kPixelsAtRest = 16384, kPixelsMoving = 6400;
constexpr int kMaxSamples = 4;  // rays of a point

/// The snapshot with fewer pixels: viewport and region by one factor.
scene::Snapshot reduced(const scene::Snapshot& given) {
  scene::Snapshot s = given;
  const double pixels = static_cast<double>(s.region.width) * s.region.height;
  const bool moves = s.lightSampling.mode == scene::LightSampling::Mode::moving;
  const double scale = std::min(1.0, std::sqrt((moves ? kPixelsMoving : kPixelsAtRest) / pixels));
  const auto begin = [&](int at) { return static_cast<int>(std::floor(at * scale)); };
  const auto size = [&](int length) { return std::max(1, static_cast<int>(std::ceil(length * scale))); };
  glm::ivec4& v = s.camera.viewport;
  v = {begin(v.x), begin(v.y), size(v.z), size(v.w)};
  s.camera.rowsFromTop = 0;
  s.region = {begin(s.region.x), begin(s.region.y), size(s.region.width), size(s.region.height)};
  s.samples = 1, s.samplePositions.clear();
  s.lightSampling = {};
  s.backdrop = nullptr;
  s.wideColors = true;
  s.settings.exposure = 0, s.settings.tone = Tone::none;
  takeOneSample(s.settings);
  s.settings.ao.samples = std::min(s.settings.ao.samples, kMaxSamples);
  s.settings.shadows.samples = 1;
  s.settings.path.samples = std::min(s.settings.path.samples, kMaxSamples);
  return s;
}

/// Of displayed values, which are clamped.
float luminanceOf(const glm::vec3& c) {
  return glm::dot(glm::clamp(c, 0.0f, 1.0f), glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

/// The pixels that show lit surfaces, in displayed values.
struct Samples {
  std::vector<glm::vec3> lit;  // with effects of light, not clamped
  double own = 0;              // sum of luminances of the program's own image

  /// Sum of the luminances that are displayed with this exposure.
  double sum(float factor, Tone curve) const {
    const ToneMap map{factor, curve, true};
    double total = 0;
    ColorRows rows{};
    for (size_t first = 0; first < lit.size(); first += kLanes) {
      const size_t count = std::min(lit.size() - first, size_t{kLanes});
      for (size_t i = 0; i < count; ++i)
        for (int c = 0; c < 3; ++c) rows.value[c][i] = lit[first + i][c];
      map.apply(rows);
      for (size_t i = 0; i < count; ++i)
        total += luminanceOf({rows.value[0][i], rows.value[1][i], rows.value[2][i]});
    }
    return total;
  }
};

class Meter {
 public:
  Meter(const scene::Snapshot& given, const accel::World& world, Arena& arena)
      : snapshot_(reduced(given)), world_(world), arena_(arena) {}

  Samples measure() {
    Image lit, own, surfaces;
    trace(lit);
    scene::dropLight(snapshot_.settings);
    trace(own);
    snapshot_.lightSampling.mode = scene::LightSampling::Mode::surfaces;
    trace(surfaces);
    Samples samples;
    for (size_t i = 0; i < lit.depth.size(); ++i)
      if (lit.depth[i] != Image::kMiss && own.depth[i] != Image::kMiss && isLitAt(surfaces, i)) {
        samples.lit.push_back(displayed(lit, i));
        samples.own += luminanceOf(displayed(own, i));
      }
    return samples;
  }

 private:
  void trace(Image& image) { traceImage(snapshot_, world_, arena_, image, {}); }

  bool isLitAt(const Image& surfaces, size_t pixel) const {
    const float number = surfaces.wideColor[4 * pixel + 3];
    if (!(number >= 1)) return false;
    const auto instance = static_cast<size_t>(number) - 1;
    if (instance >= snapshot_.instances.size()) return false;
    const scene::Instance& shown = snapshot_.instances[instance];
    return !shown.ground && isLit(snapshot_.shadings[shown.shading]);
  }

  glm::vec3 displayed(const Image& image, size_t pixel) const {
    glm::vec3 color;
    for (int c = 0; c < 3; ++c) {
      const float given = image.wideColor[4 * pixel + static_cast<size_t>(c)];
      const float v = given > 0 ? std::min(given, 1e6f) : 0.0f;  // NaN is black
      color[c] = snapshot_.encodes ? scene::encodedSrgb(v) : v;
    }
    return color;
  }

  scene::Snapshot snapshot_;
  const accel::World& world_;
  Arena& arena_;
};

}  // namespace

bool wantsMeter(const scene::Snapshot& s) {
  if (!s.settings.autoExposure || s.settings.look == Look::honest || s.catches) return false;
  const bool shows = s.lightSampling.mode == scene::LightSampling::Mode::full ||
                     s.lightSampling.mode == scene::LightSampling::Mode::moving;
  return shows && scene::changesLight(s.settings);
}

std::optional<float> meteredExposure(const scene::Snapshot& snapshot, const accel::World& world,
                                     Arena& arena) {
  if (snapshot.layers || world.empty()) return std::nullopt;
  const Samples samples = Meter(snapshot, world, arena).measure();
  if (samples.lit.empty() || !(samples.own > 0)) return std::nullopt;
  // Displayed values are about linear light to the power 1 / 2.2, so that a few steps suffice.
  constexpr int kSteps = 5;
  const float most = std::exp2(kMaxStops);
  float factor = 1;
  for (int step = 0; step < kSteps; ++step) {
    const double sum = samples.sum(factor, snapshot.settings.tone);
    if (!(sum > 0)) return most;
    factor = std::clamp(factor * static_cast<float>(std::pow(samples.own / sum, 2.2)), 1 / most, most);
  }
  return factor;
}

}  // namespace gluray::render
