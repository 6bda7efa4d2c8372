// Serialises the pixels of one tile, for images that several processes trace. Any thread.
#pragma once
#include "base/image.h"
#include "cluster/stream/byte_stream.h"
#include "render/tiles/tile.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace gluray::cluster {

/// The shape of an image (base/image.h).
struct ImageShape {
  int32_t width = 0, height = 0, samples = 1;
  Planes planes = Image::kColorDepth;
  size_t pixels() const {
    return static_cast<size_t>(width) * static_cast<size_t>(height) * static_cast<size_t>(samples);
  }
  bool operator==(const ImageShape&) const = default;
};
inline ImageShape shapeOf(const Image& image) {
  return {image.width, image.height, image.samples, image.planes};
}
void write(ByteWriter& out, const ImageShape& shape);
/// Throws Malformed if the shape is invalid.
ImageShape readShape(ByteReader& in);

/// The planes of an image of some shape, wherever they are; null where the shape has none.
struct PlanePointers {
  std::byte *color = nullptr, *wideColor = nullptr, *depth = nullptr, *transmittance = nullptr,
            *centerDepth = nullptr;
};
PlanePointers planesOf(Image& image);
/// In one block of memory of bytesOf(shape) bytes.
PlanePointers planesIn(std::byte* memory, const ImageShape& shape);
size_t bytesOf(const ImageShape& shape);

/// Copies one tile of all planes and samples.
void copyTile(const PlanePointers& from, const PlanePointers& to, const ImageShape& shape,
              const render::Tile& tile);
/// The pixels of the tile, of all planes and samples; of tiles without hits only the colour of misses.
std::vector<std::byte> packTile(const Image& image, const render::Tile& tile);
/// Throws Malformed if `bytes` are not from packTile() for a tile of this size and shape.
void unpackTile(std::span<const std::byte> bytes, const ImageShape& shape, const PlanePointers& to,
                const render::Tile& tile);

}  // namespace gluray::cluster
