#include "cluster/stream/tile_pixels.h"

#include <algorithm>
#include <cstring>

namespace gluray::cluster {
namespace {

constexpr int kMaxSide = 65536, kMaxSamplesPerPixel = 64;

using PlaneOf = std::byte* PlanePointers::*;
struct PlaneSize {
  Plane plane;
  size_t bytes;  // of a pixel
  PlaneOf at;
};
constexpr PlaneSize kPlanes[] = {
    {Plane::color, sizeof(uint32_t), &PlanePointers::color},
    {Plane::wideColor, 4 * sizeof(float), &PlanePointers::wideColor},
    {Plane::depth, sizeof(float), &PlanePointers::depth},
    {Plane::transmittance, sizeof(float), &PlanePointers::transmittance},
    {Plane::centerDepth, sizeof(float), &PlanePointers::centerDepth},
};

size_t bytesOfPixel(Planes planes) {
  size_t bytes = 0;
  for (const PlaneSize& p : kPlanes) bytes += planes.has(p.plane) ? p.bytes : 0;
  return bytes;
}

/// Calls row(plane's first byte, offset of a row of the tile, bytes of the row) for all rows of all planes.
template <class Row>
void eachRow(const ImageShape& shape, const render::Tile& tile, const Row& row) {
  const auto pixel = [&](int sample, int y) {
    return (static_cast<size_t>(sample) * static_cast<size_t>(shape.height) + static_cast<size_t>(y)) *
               static_cast<size_t>(shape.width) +
           static_cast<size_t>(tile.x0);
  };
  const auto width = static_cast<size_t>(tile.x1 - tile.x0);
  for (const PlaneSize& p : kPlanes) {
    if (!shape.planes.has(p.plane)) continue;
    for (int sample = 0; sample < shape.samples; ++sample)
      for (int y = tile.y0; y < tile.y1; ++y) row(p.at, p.bytes * pixel(sample, y), p.bytes * width);
  }
}

size_t bytesOfTile(const ImageShape& shape, const render::Tile& tile) {
  return static_cast<size_t>(tile.x1 - tile.x0) * static_cast<size_t>(tile.y1 - tile.y0) *
         static_cast<size_t>(shape.samples) * bytesOfPixel(shape.planes);
}

uint8_t bitsOf(Planes planes) {
  uint8_t bits = 0;
  for (const PlaneSize& p : kPlanes)
    if (planes.has(p.plane)) bits |= static_cast<uint8_t>(p.plane);
  return bits;
}

/// Whether no ray of the tile hit anything: then the colour of misses says it all.
bool isEmpty(const Image& image, const render::Tile& tile) {
  if (!image.isPlain()) return false;
  for (int y = tile.y0; y < tile.y1; ++y) {
    const size_t row = static_cast<size_t>(y) * static_cast<size_t>(image.width);
    for (int x = tile.x0; x < tile.x1; ++x) {
      const size_t at = row + static_cast<size_t>(x);
      if (image.depth[at] != Image::kMiss || image.color[at] != image.missColor) return false;
    }
  }
  return true;
}

void unpackEmpty(std::span<const std::byte> bytes, const ImageShape& shape, const PlanePointers& to,
                 const render::Tile& tile) {
  uint32_t color;
  std::memcpy(&color, bytes.data(), sizeof color);
  eachRow(shape, tile, [&](PlaneOf plane, size_t offset, size_t size) {
    auto* const row = to.*plane + offset;
    if (plane == &PlanePointers::color)
      std::fill_n(reinterpret_cast<uint32_t*>(row), size / sizeof color, color);
    else
      std::fill_n(reinterpret_cast<float*>(row), size / sizeof(float), Image::kMiss);
  });
}

}  // namespace

void write(ByteWriter& out, const ImageShape& shape) {
  out.put(shape.width), out.put(shape.height), out.put(shape.samples), out.put(bitsOf(shape.planes));
}

ImageShape readShape(ByteReader& in) {
  ImageShape shape;
  shape.width = in.get<int32_t>(), shape.height = in.get<int32_t>(), shape.samples = in.get<int32_t>();
  const auto inside = [](int32_t value, int most) { return value >= 1 && value <= most; };
  if (!inside(shape.width, kMaxSide) || !inside(shape.height, kMaxSide) ||
      !inside(shape.samples, kMaxSamplesPerPixel))
    throw Malformed("no image has this size");
  const auto bits = in.get<uint8_t>();
  for (const Planes planes : {Image::kColorDepth, Image::kWide, Image::kSums})
    for (const Planes more : {planes, planes | Plane::centerDepth})
      if (bitsOf(more) == bits) return shape.planes = more, shape;
  throw Malformed("no image has these planes");
}

PlanePointers planesOf(Image& image) {
  const auto at = [](auto& plane) { return reinterpret_cast<std::byte*>(plane.data()); };
  return {at(image.color), at(image.wideColor), at(image.depth), at(image.transmittance),
          at(image.centerDepth)};
}

PlanePointers planesIn(std::byte* memory, const ImageShape& shape) {
  PlanePointers planes;
  for (const PlaneSize& p : kPlanes)
    if (shape.planes.has(p.plane)) planes.*p.at = memory, memory += p.bytes * shape.pixels();
  return planes;
}

size_t bytesOf(const ImageShape& shape) { return shape.pixels() * bytesOfPixel(shape.planes); }

void copyTile(const PlanePointers& from, const PlanePointers& to, const ImageShape& shape,
              const render::Tile& tile) {
  eachRow(shape, tile, [&](PlaneOf plane, size_t offset, size_t size) {
    std::memcpy(to.*plane + offset, from.*plane + offset, size);
  });
}

std::vector<std::byte> packTile(const Image& image, const render::Tile& tile) {
  const ImageShape shape = shapeOf(image);
  if (isEmpty(image, tile)) {
    const auto* const color = reinterpret_cast<const std::byte*>(&image.missColor);
    return {color, color + sizeof image.missColor};
  }
  const PlanePointers planes = planesOf(const_cast<Image&>(image));
  std::vector<std::byte> bytes(bytesOfTile(shape, tile));
  std::byte* to = bytes.data();
  eachRow(shape, tile, [&](PlaneOf plane, size_t offset, size_t size) {
    std::memcpy(to, planes.*plane + offset, size);
    to += size;
  });
  return bytes;
}

void unpackTile(std::span<const std::byte> bytes, const ImageShape& shape, const PlanePointers& to,
                const render::Tile& tile) {
  if (bytes.size() == sizeof(uint32_t) && shape.planes == Image::kColorDepth)
    return unpackEmpty(bytes, shape, to, tile);
  if (bytes.size() != bytesOfTile(shape, tile)) throw Malformed("a tile has another size");
  const std::byte* from = bytes.data();
  eachRow(shape, tile, [&](PlaneOf plane, size_t offset, size_t size) {
    std::memcpy(to.*plane + offset, from, size);
    from += size;
  });
}

}  // namespace gluray::cluster
