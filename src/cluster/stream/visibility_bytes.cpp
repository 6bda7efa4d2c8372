#include "cluster/stream/visibility_bytes.h"

#include "render/moving/channels.h"

#include <cstring>

namespace gluray::cluster {
namespace {

constexpr int kMaxBufferSide = 65536;

/// Calls row(first byte of a row of the tile, its bytes) for all rows of all planes.
template <class Buffer, class Row>
void eachBufferRow(Buffer& buffer, const render::Tile& tile, const Row& row) {
  const auto width = static_cast<size_t>(tile.x1 - tile.x0);
  const auto at = [&](int y) {
    return static_cast<size_t>(y) * static_cast<size_t>(buffer.width) + static_cast<size_t>(tile.x0);
  };
  for (int y = tile.y0; y < tile.y1; ++y) row(buffer.words.data() + 2 * at(y), 2 * sizeof(uint32_t) * width);
  for (auto& plane : buffer.more)
    for (int y = tile.y0; y < tile.y1; ++y) row(plane.data() + at(y), sizeof(uint16_t) * width);
}

size_t visibilityBytes(const render::VisibilityBuffer& buffer, const render::Tile& tile) {
  const auto pixels = static_cast<size_t>(tile.x1 - tile.x0) * static_cast<size_t>(tile.y1 - tile.y0);
  return pixels * (2 * sizeof(uint32_t) + buffer.more.size() * sizeof(uint16_t));
}

}  // namespace

void check(const VisibilityShape& shape) {
  const auto inside = [](int32_t value, int most) { return value >= 1 && value <= most; };
  if (!inside(shape.width, kMaxBufferSide) || !inside(shape.height, kMaxBufferSide) ||
      !inside(shape.channels, render::Channels::kMax))
    throw Malformed("no visibility buffer has this shape");
}

std::vector<std::byte> packVisibility(const render::VisibilityBuffer& buffer, const render::Tile& tile) {
  std::vector<std::byte> bytes(visibilityBytes(buffer, tile));
  std::byte* to = bytes.data();
  eachBufferRow(buffer, tile, [&](const void* row, size_t size) {
    std::memcpy(to, row, size);
    to += size;
  });
  return bytes;
}

void unpackVisibility(std::span<const std::byte> bytes, const render::Tile& tile,
                      render::VisibilityBuffer& buffer) {
  if (bytes.size() != visibilityBytes(buffer, tile))
    throw Malformed("a part of a visibility buffer has another size");
  const std::byte* from = bytes.data();
  eachBufferRow(buffer, tile, [&](void* row, size_t size) {
    std::memcpy(row, from, size);
    from += size;
  });
}

}  // namespace gluray::cluster
