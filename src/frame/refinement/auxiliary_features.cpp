#include "frame/refinement/auxiliary_features.h"

#include "render/resolve/feature_pixels.h"
#include "render/resolve/wavelet.h"

#include <algorithm>
#include <cmath>

namespace gluray::frame {
namespace {

using render::packCoverage, render::unpackCoverage;

/// The mean of n + 1 values of which the last one is new.
float meanWith(float old, float now, uint32_t n) { return old + (now - old) / static_cast<float>(n + 1); }

void keepReflectance(const float* sum, size_t i, AuxiliaryFeatures& f) {
  float mean[4];
  std::copy_n(sum, 4, mean);
  if (f.passes > 0) {
    const glm::vec3 old = render::unpackReflectance(f.reflectance[i]);
    const float cover = unpackCoverage(f.coverage[i]);
    for (int c = 0; c < 3; ++c) mean[c] = meanWith(old[c] * std::abs(cover), sum[c], f.passes);
    mean[3] = meanWith(cover, sum[3], f.passes);
  }
  f.coverage[i] = packCoverage(mean[3]);
  const float cover = std::max(std::abs(unpackCoverage(f.coverage[i])), 1e-6f);
  f.reflectance[i] = render::packReflectance(glm::vec3(mean[0], mean[1], mean[2]) / cover);
}

/// The plane of a pixel, with that of earlier passes; either may be missing.
void mixPlanes(size_t i, const AuxiliaryFeatures& f, float* plane) {
  if (!(f.distance[i] > 0)) return;
  const glm::vec2 normal = render::unpackNormal2(f.normal[i]);
  const float old[] = {normal.x, normal.y, render::unpackFacing(f.facing[i]), f.distance[i]};
  const bool shows = plane[3] > 0;
  for (int c = 0; c < 4; ++c) plane[c] = shows ? meanWith(old[c], plane[c], f.passes) : old[c];
}

}  // namespace

void keepFeatures(scene::LightSampling::Mode mode, const Image& pass, bool mixed, AuxiliaryFeatures& f) {
  const size_t pixels = pass.depth.size();
  if (mode == scene::LightSampling::Mode::reflectance) {
    f.reflectance.resize(pixels);
    if (!mixed) return render::packReflectances(pass.wideColor.data(), pixels, f.reflectance.data());
    f.coverage.resize(pixels);
    for (size_t i = 0; i < pixels; ++i) keepReflectance(&pass.wideColor[4 * i], i, f);
    return;
  }
  if (mode == scene::LightSampling::Mode::noiseless) {
    f.noiseless.resize(pixels);
    return render::packReflectances(pass.wideColor.data(), pixels, f.noiseless.data());
  }
  std::vector<float> planes;
  if (f.passes > 0) {
    planes = pass.wideColor;
    for (size_t i = 0; i < pixels; ++i) mixPlanes(i, f, &planes[4 * i]);
  }
  f.normal.resize(pixels), f.facing.resize(pixels), f.distance.resize(pixels);
  render::packGeometry(planes.empty() ? pass.wideColor.data() : planes.data(), pass.depth.data(), pixels,
                       f.normal.data(), f.facing.data(), f.distance.data());
  if (!mixed) return;
  f.spread.resize(pixels);
  const float fewer = 1 / std::sqrt(static_cast<float>(f.passes + 1));
  for (size_t i = 0; i < pixels && pass.isAverages(); ++i)
    f.spread[i] = packCoverage(pass.centerDepth[i] * fewer);
}

void keepCatcher(size_t pixels, AuxiliaryFeatures& f) {
  f.reflectance.assign(pixels, render::packReflectance(glm::vec3(1)));
  f.coverage.assign(pixels, packCoverage(-1));
}

}  // namespace gluray::frame
