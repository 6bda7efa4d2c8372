// Draws of a context by kind, with counts and times, for `gluray explain`, without which it does not exist.
// The context's GL thread writes it; any thread may read it.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/capture/captured_vertices.h"
#include "gl/real/real.h"

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

/// The way in which vertices reach OpenGL.
enum class DrawPath : uint8_t { immediate, list, arrays, elements };
std::string_view describe(DrawPath path);
std::string_view describe(PrimitiveClass primitive);

/// State that distinguishes kinds of draws, as bits.
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

/// Totals of one kind of draw. `seconds`: time of the GL thread in GLuRay's code and in the real OpenGL,
/// without the tracing of batches.
struct DrawCost {
  uint64_t count = 0, triangles = 0;
  uint64_t culled = 0, leftOut = 0;  // culled draws, and their triangles that were not drawn
  double seconds = 0;
  DrawCost& operator+=(const DrawCost& other);
};

/// A framebuffer that was drawn into.
struct TargetUse {
  uint64_t traced = 0, rasterised = 0;  // draws
  int width = 0, height = 0, samples = 1;
  TargetUse& operator+=(const TargetUse& other);
};

/// A shader program that draws used.
struct ProgramUse {
  std::shared_ptr<const KnownProgram> program;
  uint64_t traced = 0, rasterised = 0;  // draws
  uint64_t triangles = 0;
  std::string why;  // explanation of the last draw refused for a program value
  ProgramUse& operator+=(const ProgramUse& other);
};

using KindTable = std::map<DrawKind, DrawCost>;
using TargetTable = std::map<GLuint, TargetUse>;  // by name; 0 is the window
using ProgramTable = std::map<const KnownProgram*, ProgramUse>;

class DrawKinds {
 public:
  /// `fixedFunction`: the context has fixed function, whose state is recorded, too.
  explicit DrawKinds(bool fixedFunction = true) : fixedFunction_(fixedFunction) {}
  /// Starts and stops the time of a draw; record() in between says which draw. May nest: an outer draw's time
  /// excludes inner draws.
  void start() noexcept;
  void stop() noexcept;
  /// Excludes `seconds` from the time of all open draws.
  void exclude(double seconds) noexcept;

  /// Records the open draw under its kind, and returns its state (DrawState, as bits). Reads the real
  /// OpenGL's state, so call it only outside glBegin and glEnd. If memory runs out, the draw is not recorded.
  /// `program`: the one in use, or null. `why`: ProgramState::why.
  uint32_t record(const RealGl& real, const TargetState& target, Reason reason, DrawPath path,
                  PrimitiveClass primitive, uint64_t triangles,
                  const std::shared_ptr<const KnownProgram>& program = nullptr,
                  const std::string& why = {}) noexcept;
  /// Reports that the draw recorded last was culled, and how many of its triangles were skipped.
  void culled(uint64_t leftOut) noexcept;
  /// Reason why this draw was not culled. Set only for draws above the size threshold.
  void notCulled(CullReason reason) noexcept;
  /// Reason why a rasterised draw was not lit. Set only if settings request light on rasterised draws.
  void notLit(LightReason reason) noexcept;
  /// Adds triangles to the draw recorded last.
  void addTriangles(uint64_t triangles) noexcept;
  /// Stops recording for good.
  void close() noexcept;

  KindTable kinds() const;
  /// Large draws that were not culled, by reason.
  std::map<CullReason, uint64_t> notCulled() const;
  /// Draws that got no light, by reason.
  std::map<LightReason, uint64_t> notLit() const;
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
  std::map<CullReason, uint64_t> notCulled_;
  std::map<LightReason, uint64_t> notLit_;
  TargetTable targets_;
  ProgramTable programs_;
  std::vector<Open> open_;
  DrawCost* last_ = nullptr;
  bool closed_ = false;
};

/// Calls start() and stop() around a block; `kinds` may be null.
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
