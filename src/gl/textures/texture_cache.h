// The textures that a draw samples, read back from the real OpenGL when the draw needs them. Part of
// ShadowState, GL thread.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/real/extensions.h"
#include "gl/real/real.h"
#include "gl/textures/texture_image.h"
#include "scene/snapshot.h"
#include "scene/volumes/voxel_grid.h"

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace gluray::gl {

class Buffer;
class ShareGroup;

struct DepthTexture;

/// The part of a buffer that a buffer texture shows.
struct BufferTexture {
  std::shared_ptr<Buffer> buffer;
  GLenum format = 0;            // internal format
  size_t offset = 0, size = 0;  // bytes
};

/// A context's cache of texture images that were read back. An image is read again after a call that may have
/// changed it. All images are read again after such a call by another context of the share group.
class TextureCache {
 public:
  explicit TextureCache(ShareGroup& group) : group_(group) {}

  /// Invalidates the image of the texture bound to `target` of the active unit. A face of a cube map counts
  /// as the cube map.
  void imageChanged(const RealGl& real, GLenum target);
  /// Invalidates the images of a deleted texture.
  void deleted(GLuint name);
  /// Invalidates all images.
  void allImagesChanged();
  /// Reports that a texture is attached to a framebuffer. Draws may change it, so its images are invalidated
  /// now and each time that framebuffer is bound or another one is bound in its place.
  void attached(GLuint name) noexcept;
  /// Reports that a framebuffer is bound, or is drawn to by a copy.
  void framebufferBound(const RealGl& real);
  /// Whether a texture may ever have been attached to a framebuffer.
  bool mayBeAttached(GLuint name) const { return attachedIncomplete_ || attached_.contains(name); }
  /// Reports glFlush or glFinish: other contexts can now see what was drawn into textures.
  void finished();

  /// Reads the texture that a sampler of type `sampler` (GL_SAMPLER_2D ...) samples on `unit`. Returns
  /// Reason::traced, or why the texture cannot be traced.
  Reason bound(const RealGl& real, const RareState& has, GLint unit, GLenum sampler, scene::Texture& texture);
  /// The texture that a sampler3D samples on `unit`, as it is stored, and its sampling parameters in
  /// `sampling`, whose image is null. Null, with the reason in `why`, if it cannot be traced.
  std::shared_ptr<const scene::VoxelGrid> voxels(const RealGl& real, const RareState& has, GLint unit,
                                                 scene::Texture& sampling, std::string& why);
  /// The window depths in the texture that a sampler2D samples on `unit`. False if it is no depth texture, or
  /// its filter is not traced.
  bool depths(const RealGl& real, const RareState& has, GLint unit, DepthTexture& out);
  /// The buffer texture on `unit`, with its contents as they are when they are read.
  Reason buffer(const RealGl& real, ShareGroup& group, GLint unit, BufferTexture& texture);
  /// Reads the texels of the buffer texture on `unit`: bytes or floats, one to four per texel. Bytes that are
  /// integers in programs count as fractions of 255.
  Reason buffer(const RealGl& real, ShareGroup& group, GLint unit, scene::Attribute& elements,
                uint32_t& count);
  /// Whether every element has alpha 1. Caches the answer for the last elements.
  bool isOpaque(const scene::Attribute& elements, uint32_t count);

  /// Reads the textures of the enabled units. Returns Reason::traced, or why they cannot be traced.
  Reason read(const RealGl& real, const RareState& has, std::vector<scene::Texture>& textures);

 private:
  struct Key {
    GLenum target;
    GLuint name;
    ImageRange range;
    auto operator<=>(const Key&) const = default;
  };
  /// Adds the active unit's texture, if one is enabled. Returns Reason::traced, or why it cannot be traced.
  Reason readUnit(const RealGl& real, const RareState& has, GLint unit,
                  std::vector<scene::Texture>& textures);
  std::shared_ptr<const scene::TextureImage> image(const RealGl& real, const RareState& has, GLenum target,
                                                   const ImageRange& range, Reason& reason);
  void forgetAttached();
  /// Forgets images that another context may have changed.
  void forgetChanged();
  /// Tells the other contexts that this one has changed an image.
  void tellOthers();

  ShareGroup& group_;
  uint64_t changesKnown_ = 0;  // value of ShareGroup::textureChanges that images_ reflects
  std::map<Key, std::shared_ptr<const scene::TextureImage>> images_;
  std::map<GLuint, std::shared_ptr<const scene::VoxelGrid>> voxels_;  // by name of a 3D texture
  std::set<GLuint> attached_;        // names of textures that were ever attached
  bool attachedIncomplete_ = false;  // memory ran out: any texture may have been attached
  // Textures attached to the draw framebuffer. Known while an image of a texture that was ever attached is
  // kept.
  std::vector<GLuint> drawnTo_;
  bool drawnToKnown_ = false;
  // The elements that isOpaque() was called for last. While they are kept, nobody changes them.
  scene::Attribute checked_;
  uint32_t checkedCount_ = 0;
  bool checkedOpaque_ = false;
};

}  // namespace gluray::gl
