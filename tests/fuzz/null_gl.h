// An OpenGL that draws nothing: it keeps buffers and the state that the shadow GL reads back; all other
// functions just return. The fuzzer plays streams over it that crash Mesa, and ten times as many a second.
#pragma once
#include "gl/real/real.h"

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
