#include "gl/programs/untraced_programs.h"

#include "gl/errors.h"
#include "gl/programs/program_state.h"

#include <algorithm>
#include <string>

namespace gluray::gl {

Reason UntracedPrograms::inUse() {
  const GLuint name = shadow_.dirty & kRaster ? shadow_.program.name() : shadow_.state.raster.program;
  if (name == 0) return Reason::traced;
  if (name != name_ || changes_ != shadow_.group.programChanges()) find(name);
  return reason_;
}

void UntracedPrograms::find(GLuint name) {
  // Read first: other threads may change programs meanwhile.
  const uint64_t changes = shadow_.group.programChanges();
  const std::shared_ptr<const KnownProgram> known = recognise(name);
  name_ = name, changes_ = changes;
  reason_ = reasonWithoutFamily(*known);
  const auto& texts = known->program.texts;
  const auto numbers = [](const auto& shader) { return shader.text.find("gl_DrawID") != std::string::npos; };
  numbersDraws_ = !texts || !texts->all || std::ranges::any_of(texts->shaders, numbers);
}

std::shared_ptr<const KnownProgram> UntracedPrograms::recognise(GLuint name) {
  if (auto known = shadow_.group.recognised(name)) return known;
  shadow_.errors.keepPending();
  auto known = shadow_.program.known(name);
  while (shadow_.real.GetError() != GL_NO_ERROR) {}
  return known;
}

bool UntracedPrograms::areAll() {
  const uint64_t changes = shadow_.group.programChanges();
  if (allChanges_ == changes) return areAll_;
  const bool traces = shadow_.group.tracesPrograms();
  if (const GLuint next = traces ? 0 : shadow_.group.unrecognised(); next != 0) {
    if (recognisedIn_ != clock_.frame) recognise(next);
    recognisedIn_ = clock_.frame;
    return false;
  }
  allChanges_ = changes;
  return areAll_ = !traces;
}

}  // namespace gluray::gl
