// Creates the presenter of a context, which connects ray tracer and write-back. GL thread.
#pragma once
#include "gl/batch/presenter.h"
#include "intercept/present/tracing_presenter.h"
#include "settings/settings.h"

#include <memory>

namespace gluray::intercept {

/// A presenter for one context. The null renderer traces nothing and makes every pixel a miss, to measure the
/// cost of interception. `onWritten` is called for each image written into a framebuffer; may be empty.
/// `refinesWindows`: the context's windows may be refined while the program is idle.
std::unique_ptr<gl::Presenter> makePresenter(const Settings& settings, present::Written onWritten = {},
                                             bool refinesWindows = false);

}  // namespace gluray::intercept
