#include "gl/culled/culled_draws.h"

#include "base/clock.h"
#include "base/log.h"
#include "gl/culled/assembly.h"
#include "gl/errors.h"
#include "gl/state/state_queries.h"

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

/// While it lives, draws write neither colour nor depth, and pass where the depth is equal.
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

bool CulledDraws::draw(GLenum mode, const Elements& e) noexcept {
  const Settings& settings = p_.shadow.settings;
  if (settings.cull.draws == Culling::automatic && !p_.shadow.isSoftwareBelow()) return false;
  if (settings.cull.draws == Culling::off || p_.failsafe.aside() || p_.shadow.info.off) return false;
  const auto least = static_cast<uint64_t>(std::max(settings.cull.from, 1));
  if (static_cast<uint64_t>(std::max(e.count, 0)) < least) return false;
  return p_.failsafe.protect([&] {
    Plan found;
    const Reason why = plan(mode, e, found);
    if (why != Reason::traced) return p_.counts.notCulled(why), false;
    p_.shadow.errors.keepPending();  // what reads pixels takes errors
    if (settings.cull.verify > 0 && p_.clock.frame % static_cast<uint64_t>(settings.cull.verify) == 0)
      return drawVerified(found, mode, e);
    const bool always = settings.cull.draws == Culling::always;
    const CullingTrials::Next next = found.known->trials.next(always);
    if (next.measured) p_.shadow.real.Finish();
    const double start = next.measured ? nowSeconds() : 0;
    const bool culled = next.way == CullingTrials::Way::culled && drawCulled(found);
    if (!culled) drawReal(p_.shadow.real, mode, e), p_.counts.notCulled(Reason::mostShows);
    if (next.measured) {
      p_.shadow.real.Finish();
      found.known->trials.took(culled ? next.way : CullingTrials::Way::plain, nowSeconds() - start);
    }
    if (found.mesh->visible.empty() && (always || found.known->trials.pays()))
      look(found, found.mesh->visible);
    return true;
  });
}

bool CulledDraws::drawCulled(const Plan& plan) {
  if (plan.rehearsed) return drawRehearsed(plan, std::nullopt);
  CulledMesh& mesh = *plan.mesh;
  const std::vector<uint64_t> guess = mesh.visible;
  if (guess.empty() || !before_.keep(plan.region)) return false;
  drawClusters(mesh, guess);
  std::vector<uint64_t> visible;
  if (!look(plan, visible)) {  // all that was not drawn may show
    before_.putBack();
    return false;
  }
  std::vector<uint64_t> rest = visible;
  without(rest, guess);
  uint64_t drawn = mesh.clusters().primitivesIn(guess);
  if (any(rest)) {
    drawn += mesh.clusters().primitivesIn(rest);
    if (meetsEqual(mesh, rest)) {
      before_.putBack();
      drawClusters(mesh, both(visible, guess));
    } else {
      drawClusters(mesh, rest);
    }
  }
  mesh.visible = std::move(visible);
  countLeft(mesh, drawn);
  return true;
}

void CulledDraws::countLeft(const CulledMesh& mesh, uint64_t drawn) {
  const uint64_t left = mesh.primitives() - std::min<uint64_t>(drawn, mesh.primitives());
  p_.counts.culled(left * (mesh.corners() - 2));
}

bool CulledDraws::drawVerified(const Plan& plan, GLenum mode, const Elements& e) {
  const RealGl& real = p_.shadow.real;
  Pixels culled, whole;
  if (plan.rehearsed && drawRehearsed(plan, Whole{mode, e})) return true;
  if (plan.rehearsed || !drawCulled(plan)) {
    drawReal(real, mode, e);
    look(plan, plan.mesh->visible);
    return true;
  }
  const bool isRead = read(plan, culled);
  before_.putBack();
  drawReal(real, mode, e);
  if (!isRead || !read(plan, whole) || culled == whole) return true;
  isDifferent(plan);
  return true;
}

void CulledDraws::isDifferent(const Plan& plan) {
  if (plan.program)
    plan.program->refuse(Reason::notTheSame);
  else
    plan.known->different = true;
  log::write(log::Level::warning, std::string("culled draws ") +
                                      (plan.program ? "of a shader program" : "by fixed function") +
                                      " were not the same as whole ones: from now on they are made whole");
}

bool CulledDraws::read(const Plan& plan, Pixels& pixels) {
  FramebufferReader& reader = p_.flusher.presenter.reader();
  const RealGl& real = p_.shadow.real;
  if (plan.samples > 1) return reader.readSamples(real, plan.region, pixels.colors);
  return reader.readDepth(real, plan.region, pixels.depths) &&
         reader.readColors(real, plan.region, pixels.colors);
}

bool CulledDraws::readFarthest(const Plan& plan) {
  FramebufferReader& reader = p_.flusher.presenter.reader();
  if (plan.samples > 1) return reader.readFarthest(p_.shadow.real, plan.region, plan.reversed, depths_);
  return reader.readDepth(p_.shadow.real, plan.region, depths_);
}

bool CulledDraws::look(const Plan& plan, std::vector<uint64_t>& visible) {
  if (!readFarthest(plan)) return false;
  if (plan.reversed)
    for (float& depth : depths_) depth = 1 - depth;
  pyramid_.build(depths_.data(), plan.region.width, plan.region.height);
  plan.mesh->clusters().mayShow(plan.matrix, plan.window, &pyramid_, visible);
  return true;
}

void CulledDraws::drawClusters(const CulledMesh& mesh, const std::vector<uint64_t>& clusters) {
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
  real.DrawElements(mesh.mode(), static_cast<GLsizei>(count), GL_UNSIGNED_INT, nullptr);
  real.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLuint>(bound));
}

bool CulledDraws::meetsEqual(const CulledMesh& mesh, const std::vector<uint64_t>& clusters) {
  const RealGl& real = p_.shadow.real;
  if (query_ == 0) real.GenQueries(1, &query_);
  const EqualDepthTest test(real);
  real.BeginQuery(GL_SAMPLES_PASSED, query_);
  drawClusters(mesh, clusters);
  real.EndQuery(GL_SAMPLES_PASSED);
  GLuint samples = 0;
  real.GetQueryObjectuiv(query_, GL_QUERY_RESULT, &samples);
  return samples != 0;
}

}  // namespace gluray::gl
