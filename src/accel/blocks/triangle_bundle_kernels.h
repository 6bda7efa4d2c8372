// Triangle bundles: up to eight triangle blocks and their boxes, and SIMD intersection of a packet's rays
// with them. Private to accel/; called on tracing threads.
#pragma once
#include "accel/blocks/triangle_block_kernels.h"

#include <cstdint>

namespace gluray::accel {

/// Up to kBlocks triangle blocks that are near each other. Block b holds the triangles
/// [first + offset[b], first + offset[b] + count[b]). Its box reaches from base + lower * step to
/// base + upper * step along each axis; blocks that do not exist have lower > upper. Decoding is cheaper than
/// touching more memory for the first image.
struct TriangleBundle {
  static constexpr uint32_t kBlocks = 8;
  float base[3], step[3];
  uint8_t lower[3][kBlocks], upper[3][kBlocks];
  uint32_t first, blocks;
  uint16_t offset[kBlocks];
  uint8_t count[kBlocks];
};
static_assert(sizeof(TriangleBundle) == 104);

/// As meetTriangles() and occludeTriangles(), for the blocks whose boxes the rays hit. `mesh`: the mesh's
/// arrays; its range is ignored.
void meetBundle(const TriangleBundle&, const TriangleRun& mesh, const PacketRows&, const HitNames&, Chooser,
                const void* query);
void occludeBundle(const TriangleBundle&, const TriangleRun& mesh, const PacketRows&, Chooser,
                   const void* query);

}  // namespace gluray::accel
