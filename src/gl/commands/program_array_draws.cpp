// Array draws by shader programs: passes of layers, whose draws may be held back, and all others.
#include "gl/commands/array_draws.h"
#include "gl/commands/program_arrays_draw.h"
#include "gl/context/context.h"

namespace gluray::gl {

Fate drawByProgram(Context& c, GLenum mode, const Elements& e) {
  c.shadow.refresh(kProgramGroups);
  c.immediate.closeRunIfOpen();
  if (passOf(c.shadow.state.program) == Family::Pass::peelDepths &&
      c.protect([&] { return c.layers.holdDepths(mode, e, trianglesOf(mode, e)); }))
    return Fate::heldPass;
  if (c.layers.drawsNothing()) return Fate::leftOutPass;
  if (c.layers.asks() && c.protect([&] { return c.layers.holdLater(mode, e); })) return Fate::heldPeel;
  ProgramArraysDraw request(c, mode, e);
  return c.draws.submit(request);
}

}  // namespace gluray::gl
