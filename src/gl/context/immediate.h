// glBegin, glVertex and glEnd: captured in runs (consecutive pairs of equal state), or left to the real
// OpenGL. A part of each Context, called by stubs and handlers on its thread.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/capture/captured_vertices.h"
#include "gl/capture/list_values.h"
#include "gl/capture/mesh_cache.h"
#include "gl/capture/vertex_stream.h"
#include "gl/context/passthrough_frames.h"
#include "gl/counts/draw_kinds.h"
#include "gl/draws/batch_filler.h"
#include "gl/draws/draws.h"
#include "gl/draws/raster_draws.h"
#include "gl/welding/when_to_weld.h"

#include <GL/gl.h>

#include <utility>
#include <vector>

namespace gluray::gl {

class Attention;
class ListCompiler;

class Immediate {
 public:
  struct Parts {
    BeginEnd& beginEnd;
    ShadowState& shadow;
    Failsafe& failsafe;
    FrameClock& clock;
    DrawCounts& counts;
    Classifier& classifier;
    BatchFiller& filler;
    RasterDraws& raster;
    Draws& draws;
    WindowFrames& window;
    PassthroughFrames& passthrough;
    ListCompiler& lists;
    Attention& attention;
  };
  Immediate(const Parts& parts, VertexStream::Welding welding) : p_(parts), welding_(welding) {}

  using Inside = BeginEnd::Inside;
  Inside inside() const { return p_.beginEnd.inside; }
  bool insideBegin() const { return p_.beginEnd.isInside(); }
  bool realInsideBegin() const { return p_.beginEnd.realIsInside(); }
  bool executedInside() const { return p_.beginEnd.executedInside(); }

  /// `arrays`: for a small draw from arrays.
  void begin(GLenum mode, bool arrays = false);
  void end();
  /// Whether begin() relies on an earlier answer of the real OpenGL, which the next command may change.
  bool reliesOnAnswer() const { return canBegin_ != kNoMode; }
  void forgetAnswer() { canBegin_ = kNoMode; }
  void attribute(Slot slot, const float* values);
  void vertex(float x, float y, float z, float w);
  void material(GLenum face, GLenum pname, const float* params);
  /// Appends a small primitive, `vertices` of the enabled arrays, to the run as if sent by glBegin.
  void drawSmall(GLenum mode, const std::vector<uint32_t>& vertices, DrawPath path);
  /// glArrayElement inside a rasterised glBegin.
  void rasterElement(GLint i);
  /// The newest current value of an attribute: the run's, the real OpenGL's in passthrough, or the context's.
  const float* current(Slot slot);

  // Runs. Outside lists a run is open from its first glBegin on; a list being compiled always has one.
  bool runOpen() const { return open_; }
  /// Whether attributes go into the run and nowhere else. In a list, ListValues also gets those that come
  /// outside glBegin and glEnd.
  bool takesAttributes() const { return p_.beginEnd.inside == Inside::captured || (open_ && !ofArrays_); }
  /// Ends the run and draws it, or records it in the list being compiled.
  void closeRun();
  void closeRunOutsideBegin() {
    if (!insideBegin()) closeRunIfOpen();
  }
  void closeRunIfOpen() {
    if (open_) closeRun();
  }
  /// Replays the run and the open primitive to the real OpenGL, which takes over from there.
  void surrender();

  // For the list compiler.
  VertexStream& stream() { return stream_; }
  /// Whether the run has vertices, or sets attributes that stay current after the list.
  bool holdsAnything() const { return !stream_.empty() || stream_.layout().mask != bit(kPosition); }
  void startRun();
  void recordRun();
  /// Records the run with its open primitive as a LooseRun; the rest of the primitive follows call by call.
  void loosen();
  // GL_COMPILE_AND_EXECUTE, around each executed step: restore the executed state, close its run, save it.
  void resumeExecuted() { p_.beginEnd.inside = std::exchange(p_.beginEnd.executed, Inside::nothing); }
  void settleExecuted() { inside() == Inside::captured ? surrender() : closeRunIfOpen(); }
  void leaveExecuted();
  /// After glEndList: no run is open.
  void idle();

 private:
  class RunDraw;

  bool canBegin(GLenum mode);
  bool askCanBegin(GLenum mode);
  void recordMisuse();
  void countOpenPrimitive();
  bool takesSlot(Slot slot);
  void addSlotToRun(Slot slot);
  void drawRun();
  KnownMesh meshOfRun();
  void keepRunValues();
  void sendRunValues();

  static constexpr GLenum kNoMode = ~GLenum{0};

  Parts p_;
  VertexStream::Welding welding_;
  WhenToWeld weld_;
  VertexStream stream_;
  bool open_ = false;         // stream_ holds a run outside lists
  bool hasElements_ = false;  // of the primitive that the real OpenGL draws: vertices of glArrayElement
  // The run consists of draws from arrays: current values are also sent when they are set.
  bool ofArrays_ = false;
  ListValues listValues_;                            // of a list's run
  PrimitiveClass class_ = PrimitiveClass::surfaces;  // of the run
  Reason reason_ = Reason::traced;                   // why the captured run will be rasterised
  DrawPath path_ = DrawPath::immediate;              // of the run's first draw: small array draws join runs
  GLenum canBegin_ = kNoMode;                        // the real OpenGL's glBegin of this mode succeeds
  Primitive openPrimitive_{};                        // of a rasterised glBegin: mode and vertices so far
  std::vector<InheritedSlot> inherited_;             // slots that a list's run takes from its caller
};

}  // namespace gluray::gl
