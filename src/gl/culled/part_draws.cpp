#include "gl/culled/part_draws.h"

#include "gl/culled/drawn_region.h"
#include "gl/culled/instances/instance_draws.h"
#include "gl/real/state_queries.h"

#include <GL/glext.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace gluray::gl {
namespace {

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

bool PartDraws::placeClusters(const CullPlan& plan) {
  if (!plan.feedback || placed_) return true;
  CulledMesh& mesh = *plan.mesh;
  const auto take = [&](const std::byte* positions) {
    if (!plan.units) return mesh.refit(positions);
    const size_t vertices = mesh.endVertex() - mesh.firstVertex();
    const size_t step = PositionFeedback::kStride * vertices * plan.units->size();
    mesh.refit(positions, step, plan.units->units());
  };
  placed_ = plan.feedback->capture(shadow_.real, mesh.firstVertex(), mesh.endVertex(), plan.elements, take);
  if (!placed_) plan.known->refused = true;
  return placed_;
}

bool PartDraws::readFarthest(const CullPlan& plan) {
  FramebufferReader& reader = pending_.presenter.reader();
  if (plan.samples > 1) return reader.readFarthest(shadow_.real, plan.region, plan.reversed, depths_);
  return reader.readDepth(shadow_.real, plan.region, depths_);
}

bool PartDraws::findVisible(const CullPlan& plan, std::vector<uint64_t>& visible) {
  if (!readFarthest(plan)) return false;
  if (plan.reversed) turnDepths(depths_);
  pyramid_.build(depths_.data(), plan.region.width, plan.region.height);
  plan.findVisible(pyramid_, visible);
  return true;
}

bool PartDraws::meetsEqual(const CullPlan& plan, const std::vector<uint64_t>& parts) {
  const RealGl& real = shadow_.real;
  if (query_ == 0) real.GenQueries(1, &query_);
  const EqualDepthTest test(real);
  real.BeginQuery(GL_SAMPLES_PASSED, query_);
  drawParts(plan, parts);
  real.EndQuery(GL_SAMPLES_PASSED);
  GLuint samples = 0;
  real.GetQueryObjectuiv(query_, GL_QUERY_RESULT, &samples);
  return samples != 0;
}

void PartDraws::drawClusters(const CulledMesh& mesh, std::span<const uint64_t> clusters, const Elements& as) {
  const RealGl& real = shadow_.real;
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

void PartDraws::drawParts(const CullPlan& plan, const std::vector<uint64_t>& parts) {
  const CulledMesh& mesh = *plan.mesh;
  if (!plan.units || plan.drawsAllInstances()) return drawClusters(mesh, parts, plan.elements);
  InstanceDraws draws(shadow_.real, shadow_.attributes(), *plan.units);
  if (plan.byClusters)
    return plan.forClustersOfInstances(parts, [&](uint32_t unit, std::span<const uint64_t> clusters) {
      const bool any = std::ranges::any_of(clusters, [](uint64_t word) { return word != 0; });
      if (any)
        drawClusters(mesh, clusters, draws.elementsOf(plan.elements, plan.units->part(unit, unit + 1)));
    });
  plan.units->forParts(parts, [&](const InstancePart& part) {
    drawReal(shadow_.real, plan.mode, draws.elementsOf(plan.elements, part));
  });
}

}  // namespace gluray::gl
