// The texture that the fixed-function pipeline would sample, read back from the real OpenGL when a draw needs
// it. GL thread.
#pragma once
#include "gl/state.h"

#include <map>
#include <memory>
#include <tuple>

namespace gluray::gl {

/// Texture images already read back, per context. An image is read again after a call that may have changed
/// it.
class TextureCache {
 public:
  /// Calls that change texture images invalidate: of the texture bound to `target` of the active unit, or
  /// all.
  void imageChanged(const RealGl& real, GLenum target);
  void allImagesChanged() { images_.clear(); }
  /// Textures are attached to framebuffers: drawing changes them, which shows when another framebuffer is
  /// bound.
  void attached() { attached_ = true, images_.clear(); }
  void framebufferBound() {
    if (attached_) images_.clear();
  }

  /// Fills state.texture and state.textureReason from texture unit 0; other units must be off.
  void read(const RealGl& real, State& state);

 private:
  using Key = std::pair<GLenum, GLuint>;  // target, name
  std::shared_ptr<const scene::TextureImage> image(const RealGl& real, GLenum target, GLuint name,
                                                   Reason& reason);
  std::map<Key, std::shared_ptr<const scene::TextureImage>> images_;
  bool attached_ = false;
};

}  // namespace gluray::gl
