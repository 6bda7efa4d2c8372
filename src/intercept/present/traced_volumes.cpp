#include "intercept/present/traced_volumes.h"

#include "base/timeline.h"
#include "parallel/arena.h"

#include <exception>

namespace gluray::present {

bool TracedVolumes::cast(const gl::RealGl& real, const scene::VolumeCast& cast, std::string& why) noexcept {
  try {
    if (!shared_.supported(real, why)) return false;
    const timeline::Span span("volume");
    const auto light = cast.lit && shared_.tracer.illuminate ? shared_.tracer.illuminate(*cast.lit) : nullptr;
    const char* reason = "";
    if (!tracer_.trace(cast, *arenaFor(ArenaUse::frames, cast.threads), image_, reason, light.get()))
      return why = reason, false;
    PendingErrors pending;
    using Test = scene::VolumeView::DepthTest;
    const Test test = cast.view.depthTest;
    const WriteBackTarget over{.depthFunc = static_cast<GLenum>(test == Test::less ? GL_LESS : GL_LEQUAL),
                               .depths = test != Test::none,
                               .keepsDepth = !cast.view.span,
                               .asProgram = cast.view.span.has_value(),
                               .replaces = cast.view.replaces};
    if (!shared_.writeBack(real, WriteBack::Colors::floats).write(image_, over, pending))
      return why = "the real OpenGL refuses its image", false;
    if (shared_.written) shared_.written(real, image_);
    return true;
  } catch (const std::exception&) { return why.assign("memory ran out"), false; }
}

}  // namespace gluray::present
