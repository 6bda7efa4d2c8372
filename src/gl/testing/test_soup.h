// Sends grids of triangles to a VertexStream, as glBegin does, for tests of welding.
#pragma once
#include "gl/capture/vertex_stream.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace gluray::gl::test {

using Welding = VertexStream::Welding;
inline constexpr uint32_t kNever = VertexStream::kNever, kWeldFrom = 1u << 16;
inline constexpr uint32_t kSide = 180;  // squares per side: more than kWeldFrom corners

/// Calls send(x, y) for every corner of a grid of squares, two triangles each.
template <class Send>
void forEachCorner(uint32_t side, Send&& send) {
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x) {
      send(x, y), send(x + 1, y), send(x + 1, y + 1);
      send(x, y), send(x + 1, y + 1), send(x, y + 1);
    }
}

inline float height(uint32_t x, uint32_t y) { return std::sin(static_cast<float>(x * 31 + y)); }

inline void sendGrid(VertexStream& stream, uint32_t side) {
  forEachCorner(side, [&](uint32_t x, uint32_t y) {
    const float normal[3] = {height(x, y), 0, 1};
    if (stream.has(kNormal)) stream.set(kNormal, normal);
    // As vertexcall::vertex() does.
    if (stream.hasRoom())
      stream.vertex(static_cast<float>(x), static_cast<float>(y), height(y, x));
    else
      stream.vertexSlow(static_cast<float>(x), static_cast<float>(y), height(y, x), 1);
  });
}

inline CapturedVertices grid(uint32_t side, uint32_t weldFrom, SlotMask slots = bit(kPosition) | bit(kNormal),
                             Welding where = Welding::here) {
  VertexStream stream;
  stream.start(slots, initialSlotValues(), weldFrom, where);
  stream.begin(GL_TRIANGLES);
  sendGrid(stream, side);
  stream.end();
  return stream.takeRun();
}

/// The floats of all vertices in the order sent, through the indices if there are any.
inline std::vector<float> expanded(const CapturedVertices& c) {
  std::vector<float> floats;
  for (const Primitive& p : c.primitives)
    for (uint32_t i = p.first; i < p.first + p.count; ++i) {
      const float* v = c.vertex(c.indices.empty() ? i : c.indices[i]);
      floats.insert(floats.end(), v, v + c.layout.stride);
    }
  return floats;
}

}  // namespace gluray::gl::test
