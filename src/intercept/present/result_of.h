// Converts exceptions of presenting into results. GL thread.
#pragma once
#include "gl/batch/presenter.h"

#include <exception>

namespace gluray::present {

/// The result of `body`; if it throws, a failure with the exception's text.
template <class F>
gl::PresentResult resultOf(F&& body) noexcept {
  try {
    return body();
  } catch (const std::exception& e) {
    gl::PresentResult failed;
    try {
      failed.why = e.what();
    } catch (...) {}  // out of memory: leave the reason empty
    return failed;
  }
}

}  // namespace gluray::present
