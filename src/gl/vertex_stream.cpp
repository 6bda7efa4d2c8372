#include "gl/vertex_stream.h"

#include <algorithm>
#include <new>

namespace gluray::gl {

void VertexStream::start(SlotMask mask, const SlotValues& current) {
  captured_.clear();
  captured_.layout = VertexLayout::of(mask);
  insidePrimitive_ = false;
  cursor_ = captured_.vertices.data();
  updateLimit();
  for (int s = 1; s < kSlotCount; ++s)
    if (has(static_cast<Slot>(s))) set(static_cast<Slot>(s), current[static_cast<size_t>(s)].data());
}

void VertexStream::begin(GLenum mode) {
  std::vector<Primitive>& primitives = captured_.primitives;
  if (primitives.size() == primitives.capacity())
    primitives.reserve(primitives.size() * 2 + 4);  // end() must not fail
  insidePrimitive_ = true;
  mode_ = mode;
  first_ = captured_.vertexCount;
  updateLimit();
}

void VertexStream::updateLimit() {
  constexpr size_t kMost = 1u << 30;
  const size_t fitting = std::min(kMost, captured_.vertices.capacity() / captured_.layout.stride);
  limit_ = insidePrimitive_ && !has(kPositionW) ? static_cast<uint32_t>(fitting) : 0;
}

namespace {

/// Vertices of a primitive that count: OpenGL drops what does not complete a figure (GL 2.1, 2.6.1).
uint32_t completeVertices(GLenum mode, uint32_t n) {
  switch (mode) {
    case GL_LINES: return n - n % 2;
    case GL_TRIANGLES: return n - n % 3;
    case GL_QUADS: return n - n % 4;
    case GL_LINE_STRIP:
    case GL_LINE_LOOP: return n < 2 ? 0 : n;
    case GL_TRIANGLE_STRIP:
    case GL_TRIANGLE_FAN:
    case GL_POLYGON: return n < 3 ? 0 : n;
    case GL_QUAD_STRIP: return n < 4 ? 0 : n - n % 2;
    default: return n;
  }
}

bool isSeparate(GLenum mode) {
  return mode == GL_POINTS || mode == GL_LINES || mode == GL_TRIANGLES || mode == GL_QUADS;
}

}  // namespace

void VertexStream::end() {
  insidePrimitive_ = false;
  updateLimit();
  const uint32_t count = completeVertices(mode_, captured_.vertexCount - first_);
  captured_.vertexCount = first_ + count;
  cursor_ = captured_.vertex(captured_.vertexCount);
  if (count == 0) return;
  // Separate figures of one kind that follow each other are one primitive.
  if (!captured_.primitives.empty() && isSeparate(mode_) && captured_.primitives.back().mode == mode_) {
    captured_.primitives.back().count += count;
    return;
  }
  captured_.primitives.push_back({mode_, first_, count});
}

void VertexStream::grow() {
  constexpr uint32_t kFirst = 1024, kMost = 1u << 30;
  if (captured_.vertexCount >= kMost) throw std::bad_alloc();
  const uint32_t wanted = std::max(kFirst, std::min(kMost, captured_.vertexCount * 2));
  captured_.vertices.reserve(size_t{wanted} * captured_.layout.stride);
  updateLimit();
  cursor_ = captured_.vertex(captured_.vertexCount);
}

void VertexStream::vertexSlow(float x, float y, float z, float w) {
  if (w != 1.0f && !has(kPositionW)) addSlot(kPositionW, initialSlotValues()[kPositionW].data());
  if (size_t{captured_.vertexCount + 1} * captured_.layout.stride > captured_.vertices.capacity()) grow();
  if (has(kPositionW)) set(kPositionW, &w);
  vertex(x, y, z);
}

void VertexStream::relayout(SlotMask mask) {
  const VertexLayout from = captured_.layout, to = VertexLayout::of(mask);
  float old[128 + 16];
  std::memcpy(old, template_, sizeof old);
  const auto move = [&](const float* source, float* target) {
    for (int s = 0; s < kSlotCount; ++s) {
      const auto slot = static_cast<Slot>(s);
      if (from.has(slot)) std::memcpy(target + to.offset[s], source + from.offset[s], sizeOf(slot) * 4);
    }
  };
  move(old, template_);
  FloatBuffer moved;
  moved.reserve(size_t{std::max(captured_.vertexCount, 1u)} * to.stride);
  for (uint32_t i = 0; i < captured_.vertexCount; ++i)
    move(captured_.vertex(i), moved.data() + size_t{i} * to.stride);
  captured_.vertices = std::move(moved);
  captured_.layout = to;
  updateLimit();
  cursor_ = captured_.vertex(captured_.vertexCount);
}

void VertexStream::addSlot(Slot slot, const float* earlier) {
  relayout(captured_.layout.mask | bit(slot));
  set(slot, earlier);
  for (uint32_t i = 0; i < captured_.vertexCount; ++i)
    std::memcpy(captured_.vertex(i) + captured_.layout.offset[slot], earlier, sizeOf(slot) * 4);
}

float VertexStream::addMaterial(const MaterialChange& change) {
  if (captured_.materials.empty() || !(captured_.materials.back() == change))
    captured_.materials.push_back(change);
  return static_cast<float>(captured_.materials.size());
}

Captured VertexStream::take() {
  Captured result = std::move(captured_);
  captured_ = {};
  cursor_ = nullptr;
  limit_ = 0;
  return result;
}

}  // namespace gluray::gl
