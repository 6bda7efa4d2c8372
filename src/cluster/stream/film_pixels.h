// Serialises films of factors of light (render/moving/factor_film.h): single tiles and whole films. Any
// thread.
#pragma once
#include "cluster/stream/byte_stream.h"
#include "render/moving/factor_film.h"
#include "render/tiles/tile.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gluray::cluster {

struct FilmShape {
  int32_t width = 0, height = 0, factors = 0;
  bool operator==(const FilmShape&) const = default;
};
inline FilmShape shapeOf(const render::FactorFilm& film) { return {film.width, film.height, film.factors}; }
/// Throws Malformed if the shape is invalid.
void check(const FilmShape& shape);

/// The tile's pixels: the rows of words, then those of each further factor.
std::vector<std::byte> packFilm(const render::FactorFilm& film, const render::Tile& tile);
/// Throws Malformed if `bytes` are not from packFilm() for a tile of this size and a film of this shape.
void unpackFilm(std::span<const std::byte> bytes, const render::Tile& tile, render::FactorFilm& film);

inline render::Tile wholeOf(const FilmShape& shape) { return {0, 0, shape.width, shape.height}; }

}  // namespace gluray::cluster
