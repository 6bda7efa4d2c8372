// Interface through which a finished batch is traced and written: implemented in intercept/present/, by fakes
// in tests. GL thread.
#pragma once
#include "gl/batch/cleared_target.h"
#include "gl/batch/complete_presenter.h"
#include "gl/batch/framebuffer_reader.h"
#include "gl/batch/held_pass.h"
#include "gl/batch/layer_presenter.h"
#include "gl/batch/present_result.h"
#include "gl/batch/window_presenter.h"
#include "gl/clock/image_wish.h"
#include "gl/real/real.h"
#include "gl/sharing/shared_names.h"
#include "scene/fxaa.h"
#include "scene/resolve.h"
#include "scene/snapshot.h"

#include <GL/gl.h>
#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace gluray::gl {

/// Inputs of the write-back beside the snapshot. The framebuffer is bound when present() is called.
struct PresentTarget {
  GLenum depthFunc = GL_LESS;  // LESS or LEQUAL: test of the batch's depth against the framebuffer's
  bool core = false;           // core profile: no fixed function
  bool rasterise = false;      // the real OpenGL draws the instances; nothing is traced
  std::vector<ProgramDraw> programDraws = {};  // the draws of instances that shader programs draw
  // The instances were traced already: replaces the depth of their visible parts by the real OpenGL's, to the
  // bit, and changes nothing else. Fixed function alone, or `byMatrix`.
  bool depthAgain = false;
  /// With depthAgain: draws this mesh alone, which a shader program placed by a matrix.
  struct ByMatrix {
    scene::MeshPtr mesh;
    glm::dmat4 clipFromObject{1};
  } byMatrix = {};
  ImageWish wish = {};
  /// The clear under the snapshot's whole region, if known and if the image may be uploaded instead of
  /// drawn; no stencil value in the framebuffer matters then.
  std::optional<ClearedTarget> cleared = {};
  bool keepsPixels = false;  // the result gets the written pixels, which Presenter::relight() may replace
};

/// An image that was written with other light than its view has.
struct RelightTarget {
  const Image& written;  // PresentResult::written
  bool core = false;     // core profile
  ImageWish wish = {};
};

/// Where the pixels go into which an image's samples are resolved.
struct ResolveTarget {
  scene::Resolve how;
  bool core = false;  // core profile
  bool colors = true, depths = true;
  /// RGBA8 texture of the resolved size for the colours; 0: the bound draw framebuffer, which takes
  /// the depths in any case.
  GLuint texture = 0;
  ImageWish wish = {};
};

/// Writes images into framebuffers, and returns the other presenters, which do nothing by default.
class Presenter {
 public:
  virtual ~Presenter() = default;
  /// Whether the write-back, which needs shaders, works in the current context; `why` not. Called once each.
  virtual bool supports(const RealGl& real, bool core, std::string& why) noexcept = 0;
  /// Traces `snapshot` and merges it into the bound framebuffer; changes no queryable GL state. Never throws.
  virtual PresentResult present(const RealGl& real, const scene::SnapshotPtr& snapshot,
                                const PresentTarget& target) noexcept = 0;
  /// Traces `snapshot`, whose framebuffer is multisampled, and writes its resolved pixels to `target`, over
  /// whatever that holds. Otherwise as present(); not traced: nothing was drawn.
  virtual PresentResult resolve(const RealGl&, const scene::SnapshotPtr&,
                                const ResolveTarget& /*target*/) noexcept {
    return {};
  }
  /// Traces `now`, which equals the snapshot `before` of an earlier image but for its secondary scene, and
  /// replaces that image wherever the bound framebuffer still shows it. Not traced: nothing was drawn. Never
  /// throws.
  virtual PresentResult relight(const RealGl&, const scene::SnapshotPtr& /*before*/,
                                const scene::SnapshotPtr& /*now*/, const RelightTarget&) noexcept {
    return {};
  }
  /// Makes the program's FXAA pass: reads the texture bound to GL_TEXTURE_2D of unit `unit`, RGBA8 of the
  /// region's size, and writes the result to the region of the draw framebuffer's colour attachment `target`,
  /// a texture. False if nothing was done. Never throws.
  virtual bool antialias(const RealGl&, const scene::Fxaa&, GLint /*unit*/, GLuint /*target*/,
                         const scene::Region&, const Settings&) noexcept {
    return false;
  }
  virtual LayerPresenter& layers() noexcept;
  virtual WindowPresenter& window() noexcept;
  virtual FramebufferReader& reader() noexcept;
  virtual CompletePresenter& complete() noexcept;
  /// Names that it has created in the share group, which deletes them. Called when the context is destroyed.
  virtual SharedNames takeNames() { return {}; }
  /// A context is being destroyed; it may or may not be current. Its own objects need not be deleted.
  virtual void forget(const RealGl& real) noexcept = 0;
};

}  // namespace gluray::gl
