#include "gl/culled/large_draws.h"

#include "gl/real/errors.h"

#include <algorithm>
#include <utility>

namespace gluray::gl {
namespace {

void without(std::vector<uint64_t>& bits, const std::vector<uint64_t>& others) {
  for (size_t i = 0; i < bits.size() && i < others.size(); ++i) bits[i] &= ~others[i];
}

std::vector<uint64_t> both(std::vector<uint64_t> bits, const std::vector<uint64_t>& others) {
  for (size_t i = 0; i < bits.size() && i < others.size(); ++i) bits[i] |= others[i];
  return bits;
}

bool any(const std::vector<uint64_t>& bits) {
  return std::ranges::any_of(bits, [](uint64_t word) { return word != 0; });
}

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

bool LargeDraws::draw(GLenum mode, const Elements& e, const std::function<void()>& first) {
  CullPlan plan;
  parts_.begin();
  const CullReason why = planner_.plan(mode, e, plan);
  if (why != CullReason::culled) return p_.counts.notCulled(why), false;
  if (first) first();
  if (first && !planner_.choosePlace(plan))
    return parts_.drawWhole(plan), p_.counts.notCulled(CullReason::samplesInUse), true;
  p_.shadow.errors.keepPending();  // reads of pixels must not find errors pending
  const int verify = p_.shadow.settings.cull.verify;
  if (verify > 0 && p_.clock.frame % static_cast<uint64_t>(verify) == 0)
    drawVerified(plan);
  else
    drawTried(plan);
  return true;
}

void LargeDraws::drawTried(const CullPlan& plan) {
  const bool always = p_.shadow.settings.cull.draws == Culling::always;
  CullHistory& history = *plan.history;
  const CullingTrials::Next next = history.trials.nextDraw(always, trials_);
  const auto finished = [&] {
    if (next.measured) p_.shadow.real.Finish();
    return next.measured ? p_.shadow.info.clock() : 0;
  };
  const double start = finished();
  const bool wanted = next.way == CullingTrials::Way::culled, culled = wanted && drawCulled(plan);
  if (!culled) parts_.drawWhole(plan), p_.counts.notCulled(CullReason::mostShows);
  const double seconds = finished() - start;
  if (next.measured) history.trials.took(next.way, culled, seconds, trials_);
  if (!history.visible.empty() || (!always && !history.trials.pays()) || !parts_.placeClusters(plan)) return;
  parts_.findVisible(plan, history.visible);
  if (next.measured) trials_.spend(finished() - start - seconds);
}

bool LargeDraws::drawCulled(const CullPlan& plan) {
  if (!parts_.placeClusters(plan)) return false;
  if (plan.rehearsed) return drawRehearsed(plan, false);
  const std::vector<uint64_t> guess = plan.history->visible;
  if (guess.empty() || !before_.keep(plan.region)) return false;
  parts_.drawParts(plan, guess);
  std::vector<uint64_t> visible;
  if (!parts_.findVisible(plan, visible)) {  // parts that were not drawn may be visible
    before_.putBack();
    return false;
  }
  std::vector<uint64_t> rest = visible;
  without(rest, guess);
  uint64_t drawn = plan.primitivesIn(guess);
  if (any(rest)) {
    drawn += plan.primitivesIn(rest);
    if (parts_.meetsEqual(plan, rest)) {
      before_.putBack();
      parts_.drawParts(plan, both(visible, guess));
    } else {
      parts_.drawParts(plan, rest);
    }
  }
  plan.history->visible = std::move(visible);
  countLeft(plan, drawn);
  return true;
}

/// For framebuffers that cannot be restored: visible parts are found in a copy, and drawn once. `visible`
/// need not include the whole guess: parts of it are hidden only by the framebuffer's depths or by other
/// parts, which are in `visible`.
bool LargeDraws::rehearse(const CullPlan& plan, std::vector<uint64_t>& visible) {
  if (plan.history->visible.empty()) return false;
  const FramebufferCopy copy(p_.shadow.real, p_.pending.presenter.reader(), plan.region, false);
  if (!copy.exists()) return false;
  parts_.drawParts(plan, plan.history->visible);
  return parts_.findVisible(plan, visible);
}

bool LargeDraws::drawRehearsed(const CullPlan& plan, bool verified) {
  std::vector<uint64_t> visible;
  if (!rehearse(plan, visible)) return false;
  if (verified && !isSame(plan, visible)) {
    markDifferent(plan);
    return parts_.drawWhole(plan), true;
  }
  parts_.drawParts(plan, visible);
  countLeft(plan, plan.primitivesIn(visible));
  plan.history->visible = std::move(visible);
  return true;
}

void LargeDraws::countLeft(const CullPlan& plan, uint64_t drawn) {
  const CulledMesh& mesh = *plan.mesh;
  const uint64_t all = uint64_t{mesh.primitives()} * plan.elements.repeats();
  p_.counts.culled((all - std::min(drawn, all)) * (mesh.corners() - 2));
}

void LargeDraws::drawVerified(const CullPlan& plan) {
  Pixels culled, whole;
  const bool placed = parts_.placeClusters(plan);
  if (placed && plan.rehearsed && drawRehearsed(plan, true)) return;
  if (!placed || plan.rehearsed || !drawCulled(plan)) {
    parts_.drawWhole(plan);
    if (placed) parts_.findVisible(plan, plan.history->visible);
    return;
  }
  const bool isRead = read(plan, culled);
  before_.putBack();
  parts_.drawWhole(plan);
  if (isRead && read(plan, whole) && culled != whole) markDifferent(plan);
}

bool LargeDraws::isSame(const CullPlan& plan, const std::vector<uint64_t>& visible) {
  Pixels pixels[2];
  for (const bool all : {false, true}) {
    const FramebufferCopy copy(p_.shadow.real, p_.pending.presenter.reader(), plan.region, true);
    if (!copy.exists()) return true;
    if (all)
      parts_.drawWhole(plan);
    else
      parts_.drawParts(plan, visible);
    if (!read(plan, pixels[all ? 1 : 0])) return true;
  }
  return pixels[0] == pixels[1];
}

void LargeDraws::markDifferent(const CullPlan& plan) {
  if (!plan.program) plan.known->different = true;
  p_.sources.refuseDifferent(plan.program);
}

bool LargeDraws::read(const CullPlan& plan, Pixels& pixels) {
  FramebufferReader& reader = p_.pending.presenter.reader();
  const RealGl& real = p_.shadow.real;
  if (plan.samples > 1) return reader.readSamples(real, plan.region, pixels.colors);
  return reader.readDepth(real, plan.region, pixels.depths) &&
         reader.readColors(real, plan.region, pixels.colors);
}

}  // namespace gluray::gl
