#include "gl/culled/restore_point.h"

#include "gl/batch/clears.h"
#include "gl/real/extensions.h"
#include "gl/real/state_queries.h"

#include <array>

namespace gluray::gl {
namespace {

/// During its lifetime, clears are limited to a region. The scissor boxes of other viewports do not change.
class OnlyScissor {
 public:
  OnlyScissor(const RealGl& real, const scene::Region& region)
      : real_(real),
        indexed_(isPresent(real.ScissorIndexed) && versionOf(real) >= 41),
        on_(isOn(real, GL_SCISSOR_TEST)) {
    real.GetIntegerv(GL_SCISSOR_BOX, box_.data());
    set(true, {region.x, region.y, region.width, region.height});
  }
  ~OnlyScissor() { set(on_, box_); }
  OnlyScissor(const OnlyScissor&) = delete;
  OnlyScissor& operator=(const OnlyScissor&) = delete;

 private:
  void set(bool on, const std::array<GLint, 4>& box) const {
    if (indexed_) {
      real_.ScissorIndexed(0, box[0], box[1], box[2], box[3]);
      return on ? real_.Enablei(GL_SCISSOR_TEST, 0) : real_.Disablei(GL_SCISSOR_TEST, 0);
    }
    real_.Scissor(box[0], box[1], box[2], box[3]);
    on ? real_.Enable(GL_SCISSOR_TEST) : real_.Disable(GL_SCISSOR_TEST);
  }

  const RealGl& real_;
  const bool indexed_, on_;
  std::array<GLint, 4> box_{};
};

}  // namespace

bool RestorePoint::isClear(const scene::Region& region) const {
  const std::optional<ClearedTarget>& below = raster_.clearBelow();
  const TargetState& target = shadow_.target();
  // With GL_FRAMEBUFFER_SRGB, a clear may have been made before the switch was changed.
  return below && below->framebuffer == target.framebuffer && !target.encodes &&
         contains(below->region, region);
}

bool RestorePoint::keep(const scene::Region& region) {
  region_ = region;
  clear_ = isClear(region) ? raster_.clearBelow() : std::nullopt;
  if (clear_) return true;
  return shadow_.target().samples == 1 && pending_.presenter.reader().keep(shadow_.real, region);
}

void RestorePoint::putBack() {
  if (clear_) return clear(*clear_);
  pending_.presenter.reader().putBack(shadow_.real);
}

/// Channels that the draw's colour mask excludes have kept their values.
void RestorePoint::clear(const ClearedTarget& as) {
  const RealGl& real = shadow_.real;
  const OnlyScissor scissor(real, region_);
  std::array<GLfloat, 4> color{};
  GLdouble depth = 1;
  real.GetFloatv(GL_COLOR_CLEAR_VALUE, color.data());
  real.GetDoublev(GL_DEPTH_CLEAR_VALUE, &depth);
  real.ClearColor(as.color[0], as.color[1], as.color[2], as.color[3]);
  real.ClearDepth(1);
  real.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  real.ClearColor(color[0], color[1], color[2], color[3]);
  real.ClearDepth(depth);
}

}  // namespace gluray::gl
