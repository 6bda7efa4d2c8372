// Surfaces that are seen through and added up without order (weighted blending): the Context's side of
// scene::Layers::Of::sums. Nothing needs to be held back: what is traced is added to what is there, and real
// draws may come before and after.
#include "gl/context.h"
#include "gl/output_state.h"
#include "gl/state_queries.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <memory>
#include <utility>

namespace gluray::gl {

BatchKey::Layers Context::layersOfProgram() const {
  switch (passOfProgram()) {
    case Family::Pass::peel: return BatchKey::Layers::peeled;
    case Family::Pass::sum: return BatchKey::Layers::summed;
    default: return BatchKey::Layers::none;
  }
}

Reason Context::triageSeenThrough(PrimitiveClass kind) {
  // What keeps the program from being traced says more than what kind of primitive it draws.
  if (state.program.reason != Reason::traced) return state.program.reason;
  if (kind == PrimitiveClass::points) return Reason::points;
  if (kind == PrimitiveClass::lines) return Reason::lines;
  if (attributes.reason != Reason::traced) return attributes.reason;
  if (!info_.core && !state.clipPlanes.empty()) return Reason::program;
  if (state.program.known->program.blocks) dirty |= kProgram;
  if (const GLenum pending = real.GetError()) setError(pending);
  return Reason::traced;
}

Reason Context::triageSum(PrimitiveClass kind) {
  if (aside_) return Reason::failure;
  if (passthrough_) return Reason::off;
  if (activeQueries > 0) return Reason::query;
  if (const Reason reason = triageSeenThrough(kind); reason != Reason::traced) return reason;
  const TargetState& target = state.target;
  if (target.framebuffer == 0 || target.samples > 1 || !addsUp(real, state.rare, state.raster))
    return Reason::programPass;
  const Family& family = *state.program.known->family;
  if (real.GetFragDataLocation(state.program.known->program.name, family.passOutput.c_str()) != 1)
    return Reason::programPass;
  return canTrace() ? Reason::traced : Reason::noGlsl;
}

bool Context::startSums(const BatchKey& key) {
  if (!batch_.empty()) return true;
  auto layers = std::make_shared<scene::Layers>();
  layers->of = scene::Layers::Of::sums;
  const auto pixels = static_cast<size_t>(key.region.width) * static_cast<size_t>(key.region.height);
  if (integer(real, GL_DEPTH_BITS) == 0) {
    layers->opaqueDepth.assign(pixels, -1.0f);
  } else {
    if (!presenter_.readDepth(real, key.region, layers->opaqueDepth)) return false;
    // What is as far as what is opaque passes GL_LEQUAL, not GL_LESS, however depths were rounded on the way:
    // by more than half a step, because floats near 1 are no finer than that.
    const float margin = state.target.depthResolution * (key.depthFunc == GL_LEQUAL ? 0.75f : -0.75f);
    for (float& depth : layers->opaqueDepth) depth += margin;
  }
  batch_.start(key, state, info_.settings, frame);
  batch_.seeThrough(std::move(layers));
  return true;
}

}  // namespace gluray::gl
