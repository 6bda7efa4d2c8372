#include "render/kernels.h"

#include <algorithm>
#include <bit>
#include <cmath>

#define HWY_WANT_SSE4 1
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/kernels.cpp"
#include <hwy/foreach_target.h>
// Highway's macros come first, then what uses them.
#include "render/packet.inl.h"

#include <hwy/highway.h>

#if HWY_ONCE
namespace gluray::render {

HWY_EXPORT(traceTile);
HWY_EXPORT(targetName);

void traceTile(const FrameData& frame, const Tile& tile) { HWY_DYNAMIC_DISPATCH(traceTile)(frame, tile); }
const char* kernelTarget() { return HWY_DYNAMIC_DISPATCH(targetName)(); }

}  // namespace gluray::render
#endif
