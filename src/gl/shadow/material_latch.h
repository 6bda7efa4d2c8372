// The quirk "material-latch". Mesa holds back materials set outside glBegin and glEnd until a draw or query.
// If GL_COLOR_MATERIAL is enabled in between, Mesa stores them again at the next state change, over the
// values that the current colour has just set (src/mesa/vbo: vbo_exec_FlushVertices keeps the attributes and
// marks them as unsent when only current values are flushed). Mesa 22.3 draws with the stored values. Mesa
// 25.0 stores the same, but draws with the current colour, as specified. Programs whose frames end with
// materials show the difference, such as OpenSceneGraph's. GLuRay's write-back and queries come at other
// times than the program's draws and would change the result. So GLuRay sends the materials again afterwards,
// and Mesa holds them back as before. With other implementations this changes nothing. Part of ShadowState,
// GL thread.
#pragma once
#include "gl/capture/captured_vertices.h"
#include "gl/capture/current_values.h"
#include "gl/real/real.h"

namespace gluray::gl {

class MaterialLatch {
 public:
  MaterialLatch(bool on, const CurrentValues& current) : on_(on), current_(current) {}
  /// Whether the current context's OpenGL draws with materials that were stored again: a Mesa before 23.
  static bool isIn(const RealGl& real);
  bool isOn() const { return on_; }
  /// Records glMaterial calls sent to the real OpenGL outside glBegin and glEnd.
  void sent(GLenum face, GLenum pname, const float* params) {
    if (on_) waiting_.set(face, pname, params);
  }
  /// Whether materials were sent since the last draw.
  bool waits() const { return waiting_.front | waiting_.back; }
  /// Call after materials of earlier vertices were sent: makes the real OpenGL store and forget them.
  void letGo(const RealGl& real) const;
  /// Reports glCallList: the real OpenGL stores held-back materials, and forgets them at its next state
  /// change.
  void called(const RealGl& real) {
    if (!waiting_.front && !waiting_.back) return;
    letGo(real);
    drawn();
    current_.restore(real);
  }
  /// Reports a draw: the real OpenGL has stored the held-back materials.
  void drawn() {
    if (waiting_.front | waiting_.back) waiting_ = {};
  }
  /// Call after a query or draw by GLuRay: sends the materials and current values again, so that the real
  /// OpenGL holds them back again.
  void restore(const RealGl& real) const;

 private:
  void restoreMaterials(const RealGl& real) const;

  bool on_;  // the quirk is switched on, and the real OpenGL needs it
  const CurrentValues& current_;
  MaterialChange waiting_;  // materials sent since the last draw
};

}  // namespace gluray::gl
