#include "gl/context/attention.h"

#include "gl/basics/thread_state.h"
#include "gl/clock/frame_clock.h"
#include "gl/context/immediate.h"
#include "gl/context/list_compiler.h"

namespace gluray::gl {

void Attention::update() {
  set(off_ || immediate_.insideBegin() || immediate_.runOpen() || immediate_.reliesOnAnswer() ||
      lists_.compiling());
  const bool captured = !off_ && (immediate_.runOpen() || lists_.compiling());
  t_thread.stream = !off_ && immediate_.takesAttributes() ? &immediate_.stream() : nullptr;
  t_thread.passthrough = !captured && (off_ || clock_.passesThrough()) ? &real_ : nullptr;
}

}  // namespace gluray::gl
