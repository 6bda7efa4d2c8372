// Array draws by shader programs.
#include "gl/commands/array_draws.h"
#include "gl/commands/raster_light.h"
#include "gl/context/handlers.h"
#include "gl/commands/shown_places.h"
#include "gl/context/stub.h"

namespace gluray::gl {
namespace {

Reason triageByPass(Context& c, PrimitiveClass kind) {
  switch (layersOf(c.shadow.state.program)) {
    case BatchKey::Layers::peeled: return c.layers.triagePeel(kind);
    case BatchKey::Layers::summed: return c.layers.triageSum(kind);
    case BatchKey::Layers::none:
    case BatchKey::Layers::drawn:
    case BatchKey::Layers::factors: break;
  }
  return c.programs.triage(kind);
}

/// Traces a draw of the current shader program if triage allows it; otherwise returns why not.
Reason traceProgram(Context& c, GLenum mode, const Elements& e) {
  if (mode > GL_POLYGON) return Reason::program;
  const bool sent = c.shadow.attributes.sentBillboards && (mode == GL_TRIANGLES || mode == GL_QUADS);
  const bool impostors = sent || c.shadow.program.drawsImpostors(mode);
  const PrimitiveClass kind = impostors ? PrimitiveClass::surfaces : classOf(mode);
  Reason reason = triageByPass(c, kind);
  if (reason == Reason::traced && impostors) reason = c.programs.triageImpostors();
  if (reason != Reason::traced) return reason;
  // A program that expects impostors draws surfaces in a way that is unknown.
  if (!impostors && c.shadow.attributes.shape != scene::Shape::triangles) return Reason::program;
  return c.failsafe.attempt([&] {
    const KnownMesh known = meshOf(c, c.shadow.attributes, mode, e);
    // An impostor is as much work for the real OpenGL as the triangles of its billboard.
    const uint64_t drawn = known.mesh ? uint64_t{known.mesh->triangleCount} * e.repeats() : 0;
    const uint64_t load = sent ? trianglesOf(mode, e) : drawn;
    Reason fine = c.programs.triage(known, load);
    if (fine == Reason::traced) fine = c.programs.triageInstances(*known.mesh, e);
    if (fine == Reason::traced) fine = c.programs.add(known.mesh, mode, e);
    if (fine != Reason::traced) return fine;
    c.counts.traced(pathOf(e), drawn, load);
    return fine;
  });
}

/// The same for a program whose vertices are those of fixed function's arrays.
Reason traceBuiltInVertices(Context& c, GLenum mode, const Elements& e) {
  c.shadow.refresh(kDrawGroups | kFixedArrays);
  // Attribute 0 takes the place of gl_Vertex. Without a position array the current position may be used.
  const bool plain = c.shadow.attributes.generic.empty() && c.shadow.arrays.vertex.enabled;
  return plain && e.instances < 0 ? traceFixedArrays(c, mode, e) : Reason::arrayState;
}

}  // namespace

void drawByProgram(Context& c, GLenum mode, const Elements& e) {
  c.shadow.refresh(kProgramGroups);
  c.immediate.closeRunIfOpen();
  if (passOf(c.shadow.state.program) == Family::Pass::peelDepths) {
    bool held = false;
    c.protect([&] { held = c.layers.holdDepths(mode, e, trianglesOf(mode, e)); });
    if (held) return;
  }
  if (c.layers.drawsNothing()) return;
  if (c.layers.asks()) {
    bool held = false;
    c.protect([&] { held = c.layers.holdLater(mode, e); });
    if (held) return;
  }
  const bool builtIn = readsBuiltIns(c.shadow.state.program);
  const Reason reason = builtIn ? traceBuiltInVertices(c, mode, e) : traceProgram(c, mode, e);
  if (reason == Reason::traced) return;
  if (reason == Reason::programPass) {
    bool done = false;
    c.protect([&] { done = c.fullscreen.replace(mode, e); });
    if (done) return;
  }
  const Load load = loadOf(c, mode, e);
  if (c.surfaces.objects.asked()) [[unlikely]]
    c.protect([&] { c.surfaces.objects.placed(placesOf(c.shadow, e)); });
  c.protect([&] {
    if (!c.surfaces.passes.any() && c.untraced.areAll())
      rememberUntraced(c, mode, e);
    else
      c.programs.meetPasses(load.kind, mode, e);
  });
  if (!c.info().core && mode <= GL_POLYGON) meetFixedArrays(c, load.kind, Reason::program, mode, e);
  c.counts.rasterised(reason, pathOf(e), load.kind, load.triangles);
  c.raster.before(load.kind);
  c.shadow.sendBuffers();
  if (!c.culled.draw(mode, e)) drawReal(c.real, mode, e);
  lightRasterised(c, mode, e);
}

}  // namespace gluray::gl
