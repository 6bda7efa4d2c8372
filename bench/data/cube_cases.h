// The cases of marching cubes: for each set of inside corners of a cell, the triangles that part them from
// the rest.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace gluray::bench {

/// Corner c of a cell lies at (c & 1, c >> 1 & 1, c >> 2 & 1). Edge e joins corners kCubeEdges[e][0] and [1],
/// the former being the lower one; edges 0-3 run along x, 4-7 along y, 8-11 along z.
inline constexpr std::array<std::array<uint8_t, 2>, 12> kCubeEdges{
    {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

struct CubeCase {
  uint8_t triangleCount = 0;
  std::array<uint8_t, 15> edges{};  // three a triangle, counter-clockwise seen from the outside corners
};

/// Case number: bit c is set where corner c is inside. Cells that share a face cut it alike, whatever their
/// other corners are, so that the surface has no holes: an ambiguous face always keeps its inside corners
/// apart. Differs: derived by walking the faces instead of Lorensen and Cline's table of 1987, which leaves
/// holes.
const std::array<CubeCase, 256>& cubeCases();

}  // namespace gluray::bench
