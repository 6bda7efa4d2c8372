#include "gl/counts/draw_counts.h"

#include <algorithm>

namespace gluray::gl {

void DrawCounts::explain(Reason reason, DrawPath path, PrimitiveClass kind, uint64_t triangles) {
  const ProgramState& program = shadow_.programInUse();
  const uint32_t state = kinds()->record(shadow_.real, shadow_.target(), reason, path, kind, triangles,
                                         program.known, program.why);
  if (decisions()) decisions()->draw(reason, path, kind, triangles, state);
}

void DrawCounts::culled(uint64_t leftOut) {
  ++statistics.drawsCulled;
  statistics.trianglesLeftOut += leftOut;
  if (!kinds()) [[likely]]
    return;
  kinds()->culled(leftOut);
  if (decisions()) decisions()->detail("culled");
}

void DrawCounts::notCulled(CullReason reason) {
  if (!kinds()) [[likely]]
    return;
  kinds()->notCulled(reason);
  if (decisions()) decisions()->detail("not culled:", describe(reason));
}

void DrawCounts::lit(LightReason reason) {
  const bool lit = reason == LightReason::lit;
  if (lit)
    ++statistics.drawsLit;
  else if (kinds()) [[unlikely]]
    kinds()->notLit(reason);
  if (decisions()) [[unlikely]]
    decisions()->detail(lit ? "lit" : "not lit:", lit ? std::string_view() : describe(reason));
}

void DrawCounts::traced(DrawPath path, uint64_t triangles, uint64_t sent) {
  if (kinds()) [[unlikely]]
    explain(Reason::traced, path, PrimitiveClass::surfaces, triangles);
  ++statistics.drawsTraced;
  statistics.trianglesTraced += triangles;
  load(sent);
}

void DrawCounts::asRasterised(const scene::Snapshot& snapshot, Reason reason) {
  if (decisions()) [[unlikely]]
    decisions()->detail("and its batch: rasterised after all:", describe(reason));
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
