#include "gl/classify/untraced_programs.h"

#include "gl/program_state/program_state.h"
#include "gl/real/state_queries.h"

#include <algorithm>
#include <string>

namespace gluray::gl {

GLuint UntracedPrograms::nameInUse() const {
  return shadow_.isDirty(kRaster) ? shadow_.currentProgram.name() : shadow_.raster().program;
}

bool UntracedPrograms::isPipeline() {
  if (nameInUse() != 0) return false;
  return programPipeline(shadow_.real, shadow_.rare().pipelines) != 0;
}

Reason UntracedPrograms::inUse() {
  const GLuint name = nameInUse();
  if (name == 0) return Reason::traced;
  if (name != name_ || changes_ != shadow_.group.programChanges()) find(name);
  return reason_;
}

void UntracedPrograms::find(GLuint name) {
  // The count is read first, because other threads may change programs meanwhile.
  const uint64_t changes = shadow_.group.programChanges();
  const std::shared_ptr<const KnownProgram> known = shadow_.recognise(name);
  name_ = name, changes_ = changes;
  reason_ = reasonWithoutFamily(*known);
  readsFixedVertices_ = gl::readsFixedVertices(known->program);
  const auto& texts = known->program.texts;
  const auto numbers = [](const auto& shader) { return shader.text.find("gl_DrawID") != std::string::npos; };
  numbersDraws_ = !texts || !texts->all || std::ranges::any_of(texts->shaders, numbers);
}

bool UntracedPrograms::areAll() {
  const uint64_t changes = shadow_.group.programChanges();
  if (allChanges_ == changes) return areAll_;
  const bool traces = shadow_.group.tracesPrograms();
  if (const GLuint next = traces ? 0 : shadow_.group.unrecognised(); next != 0) {
    if (recognisedIn_ != clock_.frame) shadow_.recognise(next);
    recognisedIn_ = clock_.frame;
    return false;
  }
  allChanges_ = changes;
  return areAll_ = !traces;
}

}  // namespace gluray::gl
