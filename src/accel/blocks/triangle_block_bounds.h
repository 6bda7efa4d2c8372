// Which triangles that follow each other make a block, and boxes about them. Private to accel/; called on
// building threads.
#pragma once
#include "accel/blocks/triangle_block_kernels.h"
#include "accel/impostors/impostors.h"

#include <cstdint>
#include <vector>

namespace gluray::accel {

/// How large blocks are: a box about one is at most `looser` times as large as the boxes of its triangles
/// are in sum. A row of cells of a surface has about half the area that these have.
struct TriangleBlockLimits {
  uint32_t most;  // triangles
  float looser;
};

/// Divides a run into blocks: appends the first triangle of each to `first`,
/// and, where `boxes` is given, its box. Throws std::bad_alloc.
void findTriangleBlocks(const TriangleRun&, const TriangleBlockLimits&, std::vector<uint32_t>& first,
                        std::vector<Box>* boxes);

/// The box of a run that findTriangleBlocks() has made a block: see TriangleBlocks::boxOf.
Box boxOfTriangleBlock(const TriangleRun&);

}  // namespace gluray::accel
