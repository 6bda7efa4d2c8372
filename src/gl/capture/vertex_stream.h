// Collects the vertices of a run: consecutive glBegin/glEnd pairs of equal state. Owned by Immediate, GL
// thread; WeldBehind may weld on its own thread. The inline functions are the fast path of attribute calls.
#pragma once
#include "gl/capture/captured_vertices.h"
#include "gl/welding/stream_weld.h"
#include "gl/welding/weld_behind.h"

#include <cstring>

namespace gluray::gl {

class VertexStream {
 public:
  static constexpr uint32_t kNever = ~0u;
  enum class Welding { here, behind };  // on the calling thread, or on WeldBehind's if it can start

  /// Starts an empty run with the slots of `mask`. They have the `current` values until they are set. A run
  /// of separate triangles with at least `weldFrom` vertices is welded while more arrive: equal vertices are
  /// kept once, and the capture has indices.
  void start(SlotMask mask, const SlotValues& current, uint32_t weldFrom = kNever,
             Welding where = Welding::here);

  bool has(Slot slot) const { return captured_.layout.has(slot); }
  bool insidePrimitive() const { return insidePrimitive_; }
  /// Vertices sent since start(), duplicates included. Primitives count these.
  uint32_t sent() const { return captured_.vertexCount - kept_ + numbered_; }
  bool empty() const { return sent() == 0; }
  const VertexLayout& layout() const { return captured_.layout; }

  void begin(GLenum mode);
  void end();

  /// Whether vertex() may be called: inside a primitive, with space left, and no w to store.
  bool hasRoom() const { return captured_.vertexCount < limit_; }
  /// Appends a vertex with the values set so far. Only if hasRoom().
  void vertex(float x, float y, float z) {
    float* v = cursor_;
    v[0] = x, v[1] = y, v[2] = z;
    const uint32_t stride = captured_.layout.stride;
    // Loads single floats, as they were stored: store-to-load forwarding fails if a load is wider than the
    // store. May write into the array's slack.
    const volatile float* const rest = template_;
    v[3] = rest[3], v[4] = rest[4], v[5] = rest[5];
    for (uint32_t i = 6; i < stride; ++i) v[i] = rest[i];
    cursor_ = v + stride;
    ++captured_.vertexCount;
  }

  /// Appends a vertex with any w, and grows if needed. Throws std::bad_alloc.
  void vertexSlow(float x, float y, float z, float w);

  /// Sets a slot that the layout has. `values`: sizeOf(slot) floats.
  void set(Slot slot, const float* values) {
    std::memcpy(template_ + captured_.layout.offset[slot], values, sizeOf(slot) * 4);
  }
  /// Sets a slot that the layout has; values beyond the slot's size are ignored.
  void set(Slot slot, float x, float y, float z, float w) {
    float* const to = template_ + captured_.layout.offset[slot];
    to[0] = x;
    if (sizeOf(slot) > 1) to[1] = y, to[2] = z;
    if (sizeOf(slot) > 3) to[3] = w;
  }
  const float* get(Slot slot) const { return get(captured_.layout, slot); }
  /// The slot's value, in the layout of the run that takeRun() has just returned.
  const float* get(const VertexLayout& layout, Slot slot) const { return template_ + layout.offset[slot]; }

  /// Adds a slot; vertices already captured get the value `earlier`.
  void addSlot(Slot slot, const float* earlier);

  /// Adds a material change to the run's table, unless it equals the last one. Returns its number for the
  /// kMaterialNumber slot.
  float addMaterial(const MaterialChange& change);
  const MaterialChange* lastMaterial() const {
    return captured_.materials.empty() ? nullptr : &captured_.materials.back();
  }

  /// The open primitive, with the vertices so far.
  Primitive openPrimitive() const { return {mode_, first_, sent() - first_}; }
  CapturedVertices& captured() {
    numberAll();
    return captured_;
  }
  /// Returns the run; the stream is empty afterwards.
  CapturedVertices takeRun();

 private:
  void grow();
  void updateLimit();
  void relayout(SlotMask mask);
  bool welds() const { return weldFrom_ != kNever; }
  uint32_t nextWeld() const;
  void watch();
  void weldArrived();
  void weldBehind();
  void bringBack();
  void numberAll();
  void stopWelding();

  CapturedVertices captured_;  // while behind_ is active, only the vertices of the next piece
  uint32_t weldFrom_ = kNever;
  Welding where_ = Welding::here;
  uint32_t kept_ = 0;      // first vertices of captured_, which indices refer to; later ones have no index
  uint32_t numbered_ = 0;  // vertices sent that have an index, or were handed to behind_
  StreamWelder welder_;
  WeldBehind behind_;
  SurfaceWatch watch_;  // facts about the vertices that have an index or were handed to behind_
  float* cursor_ = nullptr;
  uint32_t room_ = 0;   // vertices that fit before grow() must be called
  uint32_t limit_ = 0;  // the same for vertex(); 0 while it must not be called
  bool insidePrimitive_ = false;
  GLenum mode_ = 0;
  uint32_t first_ = 0;                         // sent() at begin()
  alignas(16) float template_[128 + 16] = {};  // attributes of the next vertex; its position is unused
};

}  // namespace gluray::gl
