#include "intercept/tracing/shared_renderer.h"

namespace gluray::intercept {

frame::Renderer& sharedRenderer() {
  static auto* const renderer = new frame::Renderer;
  return *renderer;
}

}  // namespace gluray::intercept
