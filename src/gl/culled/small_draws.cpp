#include "gl/culled/small_draws.h"

#include "gl/batch/clears.h"
#include "gl/culled/clusters/assembly.h"
#include "gl/culled/cullable_state.h"
#include "gl/culled/culled_draws.h"
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

scene::Region between(glm::ivec2 lower, glm::ivec2 upper) {
  return {lower.x, lower.y, upper.x - lower.x, upper.y - lower.y};
}

}  // namespace

bool SmallDraws::isOn() {
  if (frame_ != p_.clock.frame) beginFrame();
  if (!culls_) return false;
  FrameTrials& trials = p_.clock.smallDraws;
  culls_ = !trials.isOver();
  return trials.takes(load_.draws);
}

void SmallDraws::count(const Elements& e) {
  ++load_.draws, load_.vertices += e.count, load_.work += kVerticesOfDraw + e.count;
  if (p_.clock.smallDraws.isMeasured() && !p_.clock.smallDraws.wantsStop()) {
    p_.shadow.real.Finish();
    p_.clock.smallDraws.start(p_.shadow.info.clock());
  }
}

bool SmallDraws::leavesOut(GLenum mode, const Elements& e) {
  const bool on = isOn();
  count(e);
  if (!on || e.count < kFewVertices || e.repeats() != 1 || e.baseInstance != 0) return false;
  FrameTrials& trials = p_.clock.smallDraws;
  if (!trials.isTimed()) {
    trials.worked(trials.drawSeconds());
    return hides(mode, e);
  }
  apartSeconds_ = 0;
  const double start = p_.shadow.info.clock();
  const bool hidden = hides(mode, e);
  trials.worked(p_.shadow.info.clock() - start - apartSeconds_);
  return hidden;
}

bool SmallDraws::hides(GLenum mode, const Elements& e) {
  Candidate candidate;
  if (!find(mode, e, candidate)) return false;
  if (epoch_ != p_.cleared.depthEpoch(common_.reversed)) beginEpoch();
  if (!settles_ && schedule_.isDue()) readDepths();
  if (!mayShow(candidate)) {
    p_.clock.smallDraws.leftOut(candidate.vertices);
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
  FrameTrials& trials = p_.clock.smallDraws;
  load_.waiting = waiting_;
  const FrameTrials::Way way = trials.nextFrame(always, load_);
  culls_ = way != FrameTrials::Way::plain, settles_ = way == FrameTrials::Way::settling;
  frame_ = p_.clock.frame;
  const double work = std::exchange(load_, {}).work;
  buildSeconds_ = 0;
  seen_.any = false, drawn_.clear();
  if (!culls_) return;
  commonIsOld_ = true;
  turn_ += !settles_ ? 1 : trials.takes(0) ? kOfSweep : 0;
  forgetOld();
  if (settles_) return;
  // If a trial has not paid, looks have become rare.
  if (frame_ > culledIn_ + kPause) schedule_ = {};
  culledIn_ = frame_;
  schedule_.beginFrame(!always, work);
  lookedAt_ = p_.shadow.info.clock();
}

void SmallDraws::beginEpoch() {
  epoch_ = p_.cleared.depthEpoch(common_.reversed);
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
  const ViewportState& viewport = shadow.viewport();
  const TargetState& target = shadow.target();
  const glm::ivec4 v = viewport.box, scissor = scissorBox(shadow.real);
  common_.samples = target.samples;
  const int beside = common_.samples > 1 ? 1 : 0;  // samples beside the scissor box (CulledDraws::mapWindow)
  const auto clipped = [&](glm::ivec2 lower, glm::ivec2 upper) {
    lower = glm::max(lower - beside, glm::ivec2(0)), upper += beside;
    return between(lower, target.size.x > 0 ? glm::min(upper, target.size) : upper);
  };
  const glm::ivec2 lower(v.x, v.y), upper(v.x + v.z, v.y + v.w), corner(scissor.x, scissor.y);
  common_.seen = clipped(lower, upper);
  common_.drawn =
      clipped(glm::max(lower, corner), glm::min(upper, corner + glm::ivec2(scissor.z, scissor.w)));
  if (common_.drawn.width <= 0 || common_.drawn.height <= 0) common_.reason = CullReason::smallDraw;
  WindowMapping& window = common_.window;
  window.viewport = glm::dvec4(v.x - common_.seen.x, v.y - common_.seen.y, v.z, v.w);
  window.sampleReach = common_.samples > 1 ? 0.5 : 0;
  window.depthNear = viewport.depthNear, window.depthFar = viewport.depthFar;
  common_.reversed = shadow.raster().isReversed();
  if (common_.reversed) window.depthNear = 1 - window.depthNear, window.depthFar = 1 - window.depthFar;
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
    CulledDraws::Source from;
    if (shadow.info.core || p_.culled.placeByFixedFunction(from) != CullReason::culled) return false;
    candidate.matrix = from.matrix;
    arrays = from.arrays, positions = from.positions, components = from.components;
  }
  return findMesh(mode, e, *arrays, *positions, components, candidate);
}

bool SmallDraws::findByProgram(Candidate& candidate, const ArrayState*& arrays, const ArraySource*& positions,
                               int& components) {
  ShadowState& shadow = p_.shadow;
  CulledProgram& program = p_.culled.programInUse();
  if (program.reason() != CullReason::culled) return false;
  if (isInstanced(shadow.attributes())) return false;
  PlacedPosition placed;
  if (!program.placedPosition(shadow.real, shadow.info.core, placed)) return false;
  candidate.program = &program, candidate.matrix = placed.matrix;
  components = placed.position->components;
  return p_.culled.findPositions(program, placed.position->attribute, arrays, positions);
}

bool SmallDraws::findMesh(GLenum mode, const Elements& e, const ArrayState& arrays,
                          const ArraySource& positions, int components, Candidate& candidate) {
  ShadowState& shadow = p_.shadow;
  const bool always = shadow.settings.cull.draws == Culling::always;
  const bool inBuffers = positions.buffer && (!e.type || arrays.elements);
  if (!positions.enabled || (!inBuffers && !always) || arrays.reason == Reason::deletedBuffer) return false;
  ArrayState content;
  content.vertex = positions, content.vertex.size = std::min(positions.size, components);
  content.elements = arrays.elements;
  if (foreignReason(content) != Reason::traced) return false;
  const Assembly assembly = assemblyOf(shadow.real, shadow.raster().firstVertexProvokes, mode, e);
  if (assembly.restart && !inBuffers) return false;
  Known& known = meshes_[assembly.added(contentOf(shadow.real, content, mode, e))];
  if (known.frames == 0) ++waiting_;
  if (known.frames == 0 || known.lastFrame != frame_) ++known.frames;
  known.lastFrame = frame_, known.lastTurn = turn_;
  if (known.refused) return false;
  FrameTrials& trials = p_.clock.smallDraws;
  if (!always && known.frames < kKnownFrames) return trials.isUnknown(), false;
  if (!known.mesh) {
    // The trials limit the cost of settling.
    if (!always && !settles_ && buildSeconds_ > kBuildSeconds) return trials.isUnknown(), false;
    const double start = p_.shadow.info.clock();
    known.mesh = CulledMesh::create(shadow.real, positions, components, content, assembly, e);
    known.refused = !known.mesh, --waiting_;
    if (known.mesh) known.mesh->build(), known.mesh->forgetVertices();
    buildSeconds_ += p_.shadow.info.clock() - start;
  }
  if (known.refused) return false;
  trials.isBoxed(e.count);
  candidate.mesh = known.mesh;
  return true;
}

/// Whether the depths that were read bound the depths against which the next draw is tested.
bool SmallDraws::isSeen() const {
  return seen_.any && common_.isTested && seen_.reversed == common_.reversed &&
         seen_.epoch == p_.cleared.depthEpoch(seen_.reversed) && contains(seen_.region, common_.drawn);
}

bool SmallDraws::mayShow(const Candidate& candidate) const {
  WindowMapping window = common_.window;
  const bool isBounded = isSeen();
  window.viewport.x += common_.seen.x - seen_.region.x, window.viewport.y += common_.seen.y - seen_.region.y;
  return candidate.mesh->clusters().anyMayShow(
      BoxVisibility(candidate.matrix, window, isBounded ? &seen_.pyramid : nullptr));
}

void SmallDraws::readDepths() {
  ShadowState& shadow = p_.shadow;
  FramebufferReader& reader = p_.pending.presenter.reader();
  FrameTrials& trials = p_.clock.smallDraws;
  const bool wasSeen = isSeen();
  const double before = trials.isTimed() ? shadow.info.clock() : 0;
  if (trials.isTimed()) shadow.real.Finish();  // the cost of earlier drawing does not count
  const double start = trials.isTimed() ? shadow.info.clock() : 0;
  seen_.any = false;
  shadow.errors.keepPending();  // reads of pixels must not find errors pending
  const bool isRead = common_.samples > 1
                          ? reader.readFarthest(shadow.real, common_.seen, common_.reversed, depths_)
                          : reader.readDepth(shadow.real, common_.seen, depths_);
  const double readAt = p_.shadow.info.clock();
  if (isRead) {
    if (common_.reversed)
      for (float& depth : depths_) depth = 1 - depth;
    seen_.pyramid.build(depths_.data(), common_.seen.width, common_.seen.height);
    seen_.region = common_.seen, seen_.reversed = common_.reversed, seen_.any = true;
    seen_.epoch = p_.cleared.depthEpoch(common_.reversed);
  }
  const double now = p_.shadow.info.clock();
  double all = 0, hidden = 0;
  for (const Candidate& drawn : drawn_) {
    all += drawn.vertices;
    if (!mayShow(drawn)) hidden += drawn.vertices;
  }
  const double pixels = double(common_.seen.width) * common_.seen.height;
  // Without earlier depths, a first look is most useful.
  const double wasted = all > 0 ? hidden / all * (readAt - lookedAt_) : 0;
  schedule_.looked(wasSeen || hidden > 0 ? wasted : 2 * wasted, now - readAt + kReadSeconds * pixels);
  drawn_.clear();
  lookedAt_ = p_.shadow.info.clock();
  if (!trials.isTimed()) return trials.looked(lookedAt_ - readAt + kReadSeconds * pixels, lookedAt_);
  trials.looked(lookedAt_ - start, lookedAt_);
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
  p_.culled.refuseDifferent(candidate.program);
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
