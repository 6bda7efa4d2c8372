#include "cluster/stream/film_pixels.h"

#include "render/moving/channels.h"

#include <cstring>

namespace gluray::cluster {
namespace {

constexpr int kMaxFilmSide = 65536;

/// Calls row(first byte of a row of the tile, its bytes) for all rows of all planes.
template <class Film, class Row>
void eachFilmRow(Film& film, const render::Tile& tile, const Row& row) {
  const auto width = static_cast<size_t>(tile.x1 - tile.x0);
  const auto at = [&](int y) {
    return static_cast<size_t>(y) * static_cast<size_t>(film.width) + static_cast<size_t>(tile.x0);
  };
  for (int y = tile.y0; y < tile.y1; ++y) row(film.words.data() + 2 * at(y), 2 * sizeof(uint32_t) * width);
  for (auto& plane : film.more)
    for (int y = tile.y0; y < tile.y1; ++y) row(plane.data() + at(y), sizeof(uint16_t) * width);
}

size_t filmBytes(const render::FactorFilm& film, const render::Tile& tile) {
  const auto pixels = static_cast<size_t>(tile.x1 - tile.x0) * static_cast<size_t>(tile.y1 - tile.y0);
  return pixels * (2 * sizeof(uint32_t) + film.more.size() * sizeof(uint16_t));
}

}  // namespace

void check(const FilmShape& shape) {
  const auto inside = [](int32_t value, int most) { return value >= 1 && value <= most; };
  if (!inside(shape.width, kMaxFilmSide) || !inside(shape.height, kMaxFilmSide) ||
      !inside(shape.factors, render::Channels::kMax))
    throw Malformed("no film has this shape");
}

std::vector<std::byte> packFilm(const render::FactorFilm& film, const render::Tile& tile) {
  std::vector<std::byte> bytes(filmBytes(film, tile));
  std::byte* to = bytes.data();
  eachFilmRow(film, tile, [&](const void* row, size_t size) {
    std::memcpy(to, row, size);
    to += size;
  });
  return bytes;
}

void unpackFilm(std::span<const std::byte> bytes, const render::Tile& tile, render::FactorFilm& film) {
  if (bytes.size() != filmBytes(film, tile)) throw Malformed("a part of a film has another size");
  const std::byte* from = bytes.data();
  eachFilmRow(film, tile, [&](void* row, size_t size) {
    std::memcpy(row, from, size);
    from += size;
  });
}

}  // namespace gluray::cluster
