// A renderer that the tests of a process share.
#pragma once
#include "frame/tracing/renderer.h"

namespace gluray::test {

/// Never destroyed, like the one of a host process.
inline frame::Renderer& testRenderer() {
  static auto* const renderer = new frame::Renderer;
  return *renderer;
}

}  // namespace gluray::test
