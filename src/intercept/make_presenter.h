// Joins the ray tracer to the write-back: what a context of the shadow GL gets to make its pictures with.
#pragma once
#include "gl/batch/presenter.h"
#include "intercept/present/tracing_presenter.h"
#include "settings/settings.h"

#include <memory>

namespace gluray::intercept {

/// A presenter for one context. With the null renderer nothing is traced and every pixel is a miss: what
/// remains is the price of the interception.
/// `onWritten` is told of each picture in a framebuffer; it may be empty.
std::unique_ptr<gl::Presenter> makePresenter(const Settings& settings, present::Written onWritten = {});

}  // namespace gluray::intercept
