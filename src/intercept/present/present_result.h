// What presenting results in where something is thrown. GL thread.
#pragma once
#include "gl/batch/presenter.h"

#include <exception>

namespace gluray::present {

/// What `body` results in; an exception's text where it fails.
template <class F>
gl::PresentResult resultOf(F&& body) noexcept {
  try {
    return body();
  } catch (const std::exception& e) {
    gl::PresentResult failed;
    try {
      failed.why = e.what();
    } catch (...) {}  // the general line says enough
    return failed;
  }
}

}  // namespace gluray::present
