// What a context draws, by kind, for `gluray explain`. There only while somebody explains. Written by the GL
// thread that has the context; read by any.
#pragma once
#include "gl/capture/captured_vertices.h"
#include "gl/draws/reasons.h"
#include "gl/real.h"

#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string_view>
#include <vector>

namespace gluray::gl {

struct TargetState;
struct KnownProgram;

/// How vertices reach OpenGL.
enum class DrawPath : uint8_t { immediate, list, arrays, elements };
std::string_view describe(DrawPath path);
std::string_view describe(PrimitiveClass primitive);

/// State that tells kinds of draws apart, as bits.
#define GLURAY_DRAW_STATES(X)         \
  X(lighting, "lighting")             \
  X(twoSided, "two-sided")            \
  X(colorMaterial, "colour material") \
  X(flat, "flat")                     \
  X(texture, "texture")               \
  X(program, "program")               \
  X(blend, "blend")                   \
  X(alphaTest, "alpha test")          \
  X(noDepthTest, "no depth test")     \
  X(noDepthWrites, "no depth writes") \
  X(stencil, "stencil")               \
  X(fog, "fog")                       \
  X(cull, "cull")                     \
  X(polygonMode, "polygon mode")      \
  X(polygonOffset, "polygon offset")  \
  X(clipPlanes, "clip planes")        \
  X(logicOp, "logic op")              \
  X(multisample, "multisample")       \
  X(framebufferObject, "framebuffer object")

enum class DrawState : uint32_t {
#define X(id, text) id,
  GLURAY_DRAW_STATES(X)
#undef X
};
/// The names of the bits that are set.
std::vector<std::string_view> describeStates(uint32_t bits);

struct DrawKind {
  PrimitiveClass primitive = PrimitiveClass::surfaces;
  DrawPath path = DrawPath::immediate;
  Reason reason = Reason::traced;
  uint32_t state = 0;
  auto operator<=>(const DrawKind&) const = default;
};

/// Draws of one kind. Seconds are those of the GL thread inside our calls and those of the real OpenGL,
/// without the tracing of batches.
struct DrawCost {
  uint64_t count = 0, triangles = 0;
  double seconds = 0;
  DrawCost& operator+=(const DrawCost& other);
};

/// A framebuffer that was drawn into.
struct TargetUse {
  uint64_t traced = 0, rasterised = 0;  // draws
  int width = 0, height = 0, samples = 1;
  TargetUse& operator+=(const TargetUse& other);
};

/// A shader program that was drawn with.
struct ProgramUse {
  std::shared_ptr<const KnownProgram> program;
  uint64_t traced = 0, rasterised = 0;  // draws
  uint64_t triangles = 0;
  std::string why;  // of the last draw that was refused for a value of the program's
  ProgramUse& operator+=(const ProgramUse& other);
};

using KindTable = std::map<DrawKind, DrawCost>;
using TargetTable = std::map<GLuint, TargetUse>;  // by name; 0 is the window
using ProgramTable = std::map<const KnownProgram*, ProgramUse>;

class DrawKinds {
 public:
  /// `fixedFunction`: the context has it, and is asked for its state.
  explicit DrawKinds(bool fixedFunction = true) : fixedFunction_(fixedFunction) {}
  /// A draw starts and ends; what is recorded in between is the draw. May nest: inner ones are not charged to
  /// outer.
  void start() noexcept;
  void stop() noexcept;
  /// Time of the open draw that is not its own.
  void exclude(double seconds) noexcept;

  /// The draw that is open is of this kind. Reads the state that tells, so outside glBegin and glEnd only. A
  /// failure (no memory) costs a row of the table. `program`: the one in use, or null. `why`:
  /// ProgramState::why.
  void record(const RealGl& real, const TargetState& target, Reason reason, DrawPath path,
              PrimitiveClass primitive, uint64_t triangles,
              const std::shared_ptr<const KnownProgram>& program = nullptr,
              const std::string& why = {}) noexcept;
  /// More triangles of the draw recorded last.
  void addTriangles(uint64_t triangles) noexcept;
  /// Nothing is recorded from now on.
  void close() noexcept;

  KindTable kinds() const;
  TargetTable targets() const;
  ProgramTable programs() const;

 private:
  const bool fixedFunction_;
  struct Open {
    double start = 0;
    DrawCost* cost = nullptr;
  };
  mutable std::mutex mutex_;
  KindTable kinds_;
  TargetTable targets_;
  ProgramTable programs_;
  std::vector<Open> open_;
  DrawCost* last_ = nullptr;
  bool closed_ = false;
};

/// start() and stop() around a block, where somebody explains.
class DrawTimer {
 public:
  explicit DrawTimer(DrawKinds* kinds) : kinds_(kinds) {
    if (kinds_) [[unlikely]]
      kinds_->start();
  }
  ~DrawTimer() {
    if (kinds_) [[unlikely]]
      kinds_->stop();
  }
  DrawTimer(const DrawTimer&) = delete;
  DrawTimer& operator=(const DrawTimer&) = delete;

 private:
  DrawKinds* kinds_;
};

}  // namespace gluray::gl
