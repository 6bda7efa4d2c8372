#include "render/volumes/volume_kernels.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

// As kernels/kernels.cpp.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/volumes/volume_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// Highway includes the following once per instruction set.
#include "render/volumes/cast_tiles.inl.h"

#if HWY_ONCE
namespace gluray::render {

HWY_EXPORT(castTile);

void castTile(const VolumeFrame& frame, const Tile& tile) { HWY_DYNAMIC_DISPATCH(castTile)(frame, tile); }

}  // namespace gluray::render
#endif
