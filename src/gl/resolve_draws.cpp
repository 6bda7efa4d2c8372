// Multisampled framebuffers that are cleared, traced into and resolved: the Context's side of Unresolved.
#include "gl/clears.h"
#include "gl/context.h"
#include "gl/programs/uniforms.h"
#include "gl/state_queries.h"

#include <GL/glext.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gluray::gl {
namespace {

Unresolved::Attachment attachmentOf(const RealGl& real, GLenum target, GLenum attachment) {
  const auto type =
      static_cast<GLenum>(attachmentValue(real, target, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE));
  if (type == GL_NONE) return {};
  return {type, static_cast<GLuint>(
                    attachmentValue(real, target, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME))};
}

/// RGBA8, halves to even numbers as software OpenGLs have it.
uint32_t clearColor(const RealGl& real) {
  GLfloat color[4] = {};
  real.GetFloatv(GL_COLOR_CLEAR_VALUE, color);
  uint32_t result = 0;
  for (int c = 0; c < 4; ++c)
    result |= static_cast<uint32_t>(std::lrint(std::clamp(color[c], 0.0f, 1.0f) * 255)) << (8 * c);
  return result;
}

bool isSampledPerSample(GLenum type) {
  switch (type) {
    case GL_SAMPLER_2D_MULTISAMPLE:
    case GL_INT_SAMPLER_2D_MULTISAMPLE:
    case GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE:
    case GL_SAMPLER_2D_MULTISAMPLE_ARRAY:
    case GL_INT_SAMPLER_2D_MULTISAMPLE_ARRAY:
    case GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE_ARRAY: return true;
    default: return false;
  }
}

}  // namespace

Unresolved::Cleared Context::clearedBy(GLbitfield mask) {
  constexpr GLbitfield kBoth = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;
  if ((mask & kBoth) != kBoth || direct_ || aside_ || passthrough_ || activeQueries > 0 ||
      group_->contexts != 1 || !info_.settings.quirks.has(Quirk::softwareResolve) || !isSoftwareBelow())
    return {};
  refresh(kTarget);
  const TargetState& target = state.target;
  if (target.framebuffer == 0 || target.samples <= 1 || target.reason != Reason::traced ||
      target.wideColors || !clearsAll(real, state.rare))
    return {};
  for (const GLenum size : {GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE})
    if (attachmentValue(real, GL_DRAW_FRAMEBUFFER, target.drawBuffer, size) != 8) return {};
  return {target.framebuffer,
          target.drawBuffer,
          attachmentOf(real, GL_DRAW_FRAMEBUFFER, target.drawBuffer),
          attachmentOf(real, GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT),
          scissorBox(real),
          clearColor(real),
          target.depthResolution};
}

void Context::clearsSamples(const Unresolved::Cleared& cleared) {
  if (!unresolved_.waiting) return;
  const Unresolved::Cleared& waits = unresolved_.waiting->cleared;
  if (cleared.framebuffer == waits.framebuffer && cleared.drawBuffer == waits.drawBuffer &&
      cleared.covers(waits.box)) {
    unresolved_.waiting.reset();  // nobody will see it
    return;
  }
  refresh(kTarget);
  if (state.target.samples > 1) settle();
}

Unresolved::Cleared Context::beforeClear(GLbitfield mask) {
  const Unresolved::Cleared clean = clearedBy(mask);
  present(false);
  clearsShown(mask);
  clearsSamples(clean);
  return clean;
}

void Context::leave() {
  showLagged();
  const Unresolved::Cleared& cleared = unresolved_.cleared;
  if (batch_.empty()) return;
  const BatchKey& key = batch_.key();
  const scene::Region& r = key.region;
  const bool waits =
      cleared.framebuffer != 0 && key.framebuffer == cleared.framebuffer &&
      key.drawBuffer == cleared.drawBuffer && key.samples > 1 && key.layers == BatchKey::Layers::none &&
      (key.depthFunc == GL_LEQUAL || key.depthFunc == GL_LESS) && !aside_ && !direct_ && activeQueries == 0 &&
      group_->contexts == 1 && !batch_.waiting().wideColors && cleared.covers({r.x, r.y, r.width, r.height});
  if (!waits) return present(false);
  const Unresolved::Cleared kept = cleared;
  settle();
  Unresolved::Waiting waiting{kept, key, batch_.take(), batch_.takeProgramDraws()};
  passes_.flushed(waiting.snapshot);
  unresolved_.waiting = std::move(waiting);
}

void Context::settle() {
  settleShown();
  unresolved_.cleared = {};
  if (!unresolved_.waiting) return;
  Unresolved::Waiting waiting = std::move(*unresolved_.waiting);
  unresolved_.waiting.reset();
  presentLate(waiting.key, waiting.snapshot, std::move(waiting.draws), waiting.traced);
}

void Context::presentLate(const BatchKey& key, const scene::SnapshotPtr& snapshot,
                          std::vector<ProgramDraw> draws, bool known) {
  const bool objects = isPresent(real.BindFramebuffer);
  const GLuint bound = objects ? static_cast<GLuint>(integer(real, GL_DRAW_FRAMEBUFFER_BINDING)) : 0;
  const bool encodes = state.rare.framebufferSrgb && isOn(real, GL_FRAMEBUFFER_SRGB);
  if (encodes) real.Disable(GL_FRAMEBUFFER_SRGB);  // as it was when the program drew
  if (bound != key.framebuffer) real.BindFramebuffer(GL_DRAW_FRAMEBUFFER, key.framebuffer);
  const PresentResult result = presenter_.present(real, snapshot,
                                                  {.depthFunc = key.depthFunc,
                                                   .core = info_.core,
                                                   .programDraws = std::move(draws),
                                                   .mayRepeat = known || !measured()});
  if (bound != key.framebuffer) real.BindFramebuffer(GL_DRAW_FRAMEBUFFER, bound);
  if (encodes) real.Enable(GL_FRAMEBUFFER_SRGB);
  latch.restore(real);
  takeResult(result, known);
  if (result.outcome != PresentResult::traced)
    stepAside(result.why.empty() ? "the ray tracer could not make a picture" : result.why.c_str());
}

bool Context::readsSamples() {
  const GLuint name = state.raster.program;
  if (name == 0)
    return isPresent(real.BindProgramPipeline) && integer(real, GL_PROGRAM_PIPELINE_BINDING) != 0;
  const Program& program = group_->program(real, name, families())->program;
  return program.writes || std::any_of(program.uniforms.begin(), program.uniforms.end(),
                                       [](const auto& u) { return isSampledPerSample(u.second.type); });
}

void Context::samplesMeetRasterDraw() {
  settleShownBelow();
  unresolved_.cleared = {};
  if (!unresolved_.waiting) return;
  refresh(kTarget | kRaster);
  if (state.target.samples > 1 || readsSamples()) settle();
}

bool Context::resolveInto(ResolveTarget& target) {
  showLagged();
  Unresolved::Waiting& waiting = *unresolved_.waiting;
  target.core = info_.core;
  target.how.background = waiting.cleared.background;
  target.how.farthest = farthestHit(waiting.key.depthFunc, waiting.cleared.depthResolution);
  target.mayRepeat = waiting.traced || !measured();
  if (const GLenum pending = real.GetError()) setError(pending);
  forgetClear();
  const PresentResult result = presenter_.resolve(real, waiting.snapshot, target);
  latch.restore(real);
  if (result.outcome != PresentResult::traced) return false;
  takeResult(result, waiting.traced);
  waiting.traced = true;
  noteUse(Quirk::softwareResolve);
  return true;
}

bool Context::resolveByProgram(GLuint texture, const scene::Region& region) {
  if (!unresolved_.waiting || region.x != 0 || region.y != 0) return false;
  const glm::ivec2 size(region.width, region.height);
  const Unresolved::Waiting& waiting = *unresolved_.waiting;
  const KnownProgram& known = *state.program.known;
  const Family& family = *known.family;
  const ProgramUniform* sampler = known.program.uniform(family.passInput);
  if (!sampler || sampler->type != GL_SAMPLER_2D_MULTISAMPLE || !state.program.uniforms) return false;
  const UniformReader uniforms(known.program, *state.program.uniforms);
  const int samples = static_cast<int>(uniforms.number(family.passSamples, 0));
  if (samples != waiting.key.samples || !waiting.cleared.covers({0, 0, size.x, size.y})) return false;
  const GLint active = integer(real, GL_ACTIVE_TEXTURE);
  real.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(uniforms.integer(family.passInput)));
  const auto bound = static_cast<GLuint>(integer(real, GL_TEXTURE_BINDING_2D_MULTISAMPLE));
  glm::ivec2 boundSize(0);
  real.GetTexLevelParameteriv(GL_TEXTURE_2D_MULTISAMPLE, 0, GL_TEXTURE_WIDTH, &boundSize.x);
  real.GetTexLevelParameteriv(GL_TEXTURE_2D_MULTISAMPLE, 0, GL_TEXTURE_HEIGHT, &boundSize.y);
  real.ActiveTexture(static_cast<GLenum>(active));
  if (waiting.cleared.color != Unresolved::Attachment{GL_TEXTURE, bound} || boundSize != size) return false;
  ResolveTarget target;
  target.how.size = size;
  target.how.gamma = uniforms.number(family.passGamma, 1);
  target.depths = false;
  target.texture = texture;
  return resolveInto(target);
}

namespace {

/// Whether a blit of depths from the bound framebuffers is one that the real OpenGL would make.
bool haveEqualDepths(const RealGl& real) {
  const auto equal = [&](GLenum name) {
    return attachmentValue(real, GL_READ_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, name) ==
           attachmentValue(real, GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, name);
  };
  const auto stencil = [&](GLenum framebuffer) {
    return attachmentOf(real, framebuffer, GL_STENCIL_ATTACHMENT).type != GL_NONE;
  };
  return attachmentOf(real, GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT).type != GL_NONE &&
         equal(GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE) && equal(GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) &&
         stencil(GL_READ_FRAMEBUFFER) == stencil(GL_DRAW_FRAMEBUFFER);
}

}  // namespace

bool Context::resolveByBlit(const Blit& b) {
  const bool colors = b.mask & GL_COLOR_BUFFER_BIT, depths = b.mask & GL_DEPTH_BUFFER_BIT;
  const auto& waiting = unresolved_.waiting;
  const glm::ivec4 from(b.fromX0, b.fromY0, b.fromX1, b.fromY1), to(b.toX0, b.toY0, b.toX1, b.toY1);
  if (!waiting || b.mask & ~GLbitfield{GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT} || !(colors || depths) ||
      from != to || to.x != 0 || to.y != 0 || to.z <= 0 || to.w <= 0 || activeQueries > 0 ||
      (b.filter != GL_NEAREST && (b.filter != GL_LINEAR || depths)))
    return false;
  const Unresolved::Cleared& cleared = waiting->cleared;
  refresh(kTarget);
  const TargetState& target = state.target;
  const bool usable = target.reason == Reason::traced || (target.reason == Reason::noDepthBuffer && !depths);
  if (!usable || target.samples > 1 || target.wideColors || target.framebuffer == cleared.framebuffer ||
      (depths && target.framebuffer == 0) || !cleared.covers(to))
    return false;
  if (static_cast<GLuint>(integer(real, GL_READ_FRAMEBUFFER_BINDING)) != cleared.framebuffer ||
      static_cast<GLenum>(integer(real, GL_READ_BUFFER)) != cleared.drawBuffer)
    return false;
  const glm::ivec4 open = scissorBox(real);
  if (open.x > 0 || open.y > 0 || open.x + open.z < to.z || open.y + open.w < to.w ||
      (depths && !haveEqualDepths(real)))
    return false;
  ResolveTarget resolved;
  resolved.how.size = {to.z, to.w};
  resolved.colors = colors, resolved.depths = depths;
  return resolveInto(resolved);
}

bool Context::blitsSamples() {
  refresh(kTarget);
  if (state.target.samples > 1) return true;
  if (integer(real, GL_READ_FRAMEBUFFER_BINDING) == 0) return false;
  const Unresolved::Cleared& cleared = unresolved_.waiting->cleared;
  const auto buffer = static_cast<GLenum>(integer(real, GL_READ_BUFFER));
  const bool color = buffer != GL_NONE && attachmentOf(real, GL_READ_FRAMEBUFFER, buffer) == cleared.color;
  return color || attachmentOf(real, GL_READ_FRAMEBUFFER, GL_DEPTH_ATTACHMENT) == cleared.depth;
}

void Context::beforeBlit() noexcept {
  protect([&] {
    syncCurrent();
    flushBatch();
    if (unresolved_.waiting && blitsSamples()) settle();
    settleShown();
    unresolved_.cleared = {};
    sendBuffers();
  });
}

}  // namespace gluray::gl
