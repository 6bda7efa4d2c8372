// Surfaces of shader programs whose alpha may be below 1, or that write no depth. Decides whether they are
// traced: as opaque ones, or as layers that are blended in drawing order (ADR 0038, ADR 0078).
#include "gl/draws/program_draws.h"
#include "gl/layers/layer_draws.h"

#include <algorithm>
#include <cmath>

namespace gluray::gl {

namespace {

/// Distance of the corners of a gaussian's billboard from its centre, in radii.
float reachOfGaussian(const ProgramState& program, scene::Shape shape) {
  const scene::Impostors& f = program.impostors;
  return shape == scene::Shape::discs ? 2 * f.radiusDivisor : std::sqrt(2.0f) * f.billboardScale;
}

/// Whether the program may discard fragments whose alpha is 0. Layers would write their depths.
bool mayDiscard(const ProgramState& program, const scene::Mesh& mesh) {
  using Color = scene::FragmentShading::Color;
  constexpr float kFarthest = 12;  // radii; beyond, opacities of gaussians fall to 0 in floats
  const scene::FragmentShading& f = program.shading.fragment;
  if (program.shading.alphaTest != scene::AlphaTest{}) return false;  // it discards them
  const bool oneAlpha = f.color == Color::material && program.shading.textures.empty();
  if (!program.known->discardsInvisible || program.impostors.antialiased) return false;
  if (!program.impostors.gaussian) return !oneAlpha;
  const bool paints = f.color == Color::vertices && (mesh.colors ? mesh.opaqueColors : program.color.a > 0);
  return reachOfGaussian(program, mesh.shape) > kFarthest || !(program.material.front.diffuse.a > 0) ||
         !(oneAlpha || paints);
}

/// Whether each of the mesh's impostors is one fragment of a pixel. A stick's box makes two, one for each
/// side, unless one is culled.
bool isSingle(const scene::Mesh& mesh, const ProgramState& program, const RasterState& raster) {
  using scene::Shape;
  const bool flat = mesh.shape == Shape::splats || mesh.shape == Shape::discs;
  return mesh.shape == Shape::triangles || mesh.shape == Shape::spheres ||
         (flat && program.impostors.fillsBillboard()) ||
         (mesh.shape == Shape::sticks && raster.cull != scene::CullFace::none);
}

}  // namespace

Reason ProgramDraws::ofBlending(const scene::Mesh& mesh) const {
  const ProgramState& program = p_.shadow.program();
  const RasterState& raster = p_.shadow.raster();
  const bool opaque = drawsOpaque(program, mesh, program.color);
  if (!opaque && program.known->family->opaqueColors) return Reason::programValue;
  const bool solid = scene::isSolid(mesh.shape);
  const bool instanced = !p_.shadow.attributes().instanceTransform.empty();  // see classifyInstances()
  if (!solid && !instanced && p_.classifier.isThin(mesh, program.clipFromObject)) return Reason::flat;
  if (opaque && (solid || raster.reason == Reason::traced)) return ofCoarseDepth();
  if (!isBlended(mesh)) return raster.unlessOpaque;
  const bool single = isSingle(mesh, program, raster);
  const bool whole = !raster.writesDepth || !mayDiscard(program, mesh);
  const bool grows = program.shading.fragment.edges && program.shading.fragment.edgesGrow;
  if (single && whole && !grows) return Reason::traced;
  return raster.reason != Reason::traced ? raster.reason : raster.unlessOpaque;
}

Reason ProgramDraws::ofCoarseDepth() const {
  if (!p_.classifier.hasCoarseDepth()) return Reason::traced;
  const scene::Shading& shading = p_.shadow.program().shading;
  if (shading.alphaTest != scene::AlphaTest{}) return Reason::alphaTest;
  return shading.fragment.edges && shading.fragment.edgesGrow ? Reason::program : Reason::traced;
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
