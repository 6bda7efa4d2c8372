#include "gl/counts/draw_kinds.h"

#include "base/clock.h"
#include "gl/state/state.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>

namespace gluray::gl {

std::string_view describe(DrawPath path) {
  constexpr std::string_view names[] = {"glBegin", "list", "arrays", "elements"};
  return names[static_cast<int>(path)];
}

std::string_view describe(PrimitiveClass primitive) {
  constexpr std::string_view names[] = {"points", "lines", "surfaces"};
  return names[static_cast<int>(primitive)];
}

std::vector<std::string_view> describeStates(uint32_t bits) {
  constexpr std::string_view names[] = {
#define X(id, text) text,
      GLURAY_DRAW_STATES(X)
#undef X
  };
  std::vector<std::string_view> set;
  for (size_t i = 0; i < std::size(names); ++i)
    if (bits >> i & 1) set.push_back(names[i]);
  return set;
}

DrawCost& DrawCost::operator+=(const DrawCost& o) {
  count += o.count, triangles += o.triangles, seconds += o.seconds;
  culled += o.culled, leftOut += o.leftOut;
  return *this;
}

TargetUse& TargetUse::operator+=(const TargetUse& o) {
  traced += o.traced, rasterised += o.rasterised;
  width = std::max(width, o.width), height = std::max(height, o.height),
  samples = std::max(samples, o.samples);
  return *this;
}

ProgramUse& ProgramUse::operator+=(const ProgramUse& o) {
  program = o.program;
  traced += o.traced, rasterised += o.rasterised, triangles += o.triangles;
  if (!o.why.empty()) why = o.why;
  return *this;
}

namespace {

/// Queries the bits of DrawState from the real OpenGL, whose state is always current.
class StateReader {
 public:
  StateReader(const RealGl& real, bool fixedFunction) : real_(real), fixedFunction_(fixedFunction) {}

  uint32_t read(const TargetState& target) {
    GLint polygon[2] = {GL_FILL, GL_FILL};
    real_.GetIntegerv(GL_POLYGON_MODE, polygon);
    if (fixedFunction_) readFixedFunction();
    put(DrawState::program, isPresent(real_.UseProgram) && integer(GL_CURRENT_PROGRAM));
    capability(GL_BLEND, DrawState::blend);
    put(DrawState::noDepthTest, !real_.IsEnabled(GL_DEPTH_TEST));
    put(DrawState::noDepthWrites, !integer(GL_DEPTH_WRITEMASK));
    capability(GL_STENCIL_TEST, DrawState::stencil);
    capability(GL_CULL_FACE, DrawState::cull);
    put(DrawState::polygonMode, polygon[0] != GL_FILL || polygon[1] != GL_FILL);
    capability(GL_POLYGON_OFFSET_FILL, DrawState::polygonOffset);
    for (GLenum plane = GL_CLIP_PLANE0; plane < GL_CLIP_PLANE0 + 6; ++plane)
      capability(plane, DrawState::clipPlanes);
    capability(GL_COLOR_LOGIC_OP, DrawState::logicOp);
    put(DrawState::multisample, target.samples > 1);
    put(DrawState::framebufferObject, target.framebuffer != 0);
    return bits_;
  }

 private:
  /// In core profiles these queries would raise errors that the program sees.
  void readFixedFunction() {
    const bool lit = capability(GL_LIGHTING, DrawState::lighting);
    put(DrawState::twoSided, lit && integer(GL_LIGHT_MODEL_TWO_SIDE));
    put(DrawState::colorMaterial, lit && real_.IsEnabled(GL_COLOR_MATERIAL));
    put(DrawState::flat, integer(GL_SHADE_MODEL) == GL_FLAT);
    put(DrawState::texture, real_.IsEnabled(GL_TEXTURE_2D) || real_.IsEnabled(GL_TEXTURE_1D));
    capability(GL_ALPHA_TEST, DrawState::alphaTest);
    capability(GL_FOG, DrawState::fog);
  }
  void put(DrawState state, bool on) {
    if (on) bits_ |= uint32_t{1} << static_cast<uint32_t>(state);
  }
  bool capability(GLenum name, DrawState state) {
    const bool on = real_.IsEnabled(name) != GL_FALSE;
    put(state, on);
    return on;
  }
  GLint integer(GLenum name) const {
    GLint value[4] = {};
    real_.GetIntegerv(name, value);
    return value[0];
  }
  const RealGl& real_;
  const bool fixedFunction_;
  uint32_t bits_ = 0;
};

TargetUse useOf(const RealGl& real, const TargetState& target, bool traced) {
  GLint viewport[4] = {};
  real.GetIntegerv(GL_VIEWPORT, viewport);
  TargetUse use;
  (traced ? use.traced : use.rasterised) = 1;
  use.samples = target.samples;
  use.width = target.size.x > 0 ? target.size.x : viewport[0] + viewport[2];
  use.height = target.size.y > 0 ? target.size.y : viewport[1] + viewport[3];
  return use;
}

}  // namespace

void DrawKinds::start() noexcept {
  constexpr size_t kDeepest = 256;  // lists nest 64 deep
  const std::lock_guard lock(mutex_);
  if (open_.capacity() == 0) {
    try {
      open_.reserve(kDeepest);
    } catch (...) { return; }
  }
  if (open_.size() < open_.capacity()) open_.push_back({nowSeconds(), nullptr});
}

void DrawKinds::stop() noexcept {
  const std::lock_guard lock(mutex_);
  if (open_.empty()) return;
  const double seconds = nowSeconds() - open_.back().start;
  if (open_.back().cost && !closed_) open_.back().cost->seconds += seconds;
  open_.pop_back();
  for (Open& outer : open_) outer.start += seconds;
}

void DrawKinds::exclude(double seconds) noexcept {
  const std::lock_guard lock(mutex_);
  for (Open& open : open_) open.start += seconds;
}

uint32_t DrawKinds::record(const RealGl& real, const TargetState& target, Reason reason, DrawPath path,
                           PrimitiveClass primitive, uint64_t triangles,
                           const std::shared_ptr<const KnownProgram>& program,
                           const std::string& why) noexcept {
  const std::lock_guard lock(mutex_);
  last_ = nullptr;
  if (closed_) return 0;
  const uint32_t state = StateReader(real, fixedFunction_).read(target);
  try {
    DrawCost& cost = kinds_[{primitive, path, reason, state}];
    ++cost.count;
    cost.triangles += triangles;
    last_ = &cost;
    if (!open_.empty()) open_.back().cost = &cost;
    const bool traced = reason == Reason::traced;
    targets_[target.framebuffer] += useOf(real, target, traced);
    if (program) programs_[program.get()] += {program, traced ? 1u : 0u, traced ? 0u : 1u, triangles, why};
  } catch (...) {  // not recorded
  }
  return state;
}

void DrawKinds::culled(uint64_t leftOut) noexcept {
  const std::lock_guard lock(mutex_);
  if (last_ && !closed_) ++last_->culled, last_->leftOut += leftOut;
}

void DrawKinds::notCulled(CullReason reason) noexcept {
  const std::lock_guard lock(mutex_);
  try {
    if (!closed_) ++notCulled_[reason];
  } catch (...) {}  // not counted
}

void DrawKinds::notLit(LightReason reason) noexcept {
  const std::lock_guard lock(mutex_);
  try {
    if (!closed_) ++notLit_[reason];
  } catch (...) {}  // not counted
}

void DrawKinds::addTriangles(uint64_t triangles) noexcept {
  const std::lock_guard lock(mutex_);
  if (last_ && !closed_) last_->triangles += triangles;
}

void DrawKinds::close() noexcept {
  const std::lock_guard lock(mutex_);
  closed_ = true;
}

KindTable DrawKinds::kinds() const {
  const std::lock_guard lock(mutex_);
  return kinds_;
}

std::map<CullReason, uint64_t> DrawKinds::notCulled() const {
  const std::lock_guard lock(mutex_);
  return notCulled_;
}

std::map<LightReason, uint64_t> DrawKinds::notLit() const {
  const std::lock_guard lock(mutex_);
  return notLit_;
}

ProgramTable DrawKinds::programs() const {
  const std::lock_guard lock(mutex_);
  return programs_;
}

TargetTable DrawKinds::targets() const {
  const std::lock_guard lock(mutex_);
  return targets_;
}

}  // namespace gluray::gl
