#include "gl/layers/layer_programs.h"

#include "gl/real/errors.h"

namespace gluray::gl {

Family::Pass passOf(const ProgramState& program) {
  return program.known && program.known->family ? program.known->family->pass : Family::Pass::none;
}

BatchKey::Layers layersOf(const ProgramState& program) {
  switch (passOf(program)) {
    case Family::Pass::peel: return BatchKey::Layers::peeled;
    case Family::Pass::sum: return BatchKey::Layers::summed;
    default: return BatchKey::Layers::none;
  }
}

Reason seenThroughReason(ShadowState& shadow, PrimitiveClass kind) {
  // The program's reason is more useful to the user than the kind of primitive.
  if (shadow.program().reason != Reason::traced) return shadow.program().reason;
  if (kind == PrimitiveClass::points) return Reason::points;
  if (kind == PrimitiveClass::lines) return Reason::lines;
  if (shadow.attributes().reason != Reason::traced) return shadow.attributes().reason;
  if (!shadow.info.core && !shadow.clipPlanes().empty()) return Reason::program;
  if (shadow.program().known->program.blocks) shadow.expire(kProgram);
  shadow.errors.keepPending();
  return Reason::traced;
}

}  // namespace gluray::gl
