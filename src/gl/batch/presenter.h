// The interface that traces and writes a finished batch. Implemented in intercept/present/, and by fakes in
// tests. GL thread.
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
#include "scene/volumes/volume.h"

#include <GL/gl.h>
#include <glm/glm.hpp>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gluray::gl {

/// Inputs of the write-back in addition to the snapshot. The framebuffer is bound when present() is called.
struct PresentTarget {
  GLenum depthFunc = GL_LESS;                  // test of the batch's depth against the framebuffer's
  bool core = false;                           // core profile: no fixed function
  bool rasterise = false;                      // the real OpenGL draws the instances; nothing is traced
  std::vector<ProgramDraw> programDraws = {};  // draws of the instances that shader programs draw
  // The instances were traced before. Replaces the depth of their visible parts by exactly the depth that the
  // real OpenGL computes, and changes nothing else. For fixed function alone, or for `byMatrix`.
  bool depthAgain = false;
  /// With depthAgain: the only mesh to draw, which a shader program placed by a matrix.
  struct ByMatrix {
    scene::MeshPtr mesh;
    glm::dmat4 clipFromObject{1};
  } byMatrix = {};
  ImageWish wish = {};
  /// The clear under the whole region of the snapshot, if it is known and the image may be uploaded instead
  /// of drawn. Stencil values in the framebuffer then do not matter.
  std::optional<ClearedTarget> cleared = {};
  bool keepsPixels = false;  // the result gets the written pixels, which Presenter::relight() may replace
};

/// An image that was written with other light than its view has.
struct RelightTarget {
  const Image& written;                                      // PresentResult::written
  std::span<const std::shared_ptr<const Image>> later = {};  // the same of images written over it since
  bool core = false;                                         // core profile
  ImageWish wish = {};
};

/// Destination of an image's resolved pixels.
struct ResolveTarget {
  scene::Resolve how;
  bool core = false;  // core profile
  bool colors = true, depths = true;
  /// RGBA8 texture of the resolved size for the colours; 0: the bound draw framebuffer, which gets the depths
  /// in any case.
  GLuint texture = 0;
  ImageWish wish = {};
};

/// Writes images into framebuffers. Also returns the other presenters, which do nothing by default.
class Presenter {
 public:
  virtual ~Presenter() = default;
  /// Whether the write-back, which needs shaders, works in the current context; `why` says why not. Called
  /// once for each context.
  virtual bool supports(const RealGl& real, bool core, std::string& why) noexcept = 0;
  /// Traces `snapshot` and merges it into the bound framebuffer; changes no queryable GL state. Never throws.
  virtual PresentResult present(const RealGl& real, const scene::SnapshotPtr& snapshot,
                                const PresentTarget& target) noexcept = 0;
  /// Traces `snapshot`, whose framebuffer is multisampled, and writes its resolved pixels to `target`,
  /// replacing its contents. Otherwise like present(). Outcome other than traced: nothing was drawn.
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
  /// Replaces the program's FXAA pass. Reads the texture bound to GL_TEXTURE_2D of unit `unit`, RGBA8 of the
  /// region's size. Writes the result to the region of the draw framebuffer's colour attachment `target`, a
  /// texture. Returns false if nothing was done. Never throws.
  virtual bool antialias(const RealGl&, const scene::Fxaa&, GLint /*unit*/, GLuint /*target*/,
                         const scene::Region&, const Settings&) noexcept {
    return false;
  }
  /// Whether castVolume() gives volumes the light of the settings, and they block that of surfaces.
  virtual bool lightsVolumes() const noexcept { return false; }
  /// Traces a volume and blends it over the bound framebuffer, whose depth stays. False, with the reason for
  /// the user in `why`, if nothing was drawn. Never throws.
  virtual bool castVolume(const RealGl&, const scene::VolumeCast&, std::string& why) noexcept {
    return why.assign("volumes are not traced here"), false;
  }
  virtual LayerPresenter& layers() noexcept;
  virtual WindowPresenter& window() noexcept;
  virtual FramebufferReader& reader() noexcept;
  virtual CompletePresenter& complete() noexcept;
  /// Returns the names that it has created in the share group, which will delete them. Called when the
  /// context is destroyed.
  virtual SharedNames takeNames() { return {}; }
  /// Reports that a context is being destroyed, which may be current or not. Its own objects need not be
  /// deleted.
  virtual void forget(const RealGl& real) noexcept = 0;
};

}  // namespace gluray::gl
