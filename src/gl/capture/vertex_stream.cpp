#include "gl/capture/vertex_stream.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <numeric>
#include <utility>

namespace gluray::gl {
namespace {
constexpr uint32_t kMax = 1u << 30;    // maximum number of vertices in a run
constexpr uint32_t kPiece = 1u << 13;  // vertices welded at a time: few enough to stay in the caches
}  // namespace

void VertexStream::start(SlotMask mask, const SlotValues& current, uint32_t weldFrom, Welding where) {
  behind_.drop();
  captured_.clear();
  weldFrom_ = weldFrom;
  where_ = where;
  kept_ = numbered_ = 0;
  welder_.forget();
  watch_.start();
  captured_.layout = VertexLayout::layoutOf(mask);
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
  first_ = sent();
  if (mode != GL_TRIANGLES) stopWelding();
  updateLimit();
}

void VertexStream::stopWelding() {
  numberAll();
  watch_.spoil();
  weldFrom_ = kNever;
  welder_.forget();
}

/// The value of captured_.vertexCount at which vertices are welded next.
uint32_t VertexStream::nextWeld() const { return behind_.active() || kept_ > 0 ? kept_ + kPiece : weldFrom_; }

void VertexStream::updateLimit() {
  size_t fitting = std::min<size_t>(kMax, captured_.vertices.capacity() / captured_.layout.stride);
  if (welds()) fitting = std::min<size_t>(fitting, nextWeld());
  room_ = static_cast<uint32_t>(fitting);
  limit_ = insidePrimitive_ && !has(kPositionW) ? room_ : 0;
}

namespace {

/// How many of `n` vertices are drawn: OpenGL ignores incomplete triangles, quads ... (GL 2.1, 2.6.1).
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
  const uint32_t count = completeVertices(mode_, sent() - first_), extra = sent() - first_ - count;
  // Extra vertices that are already welded stay, with no index that refers to them.
  const uint32_t arrived = std::min(extra, captured_.vertexCount - kept_);
  if (extra > arrived) bringBack();
  captured_.vertexCount -= arrived;
  captured_.indices.resize(captured_.indices.size() - (extra - arrived));
  numbered_ -= extra - arrived;
  if (watch_.corners() > numbered_) watch_.spoil();  // it has seen vertices that are left out
  cursor_ = captured_.vertex(captured_.vertexCount);
  if (count == 0) return;
  // Consecutive glBegin/glEnd pairs of one separate mode become one primitive.
  if (!captured_.primitives.empty() && isSeparate(mode_) && captured_.primitives.back().mode == mode_) {
    captured_.primitives.back().count += count;
    return;
  }
  captured_.primitives.push_back({mode_, first_, count});
}

// Call before vertices that have arrived are welded or handed over. A second call for them, after a failure,
// does nothing.
void VertexStream::watch() {
  const uint32_t first = behind_.active() ? 0 : kept_, arrived = captured_.vertexCount - first;
  if (watch_.corners() == numbered_) watch_.add(captured_.vertex(first), arrived, captured_.layout.stride);
  if (watch_.corners() != numbered_ + arrived) watch_.spoil();
}

void VertexStream::weldArrived() {
  watch();
  kept_ = welder_.weld(captured_.vertices.data(), captured_.layout.stride, kept_, captured_.vertex(kept_),
                       captured_.vertexCount - kept_, captured_.indices);
  captured_.vertexCount = kept_;
  numbered_ = static_cast<uint32_t>(captured_.indices.size());
}

// Welds the first vertices on this thread, and later ones on WeldBehind's if it can start.
void VertexStream::weldBehind() {
  if (behind_.active()) {
    const uint32_t count = captured_.vertexCount;
    watch();
    if (behind_.hand(captured_.vertices, count)) {
      numbered_ += count;
      captured_.vertexCount = 0;
      return;
    }
    where_ = Welding::here;
    bringBack();
  }
  weldArrived();
  if (where_ == Welding::here) return;
  WeldBehind::Run run{std::move(captured_.vertices), std::move(captured_.indices), std::move(welder_), kept_};
  if (behind_.start(run, captured_.layout.stride, kPiece, captured_.vertices)) {
    captured_.vertexCount = kept_ = 0;
    return;
  }
  captured_.vertices = std::move(run.vertices), captured_.indices = std::move(run.indices);
  welder_ = std::move(run.welder);
  where_ = Welding::here;
}

// Takes the welded run back from WeldBehind and appends the vertices that have arrived since.
void VertexStream::bringBack() {
  if (!behind_.active()) return;
  const uint32_t arrived = captured_.vertexCount;
  WeldBehind::Run run = behind_.finish(arrived);
  const GrowingArray<float> piece = std::exchange(captured_.vertices, std::move(run.vertices));
  captured_.indices = std::move(run.indices), welder_ = std::move(run.welder);
  kept_ = run.kept;
  captured_.vertexCount = kept_ + arrived;
  std::memcpy(captured_.vertex(kept_), piece.data(),
              size_t{arrived} * captured_.layout.stride * sizeof(float));
  cursor_ = captured_.vertex(captured_.vertexCount);
  updateLimit();
}

// If the capture has indices, gives one to every vertex that has none yet.
void VertexStream::numberAll() {
  bringBack();
  if (captured_.indices.empty() || kept_ == captured_.vertexCount) return;
  if (welds()) {
    weldArrived();
  } else {
    const size_t before = captured_.indices.size();
    captured_.indices.grow(before + (captured_.vertexCount - kept_));
    std::iota(captured_.indices.begin() + before, captured_.indices.end(), kept_);
    kept_ = captured_.vertexCount;
    numbered_ = static_cast<uint32_t>(captured_.indices.size());
  }
  cursor_ = captured_.vertex(captured_.vertexCount);
  updateLimit();
}

void VertexStream::grow() {
  constexpr uint32_t kFirst = 1024;
  if (sent() >= kMax) throw std::bad_alloc();
  if (welds() && captured_.vertexCount >= nextWeld()) weldBehind();
  const uint32_t stored = captured_.vertexCount, stride = captured_.layout.stride;
  if (size_t{stored + kPiece} * stride > captured_.vertices.capacity())
    captured_.vertices.reserve(size_t{std::max(kFirst, std::min(kMax, stored * 2))} * stride);
  updateLimit();
  cursor_ = captured_.vertex(stored);
}

void VertexStream::vertexSlow(float x, float y, float z, float w) {
  if (w != 1.0f && !has(kPositionW)) addSlot(kPositionW, initialSlotValues()[kPositionW].data());
  if (captured_.vertexCount >= room_) grow();
  if (has(kPositionW)) set(kPositionW, &w);
  vertex(x, y, z);
}

// Works in place if there is room, to reuse memory that an earlier run has touched.
void VertexStream::relayout(SlotMask mask) {
  const VertexLayout from = captured_.layout, to = VertexLayout::layoutOf(mask);
  captured_.vertices.reserve(size_t{std::max(captured_.vertexCount, 1u)} * to.stride);
  float old[128 + 16];
  const auto move = [&](const float* source, float* target) {
    std::memcpy(old, source, from.stride * sizeof(float));
    for (int s = 0; s < kSlotCount; ++s) {
      const auto slot = static_cast<Slot>(s);
      if (from.has(slot)) std::memcpy(target + to.offset[s], old + from.offset[s], sizeOf(slot) * 4);
    }
  };
  move(template_, template_);
  // Vertices only get wider, so that no vertex is overwritten before it is read if the last is moved first.
  for (uint32_t i = captured_.vertexCount; i-- > 0;)
    move(captured_.vertices.data() + size_t{i} * from.stride,
         captured_.vertices.data() + size_t{i} * to.stride);
  captured_.layout = to;
  updateLimit();
  cursor_ = captured_.vertex(captured_.vertexCount);
}

void VertexStream::addSlot(Slot slot, const float* earlier) {
  if (!empty()) stopWelding();  // equal vertices may get different values
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

CapturedVertices VertexStream::takeRun() {
  numberAll();
  if (SurfaceFacts facts; numbered_ > 0 && welds() && watch_.corners() == numbered_ && watch_.facts(facts))
    captured_.facts = facts;
  CapturedVertices result = std::move(captured_);
  captured_ = {};
  cursor_ = nullptr;
  limit_ = room_ = 0;
  kept_ = numbered_ = 0;
  welder_.forget();
  return result;
}

}  // namespace gluray::gl
