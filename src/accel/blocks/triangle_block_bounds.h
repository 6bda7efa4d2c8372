// Splits a mesh's triangles into triangle blocks and computes their bounding boxes. Private to accel/; called
// on building threads.
#pragma once
#include "accel/blocks/triangle_block_kernels.h"
#include "accel/impostors/placed_impostors.h"
#include "scene/mesh.h"

#include <cstdint>
#include <vector>

namespace gluray::accel {

/// Size limits of a block: its bounding box has at most `looser` times the summed surface area of its
/// triangles' boxes. For a row of a surface's cells, the box has about half of that sum.
struct TriangleBlockLimits {
  uint32_t most;  // triangles per block, 4 or 8
  float looser;
};

/// A range of a mesh's triangles.
TriangleRun trianglesOf(const scene::Mesh&, uint32_t first, uint32_t end);

/// Splits a range of triangles into blocks: appends the first triangle of each to `first`, and its bounding
/// box to `boxes` unless that is null. Throws std::bad_alloc.
void findTriangleBlocks(const TriangleRun&, const TriangleBlockLimits&, std::vector<uint32_t>& first,
                        std::vector<Box>* boxes);

/// The bounding box of one block that findTriangleBlocks() found, as TriangleBlocks::boxOf.
Box boxOfTriangleBlock(const TriangleRun&);

}  // namespace gluray::accel
