#include "gl/culled/drawn_region.h"

#include "gl/real/state_queries.h"

namespace gluray::gl {

DrawnRegion drawnRegionOf(ShadowState& shadow) {
  const TargetState& target = shadow.target();
  const glm::ivec4 v = shadow.viewport().box, scissor = scissorBox(shadow.real);
  const glm::ivec2 lower(v.x, v.y), upper(v.x + v.z, v.y + v.w), corner(scissor.x, scissor.y);
  // Mesa (22.3) draws samples up to one pixel outside the scissor box.
  const int beside = target.samples > 1 ? 1 : 0;
  const auto clipped = [&](glm::ivec2 from, glm::ivec2 to) -> scene::Region {
    from = glm::max(from - beside, glm::ivec2(0)), to += beside;
    if (target.size.x > 0) to = glm::min(to, target.size);
    return {from.x, from.y, to.x - from.x, to.y - from.y};
  };
  return {clipped(glm::max(lower, corner), glm::min(upper, corner + glm::ivec2(scissor.z, scissor.w))),
          clipped(lower, upper), target.samples, shadow.raster().isReversed()};
}

WindowMapping mappingTo(const scene::Region& region, ShadowState& shadow) {
  const ViewportState& viewport = shadow.viewport();
  const glm::ivec4& box = viewport.box;
  // Exact in double precision, unlike in single precision.
  const auto turned = [&](double depth) { return shadow.raster().isReversed() ? 1 - depth : depth; };
  return {.viewport = glm::dvec4(box.x - region.x, box.y - region.y, box.z, box.w),
          .depthNear = turned(viewport.depthNear),
          .depthFar = turned(viewport.depthFar),
          .sampleReach = shadow.target().samples > 1 ? 0.5 : 0};  // anywhere in the pixel
}

void turnDepths(std::vector<float>& depths) {
  for (float& depth : depths) depth = 1 - depth;
}

}  // namespace gluray::gl
