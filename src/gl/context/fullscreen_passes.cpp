#include "gl/context/fullscreen_passes.h"

#include "gl/flush/resolve_draws.h"
#include "gl/layers/layer_draws.h"
#include "gl/programs/uniforms.h"
#include "gl/real/errors.h"
#include "gl/real/state_queries.h"
#include "gl/state/output_state.h"
#include "gl/textures/texture_image.h"
#include "gl/textures/texture_sampling.h"

#include <GL/glext.h>

#include <cmath>
#include <string_view>

namespace gluray::gl {
namespace {

/// Whether the draw maps its texture onto the whole viewport: a strip of two triangles from corner to
/// opposite corner, with texture coordinates 0 and 1.
bool coversViewport(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& e) {
  if (mode != GL_TRIANGLE_STRIP || e.type || e.count != 4 || !arrays.vertex.enabled ||
      !arrays.texcoord.enabled)
    return false;
  const ArrayReader position(real, arrays.vertex), texcoord(real, arrays.texcoord);
  const auto last = static_cast<uint32_t>(e.first) + 3;
  if (position.available() <= last || texcoord.available() <= last) return false;
  unsigned corners = 0, diagonal = 0;
  for (uint32_t i = static_cast<uint32_t>(e.first); i <= last; ++i) {
    float p[4], t[4];
    position.read(i, p), texcoord.read(i, t);
    const bool corner = std::abs(p[0]) == 1 && std::abs(p[1]) == 1 && std::abs(p[2]) <= 1 && p[3] == 1;
    if (!corner || t[0] != (p[0] + 1) / 2 || t[1] != (p[1] + 1) / 2) return false;
    const unsigned which = (p[0] > 0 ? 1 : 0) + (p[1] > 0 ? 2 : 0);
    corners |= 1u << which;
    if (i == static_cast<uint32_t>(e.first) || i == last) diagonal ^= which;
  }
  return corners == 15 && diagonal == 3;
}

/// Whether the texture bound to the active unit is RGBA8 of that size and, read at pixel centres, returns its
/// texels unfiltered.
bool isPlainInput(const RealGl& real, const RareState& has, glm::ivec2 size) {
  const auto parameter = [&](GLenum name) {
    GLint value = 0;
    real.GetTexParameteriv(GL_TEXTURE_2D, name, &value);
    return value;
  };
  return !isSwizzled(real, has, GL_TEXTURE_2D) && isRgba8(real, size) &&
         parameter(GL_TEXTURE_MIN_FILTER) == GL_LINEAR && parameter(GL_TEXTURE_MAG_FILTER) == GL_LINEAR &&
         parameter(GL_TEXTURE_WRAP_S) == GL_CLAMP_TO_EDGE &&
         parameter(GL_TEXTURE_WRAP_T) == GL_CLAMP_TO_EDGE && parameter(GL_TEXTURE_BASE_LEVEL) == 0;
}

/// Whether x and y are the size of the region's pixels, as texture coordinates.
bool isTexel(const glm::vec4& texel, const scene::Region& region) {
  constexpr float kRounding = 1e-5f;  // pixels
  return std::abs(texel.x * static_cast<float>(region.width) - 1) < kRounding &&
         std::abs(texel.y * static_cast<float>(region.height) - 1) < kRounding;
}

}  // namespace

bool FullscreenPasses::replace(GLenum mode, const Elements& elements) {
  ShadowState& shadow = p_.shadow;
  const Family::Pass pass = passOf(shadow.program());
  const bool resolving = pass == Family::Pass::resolve;
  if (!resolving && pass != Family::Pass::fxaa) return false;
  const QuirkSet& quirks = shadow.settings.quirks;
  const bool instead =
      quirks.has(resolving ? Quirk::softwareResolve : Quirk::softwareFxaa) && shadow.isSoftwareBelow();
  const bool smooth = !resolving && p_.cleared.antialiased().copied() && quirks.has(Quirk::sppFxaa);
  if (!(instead || smooth) || p_.failsafe.aside() || shadow.activeQueries > 0) return false;
  const glm::ivec4& viewport = shadow.viewport().box;
  const scene::Region region{viewport.x, viewport.y, viewport.z, viewport.w};
  const GLuint texture = wholeTarget(mode, elements, region);
  if (texture == 0) return false;
  p_.relighting.finish(Relighting::Place::sampling);
  return resolving ? p_.resolves.byProgram(texture, region) : antialiasInto(texture, region, instead);
}

GLuint FullscreenPasses::wholeTarget(GLenum mode, const Elements& elements,
                                     const scene::Region& region) const {
  const RealGl& real = p_.shadow.real;
  const TargetState& target = p_.shadow.target();
  const ViewportState& viewport = p_.shadow.viewport();
  if (target.reason != Reason::traced && target.reason != Reason::noDepthBuffer) return 0;
  const bool whole = target.framebuffer != 0 && target.samples == 1 && region.x >= 0 && region.y >= 0 &&
                     region.width > 0 && region.height > 0;
  const bool open = !viewport.scissorTest || viewport.scissor == viewport.box;
  if (!whole || !open || !writesThrough(real, p_.shadow.rare()) ||
      !coversViewport(real, p_.shadow.attributes(), mode, elements))
    return 0;
  const auto ask = [&](GLenum name) {
    return attachmentValue(real, GL_DRAW_FRAMEBUFFER, target.drawBuffer, name);
  };
  if (ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_TEXTURE ||
      ask(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL) != 0 ||
      p_.shadow.images.mayBeDeleted(real, GL_DRAW_FRAMEBUFFER, target.drawBuffer))
    return 0;
  return static_cast<GLuint>(ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
}

bool FullscreenPasses::antialiasInto(GLuint attachment, const scene::Region& region, bool instead) {
  const RealGl& real = p_.shadow.real;
  const ProgramState& program = p_.shadow.program();
  const TargetState& target = p_.shadow.target();
  const KnownProgram& known = *program.known;
  const Family& family = *known.family;
  const ProgramUniform* sampler = known.program.uniform(family.passInput);
  if (!sampler || !program.uniforms) return false;
  const UniformReader uniforms(known.program, *program.uniforms, known.placeholders);
  const GLint unit = uniforms.integer(family.passInput), active = integer(real, GL_ACTIVE_TEXTURE);
  p_.shadow.errors.keepPending();
  real.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  const bool sampled = samplerOf(real) != 0;
  const auto input = static_cast<GLuint>(integer(real, GL_TEXTURE_BINDING_2D));
  const bool plain =
      !sampled && isPlainInput(real, p_.shadow.rare(), {region.width, region.height}) && input != attachment;
  real.ActiveTexture(static_cast<GLenum>(active));
  if (!plain) return false;
  if (p_.pending.batch.empty() &&
      p_.cleared.antialiased().isCopy(input, region, target.framebuffer, target.drawBuffer))
    return noteUse(Quirk::sppFxaa), true;  // the pass would only copy smooth pixels onto themselves
  if (!instead || !(family.passTexel.empty() || isTexel(uniforms.vector(family.passTexel), region)))
    return false;
  p_.flusher.flush();
  p_.cleared.forget();
  scene::Fxaa fxaa;
  fxaa.relativeContrast = uniforms.number(family.relativeContrast, fxaa.relativeContrast);
  fxaa.hardContrast = uniforms.number(family.hardContrast, fxaa.hardContrast);
  fxaa.subpixelBlendLimit = uniforms.number(family.subpixelBlendLimit, fxaa.subpixelBlendLimit);
  fxaa.subpixelContrast = uniforms.number(family.subpixelContrast, fxaa.subpixelContrast);
  fxaa.endpointSearchIterations = static_cast<int>(uniforms.number(family.endpointSearchIterations, 12));
  if (!p_.pending.presenter.antialias(real, fxaa, unit, attachment, region, p_.shadow.settings)) return false;
  noteUse(Quirk::softwareFxaa);
  return true;
}

}  // namespace gluray::gl
