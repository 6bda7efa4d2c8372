// Filters a visibility buffer without crossing edges of surfaces. Called on all tracing
// threads.
#pragma once
#include "render/integrators/light_visibility.h"
#include "render/moving/moving_frame.h"
#include "render/tiles/tile.h"

namespace gluray::render {

/// The visibility of one tile's packets, row by row.
struct TileVisibility {
  static constexpr int kColumns = kTileSize / 4;
  Visibility packets[kColumns * kColumns];
  /// Visibility of the packet that begins at a pixel of the tile.
  const Visibility& at(int x, int y) const { return packets[y / 4 * kColumns + x / 4]; }
};

/// Means of the visibility over 5 x 5 pixels (weights 1/2 1 1 1 1/2, which see each of the 4 x 4 directions
/// of a packet once), or over 9 x 9 where a pixel has few samples, as far as these show the same surface:
/// separable, guided by depth and normal, weighted by their numbers of samples. Where neighbours differ by
/// more than noise explains, a pixel's own value counts more (Wiener's filter). Reads the buffer four pixels
/// beyond the tile.
void filterTile(const MovingFrame&, const Tile&, TileVisibility&);

}  // namespace gluray::render
