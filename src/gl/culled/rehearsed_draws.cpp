// Culled draws into framebuffers that cannot be restored: visible parts are found in a copy, and drawn once.
#include "gl/culled/culled_draws.h"

#include <utility>

namespace gluray::gl {
namespace {

/// During its lifetime, draws go to a copy of the framebuffer, if there is one.
class FramebufferCopy {
 public:
  FramebufferCopy(const RealGl& real, FramebufferReader& reader, const scene::Region& region, bool colors)
      : real_(real), reader_(reader), exists_(reader.bindCopy(real, region, colors)) {}
  ~FramebufferCopy() {
    if (exists_) reader_.unbindCopy(real_);
  }
  FramebufferCopy(const FramebufferCopy&) = delete;
  FramebufferCopy& operator=(const FramebufferCopy&) = delete;
  bool exists() const { return exists_; }

 private:
  const RealGl& real_;
  FramebufferReader& reader_;
  const bool exists_;
};

}  // namespace

/// `visible` need not include the whole guess: parts of it are hidden only by the framebuffer's depths or by
/// other parts, which are in `visible`.
bool CulledDraws::rehearse(const Plan& plan, std::vector<uint64_t>& visible) {
  if (plan.history->visible.empty()) return false;
  const FramebufferCopy copy(p_.shadow.real, p_.pending.presenter.reader(), plan.region, false);
  if (!copy.exists()) return false;
  drawParts(plan, plan.history->visible);
  return findVisible(plan, visible);
}

bool CulledDraws::isSame(const Plan& plan, const std::vector<uint64_t>& visible) {
  Pixels pixels[2];
  for (const bool all : {false, true}) {
    const FramebufferCopy copy(p_.shadow.real, p_.pending.presenter.reader(), plan.region, true);
    if (!copy.exists()) return true;
    if (all)
      drawWhole(plan);
    else
      drawParts(plan, visible);
    if (!read(plan, pixels[all ? 1 : 0])) return true;
  }
  return pixels[0] == pixels[1];
}

bool CulledDraws::drawRehearsed(const Plan& plan, bool verified) {
  std::vector<uint64_t> visible;
  if (!rehearse(plan, visible)) return false;
  if (verified && !isSame(plan, visible)) {
    markDifferent(plan);
    return drawWhole(plan), true;
  }
  drawParts(plan, visible);
  countLeft(plan, primitivesIn(plan, visible));
  plan.history->visible = std::move(visible);
  return true;
}

}  // namespace gluray::gl
