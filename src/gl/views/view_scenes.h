// Keeps the surfaces of each view outside of the pending batch, so that surfaces of one view light each other
// although they are traced in several batches (adr/0047). Empty without light effects. A part of each
// Context, GL thread.
#pragma once
#include "gl/views/scene_extents.h"
#include "gl/views/shown_views.h"
#include "gl/views/upward_axes.h"
#include "gl/views/view_epoch.h"
#include "gl/views/view_frames.h"
#include "scene/effects.h"
#include "scene/secondary_scene.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace gluray::gl {

class SecondarySceneBuilder;

/// A view is one camera and viewport of one framebuffer, from one clear of its depth to the next (a depth
/// epoch). What was drawn before a batch is in its secondary scene; and of what the last frame drew after it,
/// that it will be drawn again is taken for granted: at the place where it would be if the camera alone had
/// moved.
class ViewScenes {
 public:
  /// The secondary scene of a batch that is about to be traced. Null where it is empty, where no setting asks
  /// for light, and where memory has run out.
  /// `isLast`: nothing is drawn after it in this frame.
  std::shared_ptr<const scene::SecondaryScene> secondaryScene(const BatchKey&, const scene::Snapshot&,
                                                              bool isLast = false) noexcept;
  /// Snapshot::extent of the batch, whose secondary scene is known. 0 where no setting asks for light.
  float extentOf(const scene::Snapshot&) const noexcept;
  /// What the setting `ground` means to that batch: the first opaque one of a view that holds a lit surface
  /// shows it.
  scene::GroundUse groundOf(const BatchKey&, const scene::Snapshot&) noexcept;
  /// Whether effects of light leave the batch alone, because its view is an inset of another one.
  bool isLeftAlone(const BatchKey& key, const scene::Snapshot& s) const {
    return scene::changesLight(s.settings) && !s.settings.lights.insets && shown_.isInset(key, s.frame);
  }
  /// The setting lights.up of the batch, found from its camera if it is `auto`.
  LightsUp upwardAxisOf(const BatchKey&, const scene::Snapshot&) noexcept;
  /// The batch was traced, or surely will be: it belongs to its view. `image`: of surfaces that the real
  /// OpenGL has drawn, instead.
  void traced(const BatchKey&, const scene::SnapshotPtr&,
              const std::shared_ptr<const scene::FramebufferCapture>& capture = nullptr) noexcept;
  /// The traced batch is in its framebuffer. `written`: PresentResult::written.
  void wrote(const scene::SnapshotPtr&, std::shared_ptr<const Image> written) noexcept;

  /// A batch whose view holds other surfaces than it was lit with.
  struct Outdated {
    GLenum drawBuffer;
    scene::SnapshotPtr before;                        // as it was traced
    scene::SnapshotPtr now;                           // equal, but for its secondary scene
    std::shared_ptr<const Image> written;             // PresentResult::written
    std::vector<std::shared_ptr<const Image>> later;  // the same of the view's later batches
  };
  /// The framebuffers with views to which batches were added since outdated() looked at them.
  std::vector<GLuint> unchecked() const;
  bool holdsUnchecked(GLuint framebuffer) const {
    return std::any_of(open_.begin(), open_.end(), [&](const ViewEpoch& epoch) {
      return epoch.framebuffer == framebuffer && !epoch.isChecked;
    });
  }
  /// Those batches of the framebuffer's views, in the order of drawing, if they are written: of what was
  /// taken for granted something did not come, or something else came. Behind them also layers that are drawn
  /// over them (scene::Layers::Of::drawn). Call relit() for those that are traced again. Call where a picture
  /// is finished; later draws are unknown then. Out of memory, there are none.
  std::vector<Outdated> outdated(GLuint framebuffer) noexcept;
  /// The batch was traced again as `now`, and is written.
  void relit(const Outdated&, std::shared_ptr<const Image> written) noexcept;
  /// The snapshot of a batch that is not traced yet, lit by what its view holds now.
  scene::SnapshotPtr broughtUpToDate(const scene::SnapshotPtr&) noexcept;
  /// A batch that traced() has reported is not drawn after all.
  void withdraw(const scene::SnapshotPtr&) noexcept;
  /// Peeled layers of this frame that were traced are drawn by the real OpenGL after all.
  void withdrawPeeled(uint64_t frame) noexcept;
  /// Depth of the framebuffer was cleared in `box`: views whose surfaces all lie there begin anew, and others
  /// lose the surfaces that lie there.
  void depthCleared(GLuint framebuffer, const scene::Region& box) noexcept;
  /// The clear in whose place the batch shows a background (setting `background`), if it does.
  std::optional<ShownViews::Clear> paintsOver(const BatchKey&, const scene::Snapshot&) const noexcept;
  /// Colours of a framebuffer were cleared.
  void colorCleared(const ShownViews::Clear&) noexcept;
  /// Which frame of its view the batch belongs to that is about to be traced; 0: no setting asks for light.
  uint64_t frameOf(const BatchKey&, const scene::Snapshot&) noexcept;
  /// As depthCleared() for the window, whose content is undefined after a swap.
  void swapped() noexcept;
  void forget() { open_.clear(), ended_.clear(), shown_.clear(), extents_.clear(), axes_.clear(); }
  bool empty() const { return open_.empty() && ended_.empty() && shown_.empty(); }

 private:
  using Ended = std::vector<std::shared_ptr<const ViewEpoch>>;
  ViewEpoch* epochOf(const BatchKey&, const scene::Snapshot&);
  Ended::iterator lastOf(const BatchKey&, const scene::Snapshot&);
  void forgetUnwanted(const Settings&);
  template <class Is>
  void withdrawIf(const Is& is) noexcept;
  template <class Ends>
  void end(const Ends&) noexcept;
  void forgetOld();

  std::vector<ViewEpoch> open_;  // the newest one last
  Ended ended_;                  // those of several batches that no open one repeats; the newest one last
  ShownViews shown_;             // while settings ask for a ground or a background
  ViewFrames frames_;
  SceneExtents extents_;
  UpwardAxes axes_;
  uint64_t clock_ = 0;  // counts ends
};

}  // namespace gluray::gl
