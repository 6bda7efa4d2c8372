#include "gl/flush/resolve_draws.h"

#include "gl/batch/clears.h"
#include "gl/framebuffers/composed_views.h"
#include "gl/framebuffers/depth_copy.h"
#include "gl/programs/uniforms.h"
#include "gl/real/debug_silence.h"
#include "gl/real/errors.h"
#include "gl/real/state_queries.h"
#include "gl/window/window_frames.h"

#include <GL/glext.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gluray::gl {
namespace {

UnresolvedImage::Attachment attachmentOf(const RealGl& real, GLenum target, GLenum attachment) {
  const auto type =
      static_cast<GLenum>(attachmentValue(real, target, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE));
  if (type == GL_NONE) return {};
  return {type, static_cast<GLuint>(
                    attachmentValue(real, target, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME))};
}

/// Size in pixels of the multisampled texture that is bound to the active unit.
glm::ivec2 boundSamplesSize(const RealGl& real) {
  glm::ivec2 size(0);
  real.GetTexLevelParameteriv(GL_TEXTURE_2D_MULTISAMPLE, 0, GL_TEXTURE_WIDTH, &size.x);
  real.GetTexLevelParameteriv(GL_TEXTURE_2D_MULTISAMPLE, 0, GL_TEXTURE_HEIGHT, &size.y);
  return size;
}

/// Size in pixels of a multisampled attachment; {0, 0}: not known. Call Errors::keepPending() before.
glm::ivec2 sizeOf(const RealGl& real, const UnresolvedImage::Attachment& image) {
  if (image.type == GL_RENDERBUFFER) return renderbufferSize(real, image.name);
  const GLint bound = integer(real, GL_TEXTURE_BINDING_2D_MULTISAMPLE);
  real.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, image.name);  // an error for an array's layer
  const glm::ivec2 size = boundSamplesSize(real);
  real.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, static_cast<GLuint>(bound));
  return real.GetError() == GL_NO_ERROR ? size : glm::ivec2(0);
}

/// The clear colour as RGBA8, rounded half to even as software OpenGLs do.
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

UnresolvedImage::Cleared ResolveDraws::clearedBy(GLbitfield mask) {
  constexpr GLbitfield kBoth = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;
  if ((mask & kBoth) != kBoth || p_.clock.passesThrough() || p_.failsafe.aside() || p_.shadow.info.off ||
      p_.shadow.activeQueries > 0 || p_.shadow.group.contexts != 1 ||
      !p_.shadow.settings.quirks.has(Quirk::softwareResolve) || !p_.shadow.isSoftwareBelow())
    return {};
  const TargetState& target = p_.shadow.target();
  if (target.framebuffer == 0 || target.samples <= 1 || target.reason != Reason::traced ||
      target.wideColors || !clearsAll(p_.shadow.real, p_.shadow.rare()))
    return {};
  for (const GLenum size : {GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE})
    if (attachmentValue(p_.shadow.real, GL_DRAW_FRAMEBUFFER, target.drawBuffer, size) != 8) return {};
  for (const GLenum image : {target.drawBuffer, GLenum{GL_DEPTH_ATTACHMENT}})
    if (p_.shadow.images.mayBeDeleted(p_.shadow.real, GL_DRAW_FRAMEBUFFER, image)) return {};
  return {target.framebuffer,
          target.drawBuffer,
          attachmentOf(p_.shadow.real, GL_DRAW_FRAMEBUFFER, target.drawBuffer),
          attachmentOf(p_.shadow.real, GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT),
          scissorBox(p_.shadow.real),
          clearColor(p_.shadow.real),
          target.depthResolution};
}

void ResolveDraws::clears(const UnresolvedImage::Cleared& cleared) {
  if (!p_.pending.unresolved.waiting) return;
  const UnresolvedImage::Cleared& waits = p_.pending.unresolved.waiting->cleared;
  if (cleared.framebuffer == waits.framebuffer && cleared.drawBuffer == waits.drawBuffer &&
      cleared.covers(waits.box)) {
    p_.pending.unresolved.waiting.reset();  // the clear hides it
    return;
  }
  if (p_.shadow.target().samples > 1) settleAll();
}

bool ResolveDraws::hold() {
  const UnresolvedImage::Cleared& cleared = p_.pending.unresolved.cleared;
  const BatchKey& key = p_.pending.batch.key();
  const scene::Region& r = key.region;
  const bool waits = cleared.framebuffer != 0 && key.framebuffer == cleared.framebuffer &&
                     key.drawBuffer == cleared.drawBuffer && key.samples > 1 &&
                     key.layers == BatchKey::Layers::none && key.colorWrites.all() &&
                     (key.depthFunc == GL_LEQUAL || key.depthFunc == GL_LESS) && !p_.failsafe.aside() &&
                     !p_.clock.passesThrough() && p_.shadow.activeQueries == 0 &&
                     p_.shadow.group.contexts == 1 && !p_.pending.batch.waiting().wideColors &&
                     cleared.covers({r.x, r.y, r.width, r.height});
  if (!waits) return false;
  const UnresolvedImage::Cleared kept = cleared;
  settleAll();
  p_.pending.attachSecondaryScene();
  p_.pending.unresolved.waiting.emplace(UnresolvedImage::Waiting{kept, p_.pending.hold("until resolved")});
  return true;
}

void ResolveDraws::settle() {
  p_.pending.unresolved.cleared = {};
  if (!p_.pending.unresolved.waiting) return;
  UnresolvedImage::Waiting waiting = std::move(*p_.pending.unresolved.waiting);
  p_.pending.unresolved.waiting.reset();
  p_.pending.presentLate(std::move(waiting.batch), waiting.traced);
}

void ResolveDraws::settleAll() {
  p_.composed.settle();
  p_.window.settle();
  settle();
}

void ResolveDraws::meetBlit() {
  if (p_.pending.unresolved.waiting && blitsSamples()) settleAll();
  p_.pending.unresolved.cleared = {};
}

bool ResolveDraws::readsSamples() {
  const GLuint name = p_.shadow.raster().program;
  if (name == 0) return programPipeline(p_.shadow.real, p_.shadow.rare().pipelines) != 0;
  const Program& program = p_.shadow.currentProgram.known(name)->program;
  return program.writes || std::any_of(program.uniforms.begin(), program.uniforms.end(),
                                       [](const auto& u) { return isSampledPerSample(u.second.type); });
}

void ResolveDraws::meetRasterDraw() {
  p_.pending.unresolved.cleared = {};
  if (!p_.pending.unresolved.waiting) return;
  p_.shadow.refresh(kTarget | kRaster);
  if (p_.shadow.target().samples > 1 || readsSamples()) settleAll();
}

bool ResolveDraws::into(ResolveTarget& target) {
  p_.window.meetDraw();
  UnresolvedImage::Waiting& waiting = *p_.pending.unresolved.waiting;
  if (!waiting.traced) waiting.batch.snapshot = p_.surfaces.views.broughtUpToDate(waiting.batch.snapshot);
  target.core = p_.shadow.info.core;
  target.how.background = waiting.cleared.background;
  target.how.farthest = farthestHit(waiting.batch.key.depthFunc, waiting.cleared.depthResolution);
  target.wish = p_.clock.wish(waiting.traced);
  p_.shadow.errors.keepPending();
  p_.cleared.forget();
  p_.shadow.current.shelve(p_.shadow.real);
  const PresentResult result = p_.pending.presenter.resolve(p_.shadow.real, waiting.batch.snapshot, target);
  if (result.outcome != PresentResult::traced) return p_.shadow.latch.restore(p_.shadow.real), false;
  p_.pending.takeResult(result, waiting.traced);
  waiting.traced = true;
  noteUse(Quirk::softwareResolve);
  return true;
}

bool ResolveDraws::byProgram(GLuint texture, const scene::Region& region) {
  if (!p_.pending.unresolved.waiting || !p_.pending.batch.empty() || region.x != 0 || region.y != 0)
    return false;
  const glm::ivec2 size(region.width, region.height);
  const UnresolvedImage::Waiting& waiting = *p_.pending.unresolved.waiting;
  const KnownProgram& known = *p_.shadow.program().known;
  const Family& family = *known.family;
  const ProgramUniform* sampler = known.program.uniform(family.passInput);
  if (!sampler || sampler->type != GL_SAMPLER_2D_MULTISAMPLE || !p_.shadow.program().uniforms) return false;
  const UniformReader uniforms(known.program, *p_.shadow.program().uniforms, known.placeholders);
  const int samples = static_cast<int>(uniforms.number(family.passSamples, 0));
  if (samples != waiting.batch.key.samples || !waiting.cleared.covers({0, 0, size.x, size.y})) return false;
  const GLint active = integer(p_.shadow.real, GL_ACTIVE_TEXTURE);
  p_.shadow.real.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(uniforms.integer(family.passInput)));
  const auto bound = static_cast<GLuint>(integer(p_.shadow.real, GL_TEXTURE_BINDING_2D_MULTISAMPLE));
  const glm::ivec2 boundSize = boundSamplesSize(p_.shadow.real);
  p_.shadow.real.ActiveTexture(static_cast<GLenum>(active));
  if (waiting.cleared.color != UnresolvedImage::Attachment{GL_TEXTURE, bound} || boundSize != size)
    return false;
  ResolveTarget target;
  target.how.size = size;
  target.how.gamma = uniforms.number(family.passGamma, 1);
  target.depths = false;
  target.texture = texture;
  return into(target);
}

namespace {

/// Whether the real OpenGL would accept a blit of depths between the bound framebuffers.
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

bool ResolveDraws::byBlit(const Blit& b) {
  const bool colors = b.mask & GL_COLOR_BUFFER_BIT, depths = b.mask & GL_DEPTH_BUFFER_BIT;
  const auto& waiting = p_.pending.unresolved.waiting;
  const glm::ivec4 from(b.fromX0, b.fromY0, b.fromX1, b.fromY1), to(b.toX0, b.toY0, b.toX1, b.toY1);
  if (!waiting || !p_.pending.batch.empty() ||
      b.mask & ~GLbitfield{GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT} || !(colors || depths) || from != to ||
      to.x != 0 || to.y != 0 || to.z <= 0 || to.w <= 0 || p_.shadow.activeQueries > 0 ||
      (b.filter != GL_NEAREST && (b.filter != GL_LINEAR || depths)))
    return false;
  const UnresolvedImage::Cleared& cleared = waiting->cleared;
  const TargetState& target = p_.shadow.target();
  const bool usable = target.reason == Reason::traced || (target.reason == Reason::noDepthBuffer && !depths);
  if (!usable || target.samples > 1 || target.wideColors || target.framebuffer == cleared.framebuffer ||
      (depths && target.framebuffer == 0) || !cleared.covers(to))
    return false;
  if (static_cast<GLuint>(integer(p_.shadow.real, GL_READ_FRAMEBUFFER_BINDING)) != cleared.framebuffer ||
      static_cast<GLenum>(integer(p_.shadow.real, GL_READ_BUFFER)) != cleared.drawBuffer)
    return false;
  p_.shadow.errors.keepPending();
  const DebugSilence silence(p_.shadow.real, p_.shadow.rare().debugOutput);
  const glm::ivec2 size = sizeOf(p_.shadow.real, cleared.color);  // the same as of its depth
  if (size.x < to.z || size.y < to.w) return false;
  const glm::ivec4 open = scissorBox(p_.shadow.real);
  if (open.x > 0 || open.y > 0 || open.x + open.z < to.z || open.y + open.w < to.w ||
      (depths && !haveEqualDepths(p_.shadow.real)))
    return false;
  ResolveTarget resolved;
  resolved.how.size = {to.z, to.w};
  resolved.colors = colors, resolved.depths = depths;
  return into(resolved);
}

bool ResolveDraws::blitsSamples() {
  if (p_.shadow.target().samples > 1) return true;
  if (integer(p_.shadow.real, GL_READ_FRAMEBUFFER_BINDING) == 0) return false;
  const UnresolvedImage::Cleared& cleared = p_.pending.unresolved.waiting->cleared;
  const auto buffer = static_cast<GLenum>(integer(p_.shadow.real, GL_READ_BUFFER));
  const bool color =
      buffer != GL_NONE && attachmentOf(p_.shadow.real, GL_READ_FRAMEBUFFER, buffer) == cleared.color;
  return color || attachmentOf(p_.shadow.real, GL_READ_FRAMEBUFFER, GL_DEPTH_ATTACHMENT) == cleared.depth;
}

}  // namespace gluray::gl
