#include "render/resolve/wavelet.h"

#include "base/image.h"
#include "render/resolve/feature_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/resolve/wavelet.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// What follows is included once for each instruction set, after Highway's macros.
#include "render/resolve/wavelet.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

size_t memoryOfTile() { return WaveletPlanes::kCount * kArea + WaveletTile::kSize * WaveletTile::kSize; }

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::render {

HWY_EXPORT(smoothTile);
HWY_EXPORT(memoryOfTile);

bool smoothTile(const NoisyImage& image, const WaveletTile& tile, float* memory, float* out) {
  return HWY_DYNAMIC_DISPATCH(smoothTile)(image, tile, memory, out);
}

size_t waveletFloats() { return HWY_DYNAMIC_DISPATCH(memoryOfTile)(); }

void packReflectances(const float* reflectance, size_t count, uint32_t* packed) {
  for (size_t i = 0; i < count; ++i)
    packed[i] = packReflectance({reflectance[4 * i], reflectance[4 * i + 1], reflectance[4 * i + 2]});
}

void packGeometry(const float* geometry, const float* depth, size_t count, uint32_t* normal, uint16_t* facing,
                  float* distance) {
  for (size_t i = 0; i < count; ++i) {
    const float* const g = geometry + 4 * i;
    const bool shows = depth[i] != Image::kMiss && std::isfinite(g[0] + g[1] + g[2] + g[3]) && g[3] > 0;
    normal[i] = shows ? packNormal2({g[0], g[1]}) : 0;
    facing[i] = shows ? packFacing(g[2]) : uint16_t{0};
    distance[i] = shows ? g[3] : 0;
  }
}

}  // namespace gluray::render
#endif
