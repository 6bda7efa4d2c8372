// What a run of vertices in a list does to the current values that Mesa holds back (CurrentValues). Recorded
// by Immediate while a list is compiled, applied when the list is called. GL thread.
#pragma once
#include "gl/capture/vertex_stream.h"

#include <array>
#include <vector>

namespace gluray::gl {

/// Held-back values after a run, for each state of held-back values before it.
class ListEffect {
 public:
  struct Left {
    SlotMask set = 0;                   // held back: values that were last set outside glBegin and glEnd
    SlotMask stored = 0;                // stored, and not held back
    bool keepsOlder = true;             // what was held back before the run still is
    bool pending = false, due = false;  // as in CurrentValues::Held
    std::vector<std::array<float, 4>> values;  // of the slots of set and stored, in order
  };
  /// That of vertices which set nothing.
  ListEffect();
  const Left& after(bool pending, bool due) const { return left_[index(pending, due)]; }

 private:
  friend class ListValues;
  static size_t index(bool pending, bool due) { return (pending ? 1 : 0) + (due ? 2 : 0); }
  std::array<Left, 4> left_;
};

/// Records the effect. Mesa compiles vertices between calls of other kinds into one draw, which stores the
/// last vertex's values. An attribute that is new after some of these vertices starts another draw. Each draw
/// first stores values that were set before it. If such values were stored already, it lets go of them.
class ListValues {
 public:
  ListValues() { start(); }
  /// A run starts.
  void start();
  /// An attribute or material (kMaterialNumber) is set outside glBegin and glEnd.
  void set(const VertexStream& stream, Slot slot, const float* value);
  /// glBegin. `continues`: Mesa draws its vertices together with those of the run before.
  void begin(const VertexStream& stream, bool continues);
  /// After begin(): the vertices came from arrays, and current values are as before. Mesa stores none after
  /// them.
  void fromArrays(const VertexStream& stream);
  /// The stream is about to get a slot inside glBegin and glEnd.
  void addSlot(const VertexStream& stream);
  /// Whether vertices have come after the last call of another kind.
  bool isDrawing() const { return drawing_; }
  /// The run ends.
  void finish(const VertexStream& stream);
  /// The effect of the finished run, which the stream has given away.
  ListEffect effect(const CapturedVertices& run) const;

 private:
  /// After some calls of the run, for one state before it.
  struct State {
    ListEffect::Left left;
    SlotValues stored{};
    void draw(const SlotValues& set);
  };
  static constexpr size_t kBefore = 4;
  void draw();

  // With an additional draw before the first one (second half), or without.
  std::array<State, 2 * kBefore> states_;
  SlotValues set_{};  // last values set outside glBegin and glEnd
  bool drawing_ = false, continues_ = false;
  bool arraysLast_ = false;  // the last primitive came from arrays
  bool first_ = true;        // the current draw is the run's first one
  uint32_t from_ = 0;        // its first vertex
  SlotMask known_ = 0;       // slots that the stream had before it, with values before_
  SlotValues before_{};
  // Slots that the first draw has changed, of those that the stream had before it, and their values then.
  SlotMask changedFirst_ = 0;
  SlotValues beforeFirst_{};
};

}  // namespace gluray::gl
