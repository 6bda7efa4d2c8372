// What is sent by glBegin, glVertex and glEnd: captured in runs of as many pairs as share their state, or
// left to the real OpenGL. A part of each Context, for stubs and handlers on its thread.
#pragma once
#include "gl/batch/batch_filler.h"
#include "gl/capture/captured_vertices.h"
#include "gl/capture/mesh_cache.h"
#include "gl/capture/vertex_stream.h"
#include "gl/draws/draw_kinds.h"
#include "gl/draws/raster_draws.h"
#include "gl/draws/reasons.h"
#include "gl/welding/when_to_weld.h"
#include "gl/window/passthrough_frames.h"

#include <GL/gl.h>

#include <utility>
#include <vector>

namespace gluray::gl {

class Attention;
class ListCompiler;

class Immediate {
 public:
  struct Parts {
    ShadowState& shadow;
    Failsafe& failsafe;
    FrameClock& clock;
    DrawCounts& counts;
    Triage& triage;
    BatchFiller& filler;
    RasterDraws& raster;
    WindowFrames& window;
    PassthroughFrames& passthrough;
    ListCompiler& lists;
    Attention& attention;
  };
  Immediate(const Parts& parts, VertexStream::Welding welding) : p_(parts), welding_(welding) {}

  enum class Inside { nothing, captured, rasterised };
  Inside inside() const { return inside_; }
  bool insideBegin() const { return inside_ != Inside::nothing; }
  /// Whether the real OpenGL is between glBegin and glEnd of the program, rather than compiling them.
  bool realInsideBegin() const {
    return (inside_ == Inside::rasterised && !openFragment_) || executedInside();
  }
  /// Whether what a list that is compiled has executed so far is inside a glBegin, as far as the list goes it
  /// is not.
  bool executedInside() const { return executed_ != Inside::nothing; }

  void begin(GLenum mode);
  void end();
  void attribute(Slot slot, const float* values);
  void vertex(float x, float y, float z, float w);
  void material(GLenum face, GLenum pname, const float* params);
  /// A primitive of few vertices from the enabled arrays, joined to the run as if sent by glBegin.
  void drawSmall(GLenum mode, const std::vector<uint32_t>& vertices, DrawPath path);
  /// glArrayElement inside a rasterised glBegin.
  void rasterElement(GLint i);
  /// Current value of an attribute, from wherever it is newest.
  const float* current(Slot slot);

  // Runs. Outside lists a run is open from its first glBegin on; a list that is compiled always has one.
  bool runOpen() const { return open_; }
  /// Ends the run that is being captured and draws or records it.
  void closeRun();
  void closeRunOutsideBegin() {
    if (!insideBegin()) closeRunIfOpen();
  }
  void closeRunIfOpen() {
    if (open_) closeRun();
  }
  /// Gives the run, and the primitive that is open, to the real OpenGL.
  void surrender();

  // For the list compiler.
  VertexStream& stream() { return stream_; }
  /// Whether the run has vertices, or attributes that the list leaves behind.
  bool holdsAnything() const { return !stream_.empty() || stream_.layout().mask != bit(kPosition); }
  void startRun();
  void recordRun();
  /// Records the run and the primitive that is open, whose rest is recorded call by call.
  void loosen();
  // What is executed while a list is compiled goes on where it was left, ends for now, is left.
  void resumeExecuted() { inside_ = std::exchange(executed_, Inside::nothing); }
  void settleExecuted() { inside_ == Inside::captured ? surrender() : closeRunIfOpen(); }
  void leaveExecuted();
  /// No run is captured any more.
  void idle();

 private:
  /// An attribute that the real OpenGL does not have yet.
  void setCurrent(Slot slot, const float* values);
  void noteColor(Slot slot);
  bool canDraw() const;
  void recordMisuse();
  void countOpenPrimitive();
  void addSlotToRun(Slot slot);
  void drawRun();
  KnownMesh meshOfRun();
  void keepRunValues();
  void sendRunValues();

  Parts p_;
  VertexStream::Welding welding_;
  WhenToWeld weld_;
  VertexStream stream_;
  Inside inside_ = Inside::nothing;
  bool open_ = false;                                // stream_ holds a run outside lists
  PrimitiveClass class_ = PrimitiveClass::surfaces;  // of the run
  Reason reason_ = Reason::traced;                   // why the run is rasterised, captured though it is
  DrawPath path_ = DrawPath::immediate;              // small draws from arrays join runs
  Primitive openPrimitive_{};                        // of a rasterised glBegin: mode and vertices so far
  Inside executed_ = Inside::nothing;     // while a list is compiled, of what it has executed so far
  GLuint openFragment_ = 0;               // real list that takes the rest of a primitive that was given up
  std::vector<InheritedSlot> inherited_;  // by the run of a list
};

}  // namespace gluray::gl
