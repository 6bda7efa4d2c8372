#include "render/kernels/kernels.h"

#include "render/tiles/tile.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

// x86-64-v4, v3, v2 and the baseline suffice; fewer targets compile faster.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/kernels/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// Highway includes the following once per instruction set.
#include "render/kernels/packet.inl.h"

#if HWY_ONCE
namespace gluray::render {

HWY_EXPORT(traceTile);
HWY_EXPORT(relightTile);
HWY_EXPORT(traceEyeRays);
HWY_EXPORT(lightSeen);
HWY_EXPORT(targetName);

void traceTile(const FrameData& frame, const Tile& tile, WaitingPoints* waiting) {
  HWY_DYNAMIC_DISPATCH(traceTile)(frame, tile, waiting);
}
void relightTile(const FrameData& frame, const Tile& tile, const TileVisibility& visibility) {
  HWY_DYNAMIC_DISPATCH(relightTile)(frame, tile, visibility);
}
void traceEyeRays(const FrameData& frame, const Tile& tile) {
  HWY_DYNAMIC_DISPATCH(traceEyeRays)(frame, tile);
}
void lightSeen(const FrameData& frame, const Tile& tile, const HiddenPixels& hidden, WaitingPoints* waiting) {
  HWY_DYNAMIC_DISPATCH(lightSeen)(frame, tile, hidden, waiting);
}
const char* kernelTarget() { return HWY_DYNAMIC_DISPATCH(targetName)(); }

}  // namespace gluray::render
#endif
