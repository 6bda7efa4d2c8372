#include "gl/layers/sum_draws.h"

#include "gl/layers/layer_programs.h"
#include "gl/real/buffer_bits.h"
#include "gl/real/state_queries.h"
#include "gl/state/output_state.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <memory>
#include <utility>

namespace gluray::gl {

Reason SumDraws::classify(PrimitiveClass kind) {
  if (p_.failsafe.aside()) return p_.failsafe.reason();
  if (p_.shadow.info.off) return Reason::off;
  if (p_.shadow.activeQueries > 0) return Reason::query;
  if (const Reason reason = seenThroughReason(p_.shadow, kind); reason != Reason::traced) return reason;
  const TargetState& target = p_.shadow.target();
  if (target.framebuffer == 0 || target.samples > 1) return Reason::programPass;
  if (!addsUp(p_.shadow.real, p_.shadow.rare(), p_.shadow.raster())) return Reason::blend;
  const Family& family = *p_.shadow.program().known->family;
  if (p_.shadow.real.GetFragDataLocation(p_.shadow.program().known->program.name,
                                         family.passOutput.c_str()) != 1)
    return Reason::programPass;
  return p_.pending.canTrace() ? Reason::traced : Reason::noGlsl;
}

bool SumDraws::start(const BatchKey& key, const glm::dmat4& modelview) {
  if (!p_.pending.batch.empty()) return true;
  auto layers = std::make_shared<scene::Layers>();
  layers->of = scene::Layers::Of::sums;
  const auto pixels = static_cast<size_t>(key.region.width) * static_cast<size_t>(key.region.height);
  if (depthBits(p_.shadow.real, !p_.shadow.info.core) == 0) {
    layers->opaqueDepth.assign(pixels, -1.0f);
  } else {
    if (!p_.pending.presenter.reader().readDepth(p_.shadow.real, key.region, layers->opaqueDepth))
      return false;
    // A layer at the opaque depth must pass GL_LEQUAL and fail GL_LESS, however depths were rounded. The
    // margin exceeds half a depth step, because floats near 1 are no finer than that.
    const float margin = p_.shadow.target().depthResolution * (key.depthFunc == GL_LEQUAL ? 0.75f : -0.75f);
    for (float& depth : layers->opaqueDepth) depth += margin;
  }
  p_.pending.batch.start(key, p_.shadow.target(), modelview, p_.shadow.settings, p_.clock.frame,
                         p_.pending.begin());
  p_.pending.batch.seeThrough(std::move(layers));
  return true;
}

}  // namespace gluray::gl
