#include "gl/commands/program_arrays_draw.h"

#include "gl/commands/array_draws.h"
#include "gl/commands/raster_light.h"
#include "gl/commands/shown_places.h"
#include "gl/context/context.h"

namespace gluray::gl {
namespace {

Reason classifyPass(Context& c, PrimitiveClass primitive) {
  switch (layersOf(c.shadow.program())) {
    case BatchKey::Layers::peeled: return c.layers.peels.classify(primitive);
    case BatchKey::Layers::summed: return c.layers.sums.classify(primitive);
    case BatchKey::Layers::none:
    case BatchKey::Layers::drawn:
    case BatchKey::Layers::visibility: break;
  }
  return c.programs.classify(primitive);
}

/// The points at which a strip of four vertices shows an impostor for each of its instances.
std::optional<Elements> pointsOf(GLenum mode, const Elements& drawn) {
  if (mode != GL_TRIANGLE_STRIP || drawn.type != 0 || drawn.count != 4 || drawn.first % 4 != 0)
    return std::nullopt;
  Elements points;
  points.first = static_cast<GLint>(drawn.baseInstance), points.count = static_cast<GLsizei>(drawn.repeats());
  return points;
}

std::optional<Elements> verticesOf(ShadowState& shadow, GLenum mode, const Elements& drawn) {
  if (shadow.attributes().ofInstances) return pointsOf(mode, drawn);
  const std::optional<PulledVertices>& pulled = shadow.program().pulled;
  if (!pulled) return drawn;
  return modeOf(*pulled, mode) ? elementsOf(*pulled, drawn) : std::nullopt;
}

/// The primitives that the program shows; those of the draw if it shows none.
GLenum shownModeOf(ShadowState& shadow, GLenum mode) {
  if (shadow.attributes().ofInstances) return GL_POINTS;
  const std::optional<PulledVertices>& pulled = shadow.program().pulled;
  return pulled ? modeOf(*pulled, mode).value_or(mode) : mode;
}

}  // namespace

ProgramArraysDraw::ProgramArraysDraw(Context& context, GLenum mode, const Elements& elements)
    : c_(context),
      mode_(mode),
      elements_(elements),
      shownMode_(shownModeOf(context.shadow, mode)),
      vertices_(verticesOf(context.shadow, mode, elements)),
      fixed_(context, mode, elements),
      ofInstances_(context.shadow.attributes().ofInstances),
      takesFixed_(readsBuiltIns(context.shadow.program())),
      sentBillboards_(context.shadow.attributes().sentBillboards &&
                      (mode == GL_TRIANGLES || mode == GL_QUADS)),
      impostors_(sentBillboards_ || (context.shadow.program().known &&
                                     drawsImpostors(*context.shadow.program().known, shownMode_))) {}

Reason ProgramArraysDraw::classifyState() {
  if (takesFixed_) {
    c_.shadow.refresh(kDrawGroups | kFixedArrays);
    // Attribute 0 replaces gl_Vertex.
    return c_.shadow.attributes().generic.empty() ? fixed_.classifyState() : Reason::arrayState;
  }
  if (mode_ > GL_POLYGON) return Reason::program;
  if (!vertices_ || c_.shadow.isRestarted(c_.shadow.attributes(), elements_)) return Reason::arrayState;
  Reason reason = classifyPass(c_, impostors_ ? PrimitiveClass::surfaces : classOf(shownMode_));
  if (reason == Reason::traced && impostors_) reason = c_.programs.classifyImpostors();
  if (reason != Reason::traced) return reason;
  // Surfaces drawn by a program that expects impostors have an unknown look.
  const bool odd = !impostors_ && c_.shadow.attributes().shape != scene::Shape::triangles;
  return odd ? Reason::program : Reason::traced;
}

KnownMesh ProgramArraysDraw::mesh() {
  return takesFixed_ ? fixed_.mesh() : meshOf(c_, c_.shadow.vertices(), shownMode_, *vertices_);
}

uint64_t ProgramArraysDraw::shown(const KnownMesh& known) const {
  return known.mesh ? uint64_t{known.mesh->triangleCount} * repeated().repeats() : 0;
}

uint64_t ProgramArraysDraw::sent(const KnownMesh& known) const {
  return sentBillboards_ || ofInstances_ ? trianglesOf(mode_, elements_) : shown(known);
}

Reason ProgramArraysDraw::classifyMesh(const KnownMesh& known) {
  if (takesFixed_) return fixed_.classifyMesh(known);
  if (known.mesh && !c_.shadow.takeValuesOfCells(known.mesh->triangleCount)) return Reason::arrayState;
  const Reason reason = c_.programs.classify(known, sent(known));
  return reason == Reason::traced ? c_.programs.classifyInstances(*known.mesh, repeated()) : reason;
}

Reason ProgramArraysDraw::trace(const KnownMesh& known) {
  if (takesFixed_) return fixed_.trace(known);
  const Reason reason = c_.programs.add(known.mesh, mode_, elements_);
  if (reason == Reason::traced) {
    c_.counts.traced(pathOf(elements_), shown(known), sent(known));
    c_.shadow.drawnTraced();
  }
  return reason;
}

bool ProgramArraysDraw::traceVolume() {
  if (!c_.protect([&] { return c_.volumes.draw(mode_, elements_); })) return false;
  c_.counts.traced(pathOf(elements_), trianglesOf(mode_, elements_));
  c_.counts.load(kLoadOfVolume);
  return true;
}

bool ProgramArraysDraw::replace(Reason reason) {
  if (reason == Reason::volume) return traceVolume();
  return reason == Reason::programPass && c_.protect([&] { return c_.fullscreen.replace(mode_, elements_); });
}

void ProgramArraysDraw::meetPasses(PrimitiveClass primitive, Reason) {
  if (c_.surfaces.objects.asked()) [[unlikely]]
    c_.protect([&] { c_.surfaces.objects.placed(placesOf(c_.shadow, elements_)); });
  c_.protect([&] {
    if (!c_.surfaces.passes.any() && c_.untraced.areAll())
      rememberUntraced(c_, mode_, elements_);
    else
      c_.programs.meetPasses(primitive, shownMode_, vertices_.value_or(elements_));
  });
  if (!c_.info().core && mode_ <= GL_POLYGON) fixed_.meetPasses(primitive, Reason::program);
}

DrawRequest::Load ProgramArraysDraw::load() {
  if (!impostors_ || sentBillboards_ || ofInstances_ || !vertices_) return loadOf(c_, mode_, elements_);
  const uint64_t corners = shownMode_ == GL_LINES ? 2 : 1;
  return {pathOf(elements_), PrimitiveClass::surfaces,
          static_cast<uint64_t>(vertices_->count) / corners * elements_.repeats()};
}

Fate ProgramArraysDraw::make() {
  const bool culled = c_.culled.draw(mode_, elements_);
  if (!culled) drawReal(c_.real, mode_, elements_);
  lightRasterised(c_, mode_, elements_);
  return culled ? Fate::culled : Fate::rasterised;
}

}  // namespace gluray::gl
