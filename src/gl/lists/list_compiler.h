// Compiles and calls display lists: glNewList, glEndList, glCallList. A part of each Context, for stubs and
// handlers on its thread.
#pragma once
#include "gl/capture/captured_vertices.h"
#include "gl/draws/draw_kinds.h"
#include "gl/failsafe.h"
#include "gl/state/shadow_state.h"

#include <GL/gl.h>

#include <memory>
#include <vector>

namespace gluray::gl {

class Attention;
class Context;
class FrameClock;
class Immediate;
class DisplayList;
class GeometryRun;
class ListOp;

class ListCompiler {
 public:
  struct Parts {
    Context& context;
    ShadowState& shadow;
    Failsafe& failsafe;
    FrameClock& clock;
    Immediate& immediate;
    Attention& attention;
  };
  explicit ListCompiler(const Parts& parts) : p_(parts) {}

  void newList(GLuint name, GLenum mode);
  void endList();
  void callList(GLuint name);
  GLuint base = 0;  // glListBase

  bool compiling() const { return list_ != nullptr; }
  /// Whether commands have effect now: always, but while a list is only compiled.
  bool executing() const { return !list_ || mode_ == GL_COMPILE_AND_EXECUTE; }
  /// Whether a list is being called.
  bool calling() const { return depth_ > 0; }
  GLuint name() const { return name_; }
  GLenum mode() const { return mode_; }

  /// Takes a call into the list under construction. `anywhere`: it may be executed between glBegin and glEnd.
  template <class F>
  void record(F&& call, bool anywhere = false);
  /// The same of what the real OpenGL compiles while `call` runs.
  template <class F>
  void recordFragment(F&& call);
  /// The same for a list of the real OpenGL.
  void appendFragment(GLuint realList);
  /// Takes `op` into the list under construction, and executes it where the mode says so. Null is ignored.
  void append(std::unique_ptr<ListOp>& op);
  /// The same of a run that has ended, whose vertices are left alone where it fails. Not executed.
  GeometryRun& add(CapturedVertices&& run, const SlotValues& finals, std::vector<InheritedSlot>&& inherited,
                   PrimitiveClass kind);
  /// Executes what has been taken into the list, where the mode says so.
  void executeAdded(ListOp& op);

  /// A command that is wrong inside a glBegin: an error of now, but where that is only compiled, and of the
  /// moment when the list is called.
  void misuse(GLenum error = GL_INVALID_OPERATION);
  /// That error, at the end of the primitive.
  GLenum takeMisuse();

 private:
  template <class F>
  void runDetached(F&& body);

  std::shared_ptr<DisplayList> list_;
  GLuint name_ = 0;
  GLenum mode_ = 0;
  GLenum misused_ = GL_NO_ERROR;  // by the first wrong command inside the glBegin that is compiled
  int depth_ = 0;                 // of lists that call lists
  Parts p_;
};

}  // namespace gluray::gl
