// Surfaces that are seen through and added up without order (weighted blending, scene::Layers::Of::sums).
// Nothing needs to be held back: what is traced is added to what is there, and real
// draws may come before and after.
#include "gl/context.h"
#include "gl/layers/layer_draws.h"
#include "gl/state/buffer_bits.h"
#include "gl/state/output_state.h"
#include "gl/state/state_queries.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <memory>
#include <utility>

namespace gluray::gl {

Reason LayerDraws::triageSum(PrimitiveClass kind) {
  if (c_.aside()) return Reason::failure;
  if (c_.passthrough()) return Reason::off;
  if (c_.activeQueries > 0) return Reason::query;
  if (const Reason reason = triageSeenThrough(kind); reason != Reason::traced) return reason;
  const TargetState& target = c_.state.target;
  if (target.framebuffer == 0 || target.samples > 1 || !addsUp(c_.real, c_.state.rare, c_.state.raster))
    return Reason::programPass;
  const Family& family = *c_.state.program.known->family;
  if (c_.real.GetFragDataLocation(c_.state.program.known->program.name, family.passOutput.c_str()) != 1)
    return Reason::programPass;
  return c_.canTrace() ? Reason::traced : Reason::noGlsl;
}

bool LayerDraws::startSums(const BatchKey& key) {
  if (!c_.batch().empty()) return true;
  auto layers = std::make_shared<scene::Layers>();
  layers->of = scene::Layers::Of::sums;
  const auto pixels = static_cast<size_t>(key.region.width) * static_cast<size_t>(key.region.height);
  if (depthBits(c_.real, !c_.info().core) == 0) {
    layers->opaqueDepth.assign(pixels, -1.0f);
  } else {
    if (!c_.presenter().reader().readDepth(c_.real, key.region, layers->opaqueDepth)) return false;
    // What is as far as what is opaque passes GL_LEQUAL, not GL_LESS, however depths were rounded on the way:
    // by more than half a step, because floats near 1 are no finer than that.
    const float margin = c_.state.target.depthResolution * (key.depthFunc == GL_LEQUAL ? 0.75f : -0.75f);
    for (float& depth : layers->opaqueDepth) depth += margin;
  }
  c_.batch().start(key, c_.state, c_.settings(), c_.frame);
  c_.batch().seeThrough(std::move(layers));
  return true;
}

}  // namespace gluray::gl
