#include "gl/culled/small_draws.h"

#include "gl/batch/clears.h"
#include "gl/culled/cullable_state.h"
#include "gl/culled/draw_content.h"
#include "gl/culled/position_sources.h"
#include "gl/framebuffers/cleared_framebuffers.h"
#include "gl/real/errors.h"
#include "gl/real/state_queries.h"

#include <GL/glext.h>

#include <algorithm>
#include <utility>

namespace gluray::gl {
namespace {

constexpr int kFewVertices = 24;        // maximum of draws that are cheaper to make than to test
constexpr int kKnownFrames = 2;         // frames with the same data before its boxes are computed
constexpr double kBuildSeconds = 3e-3;  // for computing boxes in a culled frame
constexpr uint64_t kPause = 32;         // frames without culling after which the look schedule restarts
constexpr uint64_t kForgottenAfter = 64, kOfSweep = 8;  // unused turns of a mesh; turns of a sweep
constexpr double kVerticesOfDraw = 200;                 // fixed cost of a draw, in vertices
constexpr double kReadSeconds = 1e-9;                   // per pixel, to read depths
constexpr uint32_t kCommonGroups = kViewport | kRaster | kTarget;

bool isInstanced(const ArrayState& arrays) {
  bool any = arrays.reason == Reason::instanced;
  const auto look = [&](const ArraySource& a) { any = any || (a.enabled && a.divisor != 0); };
  arrays.forEach(look);
  for (const ArraySource& a : arrays.generic) look(a);
  return any;
}

}  // namespace

bool SmallDraws::isOn() {
  if (frame_ != p_.clock.frame) beginFrame();
  if (!culls_) return false;
  culls_ = !trials_.isOver();
  return trials_.takes(load_.draws);
}

void SmallDraws::endFrame() {
  if (!trials_.wantsStop()) return;
  p_.shadow.real.Finish();
  trials_.stop(p_.shadow.info.clock());
}

void SmallDraws::count(const Elements& e) {
  ++load_.draws, load_.vertices += e.count, load_.work += kVerticesOfDraw + e.count;
  if (trials_.isMeasured() && !trials_.wantsStop()) {
    p_.shadow.real.Finish();
    trials_.start(p_.shadow.info.clock());
  }
}

bool SmallDraws::leavesOut(GLenum mode, const Elements& e) {
  const bool on = isOn();
  count(e);
  if (!on || e.count < kFewVertices || e.repeats() != 1 || e.baseInstance != 0) return false;
  if (!trials_.isTimed()) {
    trials_.worked(trials_.drawSeconds());
    return hides(mode, e);
  }
  apartSeconds_ = 0;
  const double start = p_.shadow.info.clock();
  const bool hidden = hides(mode, e);
  trials_.worked(p_.shadow.info.clock() - start - apartSeconds_);
  return hidden;
}

bool SmallDraws::hides(GLenum mode, const Elements& e) {
  Candidate candidate;
  if (!find(mode, e, candidate)) return false;
  if (epoch_ != p_.cleared.depthEpoch(common_.region.reversed)) beginEpoch();
  if (!settles_ && schedule_.isDue()) readDepths();
  if (!mayShow(candidate)) {
    trials_.leftOut(candidate.vertices);
    if (!verifiedAsHidden(candidate, mode, e)) return true;  // it was made
    const CulledMesh& mesh = *candidate.mesh;
    p_.counts.culled(uint64_t{mesh.primitives()} * (mesh.corners() - 2));
    return true;
  }
  if (settles_) return false;
  schedule_.drew(candidate.vertices);
  drawn_.push_back(std::move(candidate));
  return false;
}

void SmallDraws::beginFrame() {
  const bool always = p_.shadow.settings.cull.draws == Culling::always;
  load_.waiting = waiting_;
  const FrameTrials::Way way = trials_.nextFrame(always, load_);
  culls_ = way != FrameTrials::Way::plain, settles_ = way == FrameTrials::Way::settling;
  frame_ = p_.clock.frame;
  const double work = std::exchange(load_, {}).work;
  buildSeconds_ = 0;
  seen_.any = false, drawn_.clear();
  if (!culls_) return;
  commonIsOld_ = true;
  turn_ += !settles_ ? 1 : trials_.takes(0) ? kOfSweep : 0;
  forgetOld();
  if (settles_) return;
  // If a trial has not paid, looks have become rare.
  if (frame_ > culledIn_ + kPause) schedule_ = {};
  culledIn_ = frame_;
  schedule_.beginFrame(!always, work);
  lookedAt_ = p_.shadow.info.clock();
}

void SmallDraws::beginEpoch() {
  epoch_ = p_.cleared.depthEpoch(common_.region.reversed);
  seen_.any = false, drawn_.clear();
  schedule_.beginEpoch();
  lookedAt_ = p_.shadow.info.clock();
}

/// ShadowState::wasReadBack() records changes of the state that it depends on.
void SmallDraws::readCommon(GLenum mode) {
  ShadowState& shadow = p_.shadow;
  shadow.forgetReadBack(kCommonGroups);
  commonIsOld_ = false;
  mode_ = mode;
  common_ = {};
  common_.reason = hideableState(shadow, mode, common_.isTested);
  if (common_.reason != CullReason::culled) return;
  common_.region = drawnRegionOf(shadow);
  if (common_.region.drawn.width <= 0 || common_.region.drawn.height <= 0)
    common_.reason = CullReason::smallDraw;
  common_.window = mappingTo(common_.region.inViewport, shadow);
}

bool SmallDraws::find(GLenum mode, const Elements& e, Candidate& candidate) {
  ShadowState& shadow = p_.shadow;
  if (commonIsOld_ || shadow.wasReadBack(kCommonGroups) || mode != mode_) readCommon(mode);
  if (common_.reason != CullReason::culled || shadow.activeQueries > 0) return false;
  candidate.vertices = kVerticesOfDraw + e.count;
  const ArrayState* arrays = nullptr;
  const ArraySource* positions = nullptr;
  int components = 4;
  if (shadow.raster().program != 0) {
    if (!findByProgram(candidate, arrays, positions, components)) return false;
  } else {
    PositionSource from;
    if (shadow.info.core || p_.sources.findFixedFunction(from) != CullReason::culled) return false;
    candidate.matrix = from.matrix;
    arrays = from.arrays, positions = from.positions, components = from.components;
  }
  return findMesh(mode, e, *arrays, *positions, components, candidate);
}

bool SmallDraws::findByProgram(Candidate& candidate, const ArrayState*& arrays, const ArraySource*& positions,
                               int& components) {
  ShadowState& shadow = p_.shadow;
  CulledProgram& program = p_.sources.programInUse();
  if (program.reason() != CullReason::culled) return false;
  if (isInstanced(shadow.attributes())) return false;
  PlacedPosition placed;
  if (!program.placedPosition(shadow.real, shadow.info.core, placed)) return false;
  candidate.program = &program, candidate.matrix = placed.matrix;
  components = placed.position->components;
  return p_.sources.findArray(program, placed.position->attribute, arrays, positions);
}

bool SmallDraws::findMesh(GLenum mode, const Elements& e, const ArrayState& arrays,
                          const ArraySource& positions, int components, Candidate& candidate) {
  ShadowState& shadow = p_.shadow;
  const bool always = shadow.settings.cull.draws == Culling::always;
  DrawContent content;
  if (readContent(shadow, arrays, positions, components, mode, e, content) != CullReason::culled)
    return false;
  Known& known = meshes_[content.name];
  if (known.frames == 0) ++waiting_;
  if (known.frames == 0 || known.lastFrame != frame_) ++known.frames;
  known.lastFrame = frame_, known.lastTurn = turn_;
  if (known.refused) return false;
  if (!always && known.frames < kKnownFrames) return trials_.isUnknown(), false;
  if (!known.mesh) {
    // The trials limit the cost of settling.
    if (!always && !settles_ && buildSeconds_ > kBuildSeconds) return trials_.isUnknown(), false;
    const double start = p_.shadow.info.clock();
    known.mesh = CulledMesh::create(shadow.real, positions, components, content.arrays, content.assembly, e);
    known.refused = !known.mesh, --waiting_;
    if (known.mesh) known.mesh->build(), known.mesh->forgetVertices();
    buildSeconds_ += p_.shadow.info.clock() - start;
  }
  if (known.refused) return false;
  trials_.isBoxed(e.count);
  candidate.mesh = known.mesh;
  return true;
}

/// Whether the depths that were read bound the depths against which the next draw is tested.
bool SmallDraws::isSeen() const {
  return seen_.any && common_.isTested && seen_.reversed == common_.region.reversed &&
         seen_.epoch == p_.cleared.depthEpoch(seen_.reversed) && contains(seen_.region, common_.region.drawn);
}

bool SmallDraws::mayShow(const Candidate& candidate) const {
  WindowMapping window = common_.window;
  const bool isBounded = isSeen();
  window.viewport.x += common_.region.inViewport.x - seen_.region.x,
      window.viewport.y += common_.region.inViewport.y - seen_.region.y;
  return candidate.mesh->clusters().anyMayShow(
      BoxVisibility(candidate.matrix, window, isBounded ? &seen_.pyramid : nullptr));
}

void SmallDraws::readDepths() {
  ShadowState& shadow = p_.shadow;
  FramebufferReader& reader = p_.pending.presenter.reader();
  const bool wasSeen = isSeen();
  const double before = trials_.isTimed() ? shadow.info.clock() : 0;
  if (trials_.isTimed()) shadow.real.Finish();  // the cost of earlier drawing does not count
  const double start = trials_.isTimed() ? shadow.info.clock() : 0;
  seen_.any = false;
  shadow.errors.keepPending();  // reads of pixels must not find errors pending
  const bool isRead =
      common_.region.samples > 1
          ? reader.readFarthest(shadow.real, common_.region.inViewport, common_.region.reversed, depths_)
          : reader.readDepth(shadow.real, common_.region.inViewport, depths_);
  const double readAt = p_.shadow.info.clock();
  if (isRead) {
    if (common_.region.reversed) turnDepths(depths_);
    seen_.pyramid.build(depths_.data(), common_.region.inViewport.width, common_.region.inViewport.height);
    seen_.region = common_.region.inViewport, seen_.reversed = common_.region.reversed, seen_.any = true;
    seen_.epoch = p_.cleared.depthEpoch(common_.region.reversed);
  }
  const double now = p_.shadow.info.clock();
  double all = 0, hidden = 0;
  for (const Candidate& drawn : drawn_) {
    all += drawn.vertices;
    if (!mayShow(drawn)) hidden += drawn.vertices;
  }
  const double pixels = double(common_.region.inViewport.width) * common_.region.inViewport.height;
  // Without earlier depths, a first look is most useful.
  const double wasted = all > 0 ? hidden / all * (readAt - lookedAt_) : 0;
  schedule_.looked(wasSeen || hidden > 0 ? wasted : 2 * wasted, now - readAt + kReadSeconds * pixels);
  drawn_.clear();
  lookedAt_ = p_.shadow.info.clock();
  if (!trials_.isTimed()) return trials_.looked(lookedAt_ - readAt + kReadSeconds * pixels, lookedAt_);
  trials_.looked(lookedAt_ - start, lookedAt_);
  apartSeconds_ += lookedAt_ - before;
}

bool SmallDraws::verifiedAsHidden(const Candidate& candidate, GLenum mode, const Elements& e) {
  const int every = p_.shadow.settings.cull.verify;
  if (every <= 0 || p_.clock.frame % static_cast<uint64_t>(every) != 0) return true;
  const double start = p_.shadow.info.clock();
  const bool hidden = isHidden(candidate, mode, e);
  apartSeconds_ += p_.shadow.info.clock() - start;
  return hidden;
}

bool SmallDraws::isHidden(const Candidate& candidate, GLenum mode, const Elements& e) {
  const RealGl& real = p_.shadow.real;
  if (query_ == 0) real.GenQueries(1, &query_);
  real.BeginQuery(GL_SAMPLES_PASSED, query_);
  drawReal(real, mode, e);
  real.EndQuery(GL_SAMPLES_PASSED);
  GLuint samples = 0;
  real.GetQueryObjectuiv(query_, GL_QUERY_RESULT, &samples);
  if (samples == 0) return true;
  p_.sources.refuseDifferent(candidate.program);
  return false;
}

void SmallDraws::forgetOld() {
  if (turn_ < forgotIn_ + kForgottenAfter) return;
  forgotIn_ = turn_;
  std::erase_if(meshes_, [&](const auto& entry) { return entry.second.lastTurn + kForgottenAfter < turn_; });
  const auto waits = [](const auto& entry) { return entry.second.isWaiting(); };
  waiting_ = static_cast<double>(std::ranges::count_if(meshes_, waits));
}

}  // namespace gluray::gl
