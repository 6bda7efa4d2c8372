#include "render/moving/filter.h"

#include "render/tiles/tile.h"

#include <algorithm>

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/moving/filter.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// What follows is included once for each instruction set, after Highway's macros.
#include "render/moving/filter.inl.h"

#if HWY_ONCE
namespace gluray::render {

HWY_EXPORT(filterTile);

void filterTile(const MovingFrame& moving, const Tile& tile, TileVisibility& out) {
  HWY_DYNAMIC_DISPATCH(filterTile)(moving, tile, out);
}

}  // namespace gluray::render
#endif
