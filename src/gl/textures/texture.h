// The textures that the fixed-function pipeline would sample, read back from the real OpenGL when a draw
// needs them. GL thread.
#pragma once
#include "gl/state/state.h"
#include "gl/textures/texture_image.h"

#include <map>
#include <memory>
#include <set>

namespace gluray::gl {

class ShareGroup;

/// Texture images already read back, per context. An image is read again after a call that may have changed
/// it, and all after a call of another context that shares them.
class TextureCache {
 public:
  explicit TextureCache(ShareGroup& group) : group_(group) {}

  /// Calls that change texture images invalidate them: those of the texture bound to `target` of the active
  /// unit (faces of cube maps count as the cube map), of a texture that is deleted, or all.
  void imageChanged(const RealGl& real, GLenum target);
  void deleted(GLuint name);
  void allImagesChanged();
  /// Textures are attached to framebuffers: drawing changes them, which shows when another framebuffer is
  /// bound.
  void attached(GLuint name) noexcept;
  void framebufferBound();
  /// Whether that was ever so of a texture.
  bool mayBeAttached(GLuint name) const { return forgotten_ || attached_.contains(name); }
  /// What was drawn into textures is finished for other contexts, too.
  void finished();

  /// The texture that a sampler of type `sampler` (GL_SAMPLER_2D ...) reads on `unit`. Anything but
  /// Reason::traced: why it cannot be traced.
  Reason bound(const RealGl& real, const RareState& has, GLint unit, GLenum sampler, scene::Texture& texture);
  /// The elements of the buffer texture on `unit`: bytes or floats, one to four a texel.
  Reason buffer(const RealGl& real, ShareGroup& group, GLint unit, scene::Attribute& elements,
                uint32_t& count);
  /// Whether every element has alpha 1; remembered for the storage asked about last.
  bool isOpaque(const scene::Attribute& elements, uint32_t count);

  /// Fills state.textures and state.textureReason from the enabled texture units.
  void read(const RealGl& real, State& state);

 private:
  struct Key {
    GLenum target;
    GLuint name;
    ImageRange range;
    auto operator<=>(const Key&) const = default;
  };
  /// Adds the active unit's texture to state.textures, if one is enabled. Anything but Reason::traced: why it
  /// cannot be.
  Reason readUnit(const RealGl& real, GLint unit, State& state);
  std::shared_ptr<const scene::TextureImage> image(const RealGl& real, const RareState& has, GLenum target,
                                                   const ImageRange& range, Reason& reason);
  /// Forgets images that another context may have changed.
  void forgetChanged();
  /// Tells the other contexts that this one has changed an image.
  void tellOthers();

  ShareGroup& group_;
  uint64_t changesKnown_ = 0;  // of ShareGroup::textureChanges
  std::map<Key, std::shared_ptr<const scene::TextureImage>> images_;
  std::set<GLuint> attached_;  // by name, ever
  std::weak_ptr<const void> askedAbout_;
  bool wasOpaque_ = false;
  bool forgotten_ = false;  // any may have been attached
};

}  // namespace gluray::gl
