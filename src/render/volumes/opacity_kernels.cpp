#include "render/volumes/volume_kernels.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

// As kernels/kernels.cpp.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/volumes/opacity_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// Highway includes the following once per instruction set.
#include "render/volumes/sample_opacities.inl.h"

#if HWY_ONCE
namespace gluray::render {

HWY_EXPORT(sampleRow);

void sampleRow(const VolumeFrame& frame, const glm::vec3& first, float step, int count, float* opacities) {
  HWY_DYNAMIC_DISPATCH(sampleRow)(frame, first, step, count, opacities);
}

}  // namespace gluray::render
#endif
