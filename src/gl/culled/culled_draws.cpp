#include "gl/culled/culled_draws.h"

#include "base/log.h"
#include "gl/culled/clusters/assembly.h"
#include "gl/real/errors.h"
#include "gl/real/state_queries.h"

#include <GL/glext.h>

#include <algorithm>
#include <array>
#include <string>
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

/// During its lifetime, draws write neither colour nor depth, and pass if the depth is equal.
class EqualDepthTest {
 public:
  explicit EqualDepthTest(const RealGl& real) : real_(real) {
    real.GetIntegerv(GL_DEPTH_FUNC, &func_);
    real.GetBooleanv(GL_COLOR_WRITEMASK, mask_.data());
    real.DepthFunc(GL_EQUAL);
    real.DepthMask(GL_FALSE);
    colors(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  }
  ~EqualDepthTest() {
    real_.DepthFunc(static_cast<GLenum>(func_));
    real_.DepthMask(GL_TRUE);
    colors(mask_[0], mask_[1], mask_[2], mask_[3]);
  }
  EqualDepthTest(const EqualDepthTest&) = delete;
  EqualDepthTest& operator=(const EqualDepthTest&) = delete;

 private:
  void colors(GLboolean r, GLboolean g, GLboolean b, GLboolean a) {
    isPresent(real_.ColorMaski) ? real_.ColorMaski(0, r, g, b, a) : real_.ColorMask(r, g, b, a);
  }
  const RealGl& real_;
  GLint func_ = GL_LESS;
  std::array<GLboolean, 4> mask_{};
};

}  // namespace

CulledDraws::~CulledDraws() { job_.stop(); }

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
  return small_.isOn() ? Part::whole : Part::nothing;
}

void CulledDraws::count(const Elements& e) {
  if (isActive()) small_.count(e);
}

bool CulledDraws::draw(GLenum mode, const Elements& e, const std::function<void()>& first) noexcept {
  const Settings& settings = p_.shadow.settings;
  if (!isActive()) return false;
  if (!isLarge(e)) return p_.failsafe.protect([&] { return small_.leavesOut(mode, e); });
  return p_.failsafe.protect([&] {
    Plan found;
    placed_ = false;
    const CullReason why = plan(mode, e, found);
    if (why != CullReason::culled) return p_.counts.notCulled(why), false;
    if (first) first();
    if (first && !choosePlace(found))
      return drawWhole(found), p_.counts.notCulled(CullReason::samplesInUse), true;
    p_.shadow.errors.keepPending();  // reads of pixels must not find errors pending
    if (settings.cull.verify > 0 && p_.clock.frame % static_cast<uint64_t>(settings.cull.verify) == 0)
      return drawVerified(found);
    drawTried(found);
    return true;
  });
}

void CulledDraws::drawTried(const Plan& plan) {
  const bool always = p_.shadow.settings.cull.draws == Culling::always;
  History& history = *plan.history;
  const CullingTrials::Next next = history.trials.nextDraw(always, trials_);
  const auto finished = [&] {
    if (next.measured) p_.shadow.real.Finish();
    return next.measured ? p_.shadow.info.clock() : 0;
  };
  const double start = finished();
  const bool wanted = next.way == CullingTrials::Way::culled, culled = wanted && drawCulled(plan);
  if (!culled) drawWhole(plan), p_.counts.notCulled(CullReason::mostShows);
  const double seconds = finished() - start;
  if (next.measured) history.trials.took(next.way, culled, seconds, trials_);
  if (!history.visible.empty() || (!always && !history.trials.pays()) || !placeClusters(plan)) return;
  findVisible(plan, history.visible);
  if (next.measured) trials_.spend(finished() - start - seconds);
}

bool CulledDraws::drawCulled(const Plan& plan) {
  if (!placeClusters(plan)) return false;
  if (plan.rehearsed) return drawRehearsed(plan, false);
  const std::vector<uint64_t> guess = plan.history->visible;
  if (guess.empty() || !before_.keep(plan.region)) return false;
  drawParts(plan, guess);
  std::vector<uint64_t> visible;
  if (!findVisible(plan, visible)) {  // parts that were not drawn may be visible
    before_.putBack();
    return false;
  }
  std::vector<uint64_t> rest = visible;
  without(rest, guess);
  uint64_t drawn = primitivesIn(plan, guess);
  if (any(rest)) {
    drawn += primitivesIn(plan, rest);
    if (meetsEqual(plan, rest)) {
      before_.putBack();
      drawParts(plan, both(visible, guess));
    } else {
      drawParts(plan, rest);
    }
  }
  plan.history->visible = std::move(visible);
  countLeft(plan, drawn);
  return true;
}

void CulledDraws::countLeft(const Plan& plan, uint64_t drawn) {
  const CulledMesh& mesh = *plan.mesh;
  const uint64_t all = uint64_t{mesh.primitives()} * plan.elements.repeats();
  p_.counts.culled((all - std::min(drawn, all)) * (mesh.corners() - 2));
}

bool CulledDraws::drawVerified(const Plan& plan) {
  Pixels culled, whole;
  const bool placed = placeClusters(plan);
  if (placed && plan.rehearsed && drawRehearsed(plan, true)) return true;
  if (!placed || plan.rehearsed || !drawCulled(plan)) {
    drawWhole(plan);
    if (placed) findVisible(plan, plan.history->visible);
    return true;
  }
  const bool isRead = read(plan, culled);
  before_.putBack();
  drawWhole(plan);
  if (!isRead || !read(plan, whole) || culled == whole) return true;
  markDifferent(plan);
  return true;
}

void CulledDraws::markDifferent(const Plan& plan) {
  if (!plan.program) plan.known->different = true;
  refuseDifferent(plan.program);
}

void CulledDraws::refuseDifferent(CulledProgram* program) {
  if (program)
    program->refuse(CullReason::notTheSame);
  else
    fixedDiffers_ = true;
  log::write(log::Level::warning, std::string("culled draws ") +
                                      (program ? "of a shader program" : "by fixed function") +
                                      " differ from complete draws: GLuRay does not cull them any more");
}

bool CulledDraws::read(const Plan& plan, Pixels& pixels) {
  FramebufferReader& reader = p_.pending.presenter.reader();
  const RealGl& real = p_.shadow.real;
  if (plan.samples > 1) return reader.readSamples(real, plan.region, pixels.colors);
  return reader.readDepth(real, plan.region, pixels.depths) &&
         reader.readColors(real, plan.region, pixels.colors);
}

bool CulledDraws::readFarthest(const Plan& plan) {
  FramebufferReader& reader = p_.pending.presenter.reader();
  if (plan.samples > 1) return reader.readFarthest(p_.shadow.real, plan.region, plan.reversed, depths_);
  return reader.readDepth(p_.shadow.real, plan.region, depths_);
}

bool CulledDraws::findVisible(const Plan& plan, std::vector<uint64_t>& visible) {
  if (!readFarthest(plan)) return false;
  if (plan.reversed)
    for (float& depth : depths_) depth = 1 - depth;
  pyramid_.build(depths_.data(), plan.region.width, plan.region.height);
  const Clusters& clusters = plan.mesh->clusters();
  if (plan.byClusters)
    findClustersOfInstances(plan, pyramid_, visible);
  else if (plan.instances && plan.units)
    plan.instances->mayShow(clusters, plan.window, &pyramid_, visible);
  else if (plan.units)
    plan.mesh->units().mayShow(plan.window, &pyramid_, visible);
  else
    clusters.mayShow(plan.matrix, plan.window, &pyramid_, visible);
  return true;
}

void CulledDraws::drawClusters(const CulledMesh& mesh, std::span<const uint64_t> clusters,
                               const Elements& as) {
  const RealGl& real = p_.shadow.real;
  indices_.resize(mesh.corners() * mesh.clusters().primitivesIn(clusters));
  const size_t count = mesh.write(clusters, indices_.data());
  if (count == 0) return;
  const WithoutRestart vertices(real);
  const GLint bound = integer(real, GL_ELEMENT_ARRAY_BUFFER_BINDING);
  if (indexBuffer_ == 0) real.GenBuffers(1, &indexBuffer_);
  real.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indexBuffer_);
  real.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(count * sizeof(uint32_t)), indices_.data(),
                  GL_STREAM_DRAW);
  drawReal(real, mesh.mode(),
           {0, static_cast<GLsizei>(count), GL_UNSIGNED_INT, nullptr, 0, as.instances, as.baseInstance});
  real.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLuint>(bound));
}

bool CulledDraws::meetsEqual(const Plan& plan, const std::vector<uint64_t>& parts) {
  const RealGl& real = p_.shadow.real;
  if (query_ == 0) real.GenQueries(1, &query_);
  const EqualDepthTest test(real);
  real.BeginQuery(GL_SAMPLES_PASSED, query_);
  drawParts(plan, parts);
  real.EndQuery(GL_SAMPLES_PASSED);
  GLuint samples = 0;
  real.GetQueryObjectuiv(query_, GL_QUERY_RESULT, &samples);
  return samples != 0;
}

}  // namespace gluray::gl
