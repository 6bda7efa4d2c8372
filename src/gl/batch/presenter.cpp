#include "gl/batch/presenter.h"

namespace gluray::gl {

LayerPresenter& Presenter::layers() noexcept {
  static LayerPresenter none;
  return none;
}

WindowPresenter& Presenter::window() noexcept {
  static WindowPresenter none;
  return none;
}

CompletePresenter& Presenter::complete() noexcept {
  static CompletePresenter none;
  return none;
}

FramebufferReader& Presenter::reader() noexcept {
  static FramebufferReader none;
  return none;
}

}  // namespace gluray::gl
