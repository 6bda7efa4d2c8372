// Serialises buffers of visibility (render/moving/visibility_buffer.h): single tiles and whole buffers. Any
// thread.
#pragma once
#include "cluster/stream/byte_stream.h"
#include "render/moving/visibility_buffer.h"
#include "render/tiles/tile.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gluray::cluster {

struct VisibilityShape {
  int32_t width = 0, height = 0, channels = 0;
  bool operator==(const VisibilityShape&) const = default;
};
inline VisibilityShape shapeOf(const render::VisibilityBuffer& buffer) {
  return {buffer.width, buffer.height, buffer.channels};
}
/// Throws Malformed if the shape is invalid.
void check(const VisibilityShape& shape);

/// The tile's pixels: the rows of words, then those of each further channel.
std::vector<std::byte> packVisibility(const render::VisibilityBuffer& buffer, const render::Tile& tile);
/// Throws Malformed if `bytes` are not from packVisibility() for a tile of this size and a buffer of this
/// shape.
void unpackVisibility(std::span<const std::byte> bytes, const render::Tile& tile,
                      render::VisibilityBuffer& buffer);

inline render::Tile wholeOf(const VisibilityShape& shape) { return {0, 0, shape.width, shape.height}; }

}  // namespace gluray::cluster
