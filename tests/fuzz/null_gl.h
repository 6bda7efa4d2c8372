// An OpenGL that draws nothing: it keeps the state that the shadow GL asks back, and buffers, and does the
// rest by returning. Streams that Mesa does not survive, and ten times as many a second, can be played over
// it.
#pragma once
#include "gl/real.h"

#include <memory>

namespace gluray::fuzz {

class NullGl {
 public:
  /// Shares buffers and textures with `share`.
  explicit NullGl(const NullGl* share = nullptr);
  ~NullGl();
  NullGl(const NullGl&) = delete;
  NullGl& operator=(const NullGl&) = delete;

  void makeCurrent();
  static const gl::RealGl& table();

  struct State;
  struct Objects;

 private:
  std::unique_ptr<State> state_;
  std::shared_ptr<Objects> objects_;
};

}  // namespace gluray::fuzz
