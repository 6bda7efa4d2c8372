// The quirk "material-latch". Mesa keeps materials set outside glBegin and glEnd until a draw or a question,
// and where GL_COLOR_MATERIAL is enabled in between it stores them once more at the next change of state,
// over what the current colour had just made of them (src/mesa/vbo, vbo_exec_FlushVertices keeps the
// attributes and marks them as unsent when only current values are flushed). Mesa 22.3 draws with what it
// stored; Mesa 25.0 stores the same, but draws with the current colour, as the specification says. Programs
// whose frames end with materials, as OpenSceneGraph's do, show it. Our write-back and questions come at
// other moments than their draws and would undo it: the materials are sent again afterwards, so that Mesa has
// them as waiting as before. Elsewhere that changes nothing. GL thread.
#pragma once
#include "gl/capture/captured_vertices.h"
#include "gl/real.h"

namespace gluray::gl {

class MaterialLatch {
 public:
  explicit MaterialLatch(bool on) : on_(on) {}
  /// Whether the current context's OpenGL draws with materials that were stored twice: a Mesa before 23.
  static bool isIn(const RealGl& real);
  bool isOn() const { return on_; }
  /// glMaterial was sent to the real OpenGL outside glBegin and glEnd.
  void sent(GLenum face, GLenum pname, const float* params) { waiting_.set(face, pname, params); }
  /// Materials were sent that belong to vertices of before: the real OpenGL stores them and is done with
  /// them.
  void letGo(const RealGl& real) const;
  /// glCallList: the real OpenGL stores what waits, and is done with it at its next change of state.
  void called(const RealGl& real) {
    if (!waiting_.front && !waiting_.back) return;
    letGo(real);
    drawn();
  }
  /// A draw: the real OpenGL has stored what was waiting.
  void drawn() { waiting_ = {}; }
  /// After a question or a draw of ours: what was waiting waits again.
  void restore(const RealGl& real) const;

 private:
  bool on_;                 // the quirk is switched on, and the real OpenGL needs it
  MaterialChange waiting_;  // since the last draw
};

}  // namespace gluray::gl
