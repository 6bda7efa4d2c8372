// Surfaces of shader programs whose alpha may be below 1, or that write no depth. Decides whether they are
// traced: as opaque ones, or as layers that are blended in drawing order (ADR 0038, ADR 0078).
#include "gl/draws/program_draws.h"
#include "gl/layers/layer_draws.h"

#include <algorithm>

namespace gluray::gl {

namespace {

/// Whether the program may discard fragments whose alpha is 0. Layers would write their depths.
bool mayDiscard(const ProgramState& program) {
  const bool oneAlpha = program.shading.fragment.color == scene::FragmentShading::Color::material &&
                        program.shading.textures.empty();
  return program.known->discardsInvisible && !oneAlpha;
}

}  // namespace

Reason ProgramDraws::ofBlending(const scene::Mesh& mesh) const {
  const ProgramState& program = p_.shadow.program();
  const RasterState& raster = p_.shadow.raster();
  const bool opaque = drawsOpaque(program, mesh, program.color);
  if (!opaque && program.known->family->opaqueColors) return Reason::programValue;
  const bool solid = scene::isSolid(mesh.shape);
  if (opaque && (solid || raster.reason == Reason::traced)) return Reason::traced;
  if (!isBlended(mesh)) return raster.unlessOpaque;
  // Each impostor must produce one fragment per pixel. A stick's box produces two, one for each side, unless
  // one is culled.
  const bool single = mesh.shape == scene::Shape::triangles || mesh.shape == scene::Shape::spheres ||
                      (mesh.shape == scene::Shape::sticks && raster.cull != scene::CullFace::none);
  const bool whole = !raster.writesDepth || !mayDiscard(program);
  const bool grows = program.shading.fragment.edges && program.shading.fragment.edgesGrow;
  if (single && whole && !grows) return Reason::traced;
  return raster.reason != Reason::traced ? raster.reason : raster.unlessOpaque;
}

Reason ProgramDraws::unlessOpaque() const {
  const bool never = p_.shadow.program().known->family->opaqueColors;
  return never ? Reason::programValue : p_.shadow.raster().unlessOpaque;
}

bool ProgramDraws::mayBeBlended() const {
  const ArrayState& arrays = p_.shadow.attributes();
  const bool instanced = !arrays.instanceTransform.empty() || arrays.instanceColor.enabled;
  return !instanced && layersOf(p_.shadow.program()) == BatchKey::Layers::none &&
         p_.layers.drawn.mayBeDrawn();
}

bool ProgramDraws::isBlended(const scene::Mesh& mesh) const {
  const RasterState& raster = p_.shadow.raster();
  if (scene::isSolid(mesh.shape) || !mayBeBlended()) return false;
  if (raster.reason != Reason::traced) return true;
  const ProgramState& program = p_.shadow.program();
  return raster.unlessOpaque != Reason::traced && !drawsOpaque(program, mesh, program.color);
}

}  // namespace gluray::gl
