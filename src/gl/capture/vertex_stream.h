// Collects the vertices between glBegin and glEnd, over as many pairs as share their state ("a run").
// Used by the GL thread that owns the context; a thread of WeldBehind may help. The inline part is that of
// vertex attribute calls.
#pragma once
#include "gl/capture/captured_vertices.h"
#include "gl/welding/stream_weld.h"
#include "gl/welding/weld_behind.h"

#include <cstring>

namespace gluray::gl {

class VertexStream {
 public:
  static constexpr uint32_t kNever = ~0u;
  enum class Welding { here, behind };  // on the calling thread, or on another where there is one

  /// Starts an empty run that has the slots of `mask`, with `current` values for those not set before the
  /// first vertex. If it comes to `weldFrom` vertices, all of separate triangles, equal ones are found from
  /// then on while they arrive; the capture then has indices.
  void start(SlotMask mask, const SlotValues& current, uint32_t weldFrom = kNever,
             Welding where = Welding::here);

  bool has(Slot slot) const { return captured_.layout.has(slot); }
  bool insidePrimitive() const { return insidePrimitive_; }
  bool empty() const { return sent() == 0; }
  const VertexLayout& layout() const { return captured_.layout; }

  void begin(GLenum mode);
  void end();

  /// Whether vertex() may be called: inside a primitive, with space left, and no w to store.
  bool hasRoom() const { return captured_.vertexCount < limit_; }
  /// Appends a vertex with the values set so far. Only where hasRoom().
  void vertex(float x, float y, float z) {
    float* v = cursor_;
    v[0] = x, v[1] = y, v[2] = z;
    const uint32_t stride = captured_.layout.stride;
    // Single floats, as they were set: the processor hands on what has just been stored only where a load
    // asks for no more than one store has written. May write into the slack behind.
    const volatile float* const rest = template_;
    v[3] = rest[3], v[4] = rest[4], v[5] = rest[5];
    for (uint32_t i = 6; i < stride; ++i) v[i] = rest[i];
    cursor_ = v + stride;
    ++captured_.vertexCount;
  }

  /// The same for any w, growing as needed. Throws std::bad_alloc.
  void vertexSlow(float x, float y, float z, float w);

  /// Sets a slot that the layout has. `values` holds as many floats as the slot.
  void set(Slot slot, const float* values) {
    std::memcpy(template_ + captured_.layout.offset[slot], values, sizeOf(slot) * 4);
  }
  /// The same of as many of these as the slot has.
  void set(Slot slot, float x, float y, float z, float w) {
    float* const to = template_ + captured_.layout.offset[slot];
    to[0] = x;
    if (sizeOf(slot) > 1) to[1] = y, to[2] = z;
    if (sizeOf(slot) > 3) to[3] = w;
  }
  const float* get(Slot slot) const { return get(captured_.layout, slot); }
  /// The same for the layout of a run that was taken just now.
  const float* get(const VertexLayout& layout, Slot slot) const { return template_ + layout.offset[slot]; }

  /// Adds a slot; the vertices captured before get `earlier`.
  void addSlot(Slot slot, const float* earlier);

  /// Number of a material change for the kMaterialNumber slot, adding it to the run's table unless it is the
  /// last one.
  float addMaterial(const MaterialChange& change);
  const MaterialChange* lastMaterial() const {
    return captured_.materials.empty() ? nullptr : &captured_.materials.back();
  }

  /// The primitive between begin() and end() so far.
  Primitive openPrimitive() const { return {mode_, first_, sent() - first_}; }
  CapturedVertices& captured() {
    numberAll();
    return captured_;
  }
  /// Hands the run over; the stream is empty afterwards.
  CapturedVertices take();

 private:
  /// Vertices since the start, those that were found again included: what primitives count.
  uint32_t sent() const { return captured_.vertexCount - kept_ + numbered_; }
  void grow();
  void updateLimit();
  void relayout(SlotMask mask);
  bool welds() const { return weldFrom_ != kNever; }
  uint32_t nextWeld() const;
  void weldArrived();
  void weldBehind();
  void bringBack();
  void numberAll();
  void stopWelding();

  CapturedVertices captured_;  // while another thread welds, vertices of the piece that arrives
  uint32_t weldFrom_ = kNever;
  Welding where_ = Welding::here;
  uint32_t kept_ = 0;      // vertices that indices refer to; those behind have arrived since
  uint32_t numbered_ = 0;  // vertices sent that have indices, or get them from the other thread
  StreamWelder welder_;
  WeldBehind behind_;
  float* cursor_ = nullptr;
  uint32_t room_ = 0;   // vertices that fit before grow() must be called
  uint32_t limit_ = 0;  // the same for vertex attribute calls; 0 while it must not append
  bool insidePrimitive_ = false;
  GLenum mode_ = 0;
  uint32_t first_ = 0;                         // of the open primitive, in vertices sent
  alignas(16) float template_[128 + 16] = {};  // the next vertex; position unused
};

}  // namespace gluray::gl
