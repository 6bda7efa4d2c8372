#include "gl/draws/draw_counts.h"

#include <algorithm>

namespace gluray::gl {

void DrawCounts::explain(Reason reason, DrawPath path, PrimitiveClass kind, uint64_t triangles) {
  const auto& program = shadow_.programInUse();
  kinds()->record(shadow_.real, shadow_.state.target, reason, path, kind, triangles, program,
                  shadow_.state.program.why);
}

void DrawCounts::culled(uint64_t leftOut) {
  ++statistics.drawsCulled;
  statistics.trianglesLeftOut += leftOut;
  if (kinds()) [[unlikely]]
    kinds()->culled(leftOut);
}

void DrawCounts::notCulled(Reason reason) {
  if (kinds()) [[unlikely]]
    kinds()->notCulled(reason);
}

void DrawCounts::lit(Reason reason) {
  if (reason == Reason::traced)
    ++statistics.drawsLit;
  else if (kinds()) [[unlikely]]
    kinds()->notLit(reason);
}

void DrawCounts::traced(DrawPath path, uint64_t triangles, uint64_t sent) {
  if (kinds()) [[unlikely]]
    kinds()->record(shadow_.real, shadow_.state.target, Reason::traced, path, PrimitiveClass::surfaces,
                    triangles, shadow_.programInUse());
  ++statistics.drawsTraced;
  statistics.trianglesTraced += triangles;
  load(sent);
  shadow_.current.drawn();
}

void DrawCounts::asRasterised(const scene::Snapshot& snapshot, Reason reason) {
  uint64_t triangles = 0;
  for (const scene::Instance& instance : snapshot.instances) triangles += instance.mesh->triangleCount;
  const uint64_t draws = std::min<uint64_t>(snapshot.instances.size(), statistics.drawsTraced);
  triangles = std::min<uint64_t>(triangles, statistics.trianglesTraced);
  statistics.drawsTraced -= draws;
  statistics.trianglesTraced -= triangles;
  statistics.drawsRasterised += draws;
  statistics.rasterisedBecause[static_cast<size_t>(reason)] += draws;
  statistics.trianglesRasterised += triangles;
}

}  // namespace gluray::gl
