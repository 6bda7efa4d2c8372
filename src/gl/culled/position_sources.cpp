#include "gl/culled/position_sources.h"

#include "base/log.h"
#include "gl/culled/cullable_state.h"
#include "gl/culled/instances/instance_arrays.h"
#include "gl/real/errors.h"
#include "gl/real/state_queries.h"

#include <glm/gtc/type_ptr.hpp>

#include <optional>
#include <utility>

namespace gluray::gl {

CullReason PositionSources::find(GLenum mode, const Elements& e, PositionSource& found) {
  if (shadow_.raster().program != 0) return findProgram(mode, e, found);
  if (shadow_.info.core) return CullReason::program;
  const CullReason reason = cullableBlending(shadow_, false);
  return reason == CullReason::culled ? findFixedFunction(found) : reason;
}

CullReason PositionSources::blendingOf(CulledProgram& program, const Varyings& varyings, GLenum mode,
                                       const Elements& e) {
  const Opacity opacity = program.opacity(shadow_.real, shadow_.info.core, varyings);
  if (const CullReason reason = cullableBlending(shadow_, opacity.opaque); reason != CullReason::culled)
    return reason;
  if (opacity.exact) return CullReason::culled;
  shadow_.errors.keepPending();  // replacesColors() must not find errors pending
  const bool replaces = hasByteColors(shadow_) && pending_.presenter.reader().replacesColors(shadow_.real) &&
                        constants_.areOnes(shadow_, program.known().program, opacity.ones, mode, e);
  return replaces ? CullReason::culled : CullReason::blend;
}

CullReason PositionSources::findProgram(GLenum mode, const Elements& e, PositionSource& found) {
  CulledProgram& program = programInUse();
  if (program.reason() != CullReason::culled) return program.reason();
  const bool core = shadow_.info.core;
  const bool blends = isOn(shadow_.real, GL_BLEND);
  const InstanceAttributes instances = instanceAttributes(program.known().program, shadow_.attributes());
  Varyings varyings;
  std::optional<LinearPosition> position =
      program.position(shadow_.real, core, instances, blends ? &varyings : nullptr);
  if (!position) return CullReason::positions;
  if (blends)
    if (const CullReason reason = blendingOf(program, varyings, mode, e); reason != CullReason::culled)
      return reason;
  found.program = &program, found.matrix = {position->clipFromAttribute, position->magnitudes};
  found.components = position->components, found.position = std::move(*position);
  return findArray(program, found.position.attribute, found.arrays, found.positions) ? CullReason::culled
                                                                                     : CullReason::arrayState;
}

bool PositionSources::findArray(CulledProgram& program, const std::string& attribute,
                                const ArrayState*& arrays, const ArraySource*& positions) {
  if (attribute == "gl_Vertex") {
    arrays = &shadow_.arrays(), positions = &shadow_.arrays().vertex;
    return true;
  }
  const ProgramAttribute* found = program.known().program.attribute(attribute);
  arrays = &shadow_.attributes();
  positions = found ? arrayOf(shadow_.attributes(), found->location) : nullptr;
  return positions != nullptr;
}

CullReason PositionSources::findFixedFunction(PositionSource& found) {
  if (fixedDiffers_) return CullReason::notTheSame;
  glm::dmat4 projection(1), modelview(1);
  shadow_.real.GetDoublev(GL_PROJECTION_MATRIX, glm::value_ptr(projection));
  shadow_.real.GetDoublev(GL_MODELVIEW_MATRIX, glm::value_ptr(modelview));
  const auto absolute = [](glm::dmat4 m) {
    for (int c = 0; c < 4; ++c) m[c] = glm::abs(m[c]);
    return m;
  };
  found.matrix = {projection * modelview, absolute(projection) * absolute(modelview)};
  found.arrays = &shadow_.arrays(), found.positions = &shadow_.arrays().vertex;
  return CullReason::culled;
}

CulledProgram& PositionSources::programInUse() {
  const std::shared_ptr<const KnownProgram>& known = shadow_.programInUse().known;
  std::unique_ptr<CulledProgram>& program = programs_[known.get()];
  if (!program) program = std::make_unique<CulledProgram>(shadow_.real, known);
  return *program;
}

void PositionSources::refuseDifferent(CulledProgram* program) {
  if (program)
    program->refuse(CullReason::notTheSame);
  else
    fixedDiffers_ = true;
  log::write(log::Level::warning, std::string("culled draws ") +
                                      (program ? "of a shader program" : "by fixed function") +
                                      " differ from complete draws: GLuRay does not cull them any more");
}

void PositionSources::forgetOld() {
  std::erase_if(programs_, [&](const auto& entry) {
    const bool forgotten = entry.second->isForgotten();
    if (forgotten) entry.second->feedback().release(shadow_.real);
    return forgotten;
  });
}

}  // namespace gluray::gl
