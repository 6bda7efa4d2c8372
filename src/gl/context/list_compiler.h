// Compiles and calls display lists: glNewList, glEndList, glCallList. A part of each Context, for stubs and
// handlers on its thread.
#pragma once
#include "gl/basics/failsafe.h"
#include "gl/capture/captured_vertices.h"
#include "gl/counts/draw_kinds.h"
#include "gl/shadow/shadow_state.h"

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
  /// Whether commands take effect now: always, except while a list is compiled with GL_COMPILE.
  bool executing() const { return !list_ || mode_ == GL_COMPILE_AND_EXECUTE; }
  /// Whether a list is being called.
  bool calling() const { return depth_ > 0; }
  /// Whether a step of the list that is compiled is being executed, and not one of a list that it calls.
  bool executesNow() const { return detached_ && depth_ == 0; }
  /// Whether draws that are compiled are later ones of a multi-draw.
  bool continuesMultiDraw() const { return continues_; }
  void continueMultiDraw(bool on) { continues_ = on; }
  GLuint name() const { return name_; }
  GLenum mode() const { return mode_; }

  /// Appends `call` to the list being compiled; inside its glBegin: misuse(). `anywhere`: when the list is
  /// called, it is legal between glBegin and glEnd.
  template <class F>
  void record(F&& call, bool anywhere = false);
  /// Lets the real OpenGL compile a fragment while `call` runs, and appends that.
  template <class F>
  void recordFragment(F&& call);
  /// Appends a fragment that the real OpenGL has compiled.
  void appendFragment(GLuint realList);
  /// Appends `op` to the list being compiled, and executes it if executing(). Null is ignored.
  void append(std::unique_ptr<ListOp>& op);
  /// Appends a run that has ended, without executing it. If this throws, `run` is unchanged.
  GeometryRun& add(CapturedVertices&& run, const SlotValues& finals, std::vector<InheritedSlot>&& inherited,
                   PrimitiveClass kind);
  /// Executes an appended step if executing().
  void executeAdded(ListOp& op);

  /// A command that is illegal inside glBegin: sets `error` if executing(), keeps it if compiling().
  void misuse(GLenum error = GL_INVALID_OPERATION);
  bool misused() const { return misused_ != GL_NO_ERROR; }
  /// Returns and clears the kept error, which the list raises when it is called, after the primitive.
  GLenum takeMisuse();

 private:
  template <class F>
  void runDetached(F&& body);
  /// The name of a real list that is open now; 0: it cannot be, and the error was raised.
  GLuint beginFragment();
  /// append(), once more if it throws.
  void appendInsisting(std::unique_ptr<ListOp>& op);

  std::shared_ptr<DisplayList> list_;
  GLuint name_ = 0;
  GLenum mode_ = 0;
  GLenum misused_ = GL_NO_ERROR;  // error of the first illegal command in the glBegin being compiled
  bool detached_ = false;
  bool continues_ = false;  // draws are later ones of a multi-draw
  int depth_ = 0;           // nesting of the lists being called
  Parts p_;
};

}  // namespace gluray::gl
