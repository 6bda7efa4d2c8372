// How a finished batch leaves the shadow GL: implemented in intercept/present/, by fakes in tests. GL thread.
#pragma once
#include "gl/batch/cleared_target.h"
#include "gl/batch/framebuffer_reader.h"
#include "gl/batch/present_result.h"
#include "gl/layers/layer_presenter.h"
#include "gl/programs/held_pass.h"
#include "gl/real.h"
#include "gl/window/window_presenter.h"
#include "scene/fxaa.h"
#include "scene/resolve.h"
#include "scene/snapshot.h"

#include <GL/gl.h>
#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace gluray::gl {

/// What the write-back must know about the framebuffer beside the snapshot. The framebuffer itself is bound
/// when present() is called.
struct PresentTarget {
  GLenum depthFunc = GL_LESS;  // LESS or LEQUAL: how the batch's depth meets the framebuffer's
  bool core = false;           // core profile: no fixed function
  bool rasterise = false;      // the instances are to be drawn by the real OpenGL, not traced
  std::vector<ProgramDraw> programDraws = {};  // those instances that shader programs draw
  // The instances were traced already: the depth of what is seen of them is made that which the real OpenGL
  // gives them, to the bit. Fixed function alone; nothing else changes.
  bool depthAgain = false;
  /// Then: or this mesh alone, which a shader program put there by a matrix.
  struct ByMatrix {
    scene::MeshPtr mesh;
    glm::dmat4 clipFromObject{1};
  } byMatrix = {};
  bool mayRepeat =
      true;  // where nothing has changed the last picture may do; false: what it costs is measured
  /// What lies under the whole region of the snapshot, if that is known and pictures may be sent instead of
  /// drawn; no stencil value in the framebuffer matters then.
  std::optional<ClearedTarget> cleared = {};
};

/// Where the pixels go that the samples of a picture come to.
struct ResolveTarget {
  scene::Resolve how;
  bool core = false;  // core profile
  bool colors = true, depths = true;
  /// RGBA8 texture of the resolved size that takes the colours; 0: the bound draw framebuffer does. Depths go
  /// there.
  GLuint texture = 0;
  bool mayRepeat = true;  // as PresentTarget's
};

/// Real objects that all contexts of a share group see.
struct SharedNames {
  std::vector<GLuint> lists, textures, programs;
};

/// Writes pictures into framebuffers, and holds the other roles. Those that the base class has do nothing.
class Presenter {
 public:
  virtual ~Presenter() = default;
  /// Whether the write-back works with the current context (it needs shaders). Asked once per context, with
  /// it current.
  virtual bool supports(const RealGl& real, bool core, std::string& why) noexcept = 0;
  /// Traces `snapshot` and merges it into the bound framebuffer, leaving every queryable GL state as it was.
  /// Never throws.
  virtual PresentResult present(const RealGl& real, const scene::SnapshotPtr& snapshot,
                                const PresentTarget& target) noexcept = 0;
  /// Traces `snapshot`, whose framebuffer is multisampled, and writes the pixels it comes to into another,
  /// over all that is there. Otherwise as present(); not traced: nothing was drawn.
  virtual PresentResult resolve(const RealGl&, const scene::SnapshotPtr&,
                                const ResolveTarget& /*target*/) noexcept {
    return {};
  }
  /// Does what the program's anti-aliasing pass would do: reads the texture bound to GL_TEXTURE_2D of unit
  /// `unit`, RGBA8 of the region's size, and replaces with the result that region of the draw framebuffer's
  /// colour attachment `target`, a texture. False where nothing was done. Never throws.
  virtual bool antialias(const RealGl&, const scene::Fxaa&, GLint /*unit*/, GLuint /*target*/,
                         const scene::Region&, const Settings&) noexcept {
    return false;
  }
  virtual LayerPresenter& layers() noexcept;
  virtual WindowPresenter& window() noexcept;
  virtual FramebufferReader& reader() noexcept;
  /// What it has made in the share group. Asked when the context goes away; the group deletes it.
  virtual SharedNames takeNames() { return {}; }
  /// A context is going away; it may or may not be current. Names made for it need not be freed.
  virtual void forget(const RealGl& real) noexcept = 0;
};

}  // namespace gluray::gl
