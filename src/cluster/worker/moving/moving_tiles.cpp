#include "cluster/worker/moving/moving_tiles.h"

#include <exception>

namespace gluray::cluster {

bool MovingTiles::complete(render::VisibilityBuffer& buffer) noexcept {
  try {
    std::optional<VisibilityReady> comes = queue_.waitForVisibility();
    if (!comes) return false;
    std::span<const std::byte> bytes = comes->visibility;
    Array array;
    if (bytes.empty()) {
      if (!store_.waitFor({comes->name}, [&] { return queue_.isClosed(); })) return false;
      array = store_.find(comes->name);
      bytes = array.bytes;
    }
    unpackVisibility(bytes, wholeOf(shapeOf(buffer)), buffer);
    const render::Tiles all(buffer.width, buffer.height, render::kTileSize);
    std::erase_if(comes->tiles, [&](int32_t tile) { return tile < 0 || tile >= all.columns * all.rows; });
    tiles_ = std::move(comes->tiles);
    return true;
  } catch (const std::exception&) { return false; }  // the head traces the frame without the other ranks
}

int MovingTiles::nextToColor() noexcept {
  if (queue_.isClosed()) return -1;
  const size_t at = next_.fetch_add(1);
  return at < tiles_.size() ? tiles_[at] : -1;
}

}  // namespace gluray::cluster
