#include "gl/culled/culled_draws.h"

#include "gl/basics/failsafe.h"
#include "gl/culled/cullable_state.h"
#include "gl/culled/large_draws.h"
#include "gl/culled/position_sources.h"
#include "gl/culled/small_draws.h"

#include <algorithm>

namespace gluray::gl {

CulledDraws::CulledDraws(const Parts& p)
    : p_(p),
      sources_(std::make_unique<PositionSources>(p.shadow, p.pending)),
      large_(std::make_unique<LargeDraws>(
          LargeDraws::Parts{p.shadow, p.clock, p.counts, p.pending, p.raster, *sources_})),
      small_(std::make_unique<SmallDraws>(
          SmallDraws::Parts{p.shadow, p.clock, p.counts, p.pending, p.cleared, *sources_})) {}

CulledDraws::~CulledDraws() = default;

bool CulledDraws::isActive() const {
  const Culling how = p_.shadow.settings.cull.draws;
  if (how == Culling::automatic && !p_.shadow.isSoftwareBelow()) return false;
  return how != Culling::off && !p_.failsafe.aside() && !p_.shadow.info.off;
}

bool CulledDraws::isLarge(const Elements& e) const {
  const auto least = static_cast<uint64_t>(std::max(p_.shadow.settings.cull.from, 1));
  return static_cast<uint64_t>(std::max(e.count, 0)) * e.repeats() >= least;
}

CulledDraws::Part CulledDraws::mayLeaveOut(const Elements& e) {
  if (!isActive()) return Part::nothing;
  if (isLarge(e)) return Part::clusters;
  return small_->isOn() ? Part::whole : Part::nothing;
}

bool CulledDraws::takesParts() {
  if (!isActive()) return false;
  p_.shadow.refresh(kProgramGroups);
  return p_.shadow.raster().program != 0 && sources_->programInUse().reason() == CullReason::culled;
}

void CulledDraws::count(const Elements& e) {
  if (isActive()) small_->count(e);
}

bool CulledDraws::draw(GLenum mode, const Elements& e, const std::function<void()>& first) noexcept {
  if (!isActive()) return false;
  return p_.failsafe.protect(
      [&] { return isLarge(e) ? large_->draw(mode, e, first) : small_->leavesOut(mode, e); });
}

void CulledDraws::endFrame() { small_->endFrame(); }

CullReason CulledDraws::reasonOfState(GLenum mode) { return cullableState(p_.shadow, mode); }

CullReason CulledDraws::findSurface(GLenum mode, const Elements& e, Surface& surface) {
  PositionSource from;
  const CullReason reason = sources_->find(mode, e, from);
  if (reason == CullReason::culled)
    surface = {from.arrays,
               from.positions,
               from.components,
               from.matrix.clipFromObject,
               !from.position.terms.empty(),
               from.program && from.program->discards()};
  return reason;
}

}  // namespace gluray::gl
