#include "base/clock.h"
#include "base/timeline.h"
#include "gl/capture/mesh_builder.h"
#include "gl/commands/array_draws.h"
#include "gl/context/handlers.h"
#include "gl/volumes/volume_draws.h"

namespace gluray::gl {
uint64_t trianglesOf(GLenum mode, const Elements& e) {
  return countTriangles(mode, static_cast<uint64_t>(e.count)) * e.repeats();
}

KnownMesh meshOf(Context& c, const ArrayState& arrays, GLenum mode, const Elements& e) {
  const double start = nowSeconds();
  const timeline::Span span("capture", trianglesOf(mode, e));
  KnownMesh known;
  const Hash128 content = contentOf(c.real, arrays, mode, e);
  if (!c.shadow.group.meshes.find(content, known)) {
    if (arrays.shape != scene::Shape::triangles)
      known = buildImpostorMesh(c.real, arrays, mode, e);
    else if (classOf(mode) != PrimitiveClass::surfaces)
      known = buildMesh(capture(c.real, arrays, mode, e));
    else
      known = buildArrayMesh(c.real, arrays, mode, e);
    c.shadow.group.meshes.put(content, known);
    ++c.counts.statistics.meshesBuilt;
    if (known.mesh) c.counts.statistics.meshBytes += known.mesh->sizeBytes;
  }
  c.counts.statistics.captureSeconds += nowSeconds() - start;
  return known;
}

DrawRequest::Load loadOf(Context& c, GLenum mode, const Elements& e) {
  const uint64_t impostors = static_cast<uint64_t>(e.count) / (mode == GL_LINES ? 2 : 1) * e.repeats();
  if (c.shadow.currentProgram.drawsImpostors(mode)) return {pathOf(e), PrimitiveClass::surfaces, impostors};
  DrawRequest::Load load{pathOf(e), kindOf(mode), trianglesOf(mode, e)};
  const bool chooses = c.clock.choice.active();  // otherwise nobody asks
  if (chooses && mode == GL_TRIANGLES && load.triangles <= kMostVolumeFaces &&
      c.shadow.currentProgram.drawsVolumes())
    load.more = kLoadOfVolume;
  return load;
}

}  // namespace gluray::gl
