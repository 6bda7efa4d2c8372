// Depths of one tile as one rank sends them to another: 16 bits each over the depths of its part, rounded
// away from the viewer, packed. Any thread.
#pragma once
#include "base/image.h"
#include "render/tiles/drawn_part.h"
#include "render/tiles/hidden_pixels.h"

#include <cstddef>
#include <span>
#include <vector>

namespace gluray::cluster {

/// `image`: with the tile's window depths. `part`: of this rank. `largestWins`: as in scene::Camera.
std::vector<std::byte> packDepths(const Image& image, const render::Tile& tile, const render::DrawnPart& part,
                                  bool largestWins);

/// Adds to `hidden` the pixels of the image's tile that lie behind the packed depths of a peer by more than
/// `step`. `part`: of the peer. Throws Malformed.
void addHidden(std::span<const std::byte> packed, const render::DrawnPart& part, const Image& image,
               const render::Tile& tile, bool largestWins, float step, render::HiddenPixels& hidden);

}  // namespace gluray::cluster
