#include "gl/classify/classifier.h"

#include "gl/basics/affine.h"
#include "gl/capture/mesh_builder.h"
#include "gl/classify/solid_draws.h"
#include "gl/layers/layer_draws.h"
#include "gl/textures/texture_env.h"
#include "scene/box_corner.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gluray::gl {
namespace {

/// Alpha of one face's primary colour; 1 if it is the vertices' alpha.
float faceAlpha(const scene::Material& material, scene::ColorMaterial::Mode mode) {
  const bool fromVertex =
      mode == scene::ColorMaterial::diffuse || mode == scene::ColorMaterial::ambientAndDiffuse;
  return fromVertex ? 1.0f : material.diffuse.a;
}

bool usesVertexAlpha(const scene::Shading& shading) {
  const auto uses = [](scene::ColorMaterial::Mode m) {
    return m == scene::ColorMaterial::diffuse || m == scene::ColorMaterial::ambientAndDiffuse;
  };
  return !shading.lighting || uses(shading.colorMaterial.front) || uses(shading.colorMaterial.back);
}

/// Whether height colours never need a power of a negative number, which is undefined.
bool hasDefinedColors(const scene::Mesh& mesh, const ProgramState& program) {
  if (program.shading.fragment.color != scene::FragmentShading::Color::height) return true;
  const scene::HeightColors& height = program.shading.fragment.height;
  const auto base = [&](int c, const glm::vec3& corner) {
    return height.scale[c] * (corner[height.axis] + height.offset[c]);
  };
  for (int c = 0; c < 3; ++c)
    if (height.exponent[c] != 1 && std::min(base(c, mesh.lower), base(c, mesh.upper)) < 0) return false;
  return true;
}

/// Whether all texture coordinates have q = 1: programs use s and t without dividing by q.
bool hasPlainTexcoords(const scene::Mesh& mesh, const float* current) {
  if (!mesh.texcoords) return current[3] == 1;
  if (mesh.texcoords.format != scene::Format::float4) return true;
  for (uint32_t i = 0; i < mesh.vertexCount; ++i)
    if (scene::fetch(mesh.texcoords, i).w != 1) return false;
  return true;
}

/// Whether the mesh lies in front of the viewer's plane, where -z equals the absolute value of z in eye
/// space.
bool isBeforeViewersPlane(const scene::Mesh& mesh, const glm::dmat4& eyeFromObject) {
  for (int corner = 0; corner < 8; ++corner)
    if ((eyeFromObject * glm::dvec4(scene::boxCorner(mesh.lower, mesh.upper, corner), 1)).z > 0) return false;
  return true;
}

/// Whether fixed function makes unit vectors of normals that are not zero, but so short that the square of
/// their length may be: the result is undefined. Normals of length 0 receive no light of light sources.
bool normalizesShort(const KnownMesh& known, ShadowState& shadow) {
  const scene::Shading& shading = shadow.shading();
  if (shadow.raster().program != 0 || !shading.lighting || !shading.normalize) return false;
  const float square = known.mesh->normals ? known.leastSquareOfNormals
                                           : squareOfNormal(glm::make_vec3(shadow.current[kNormal]));
  // The inverse transposed matrix divides lengths by at most the modelview's Frobenius norm.
  const glm::dmat3 m(shadow.modelview());
  const double norm = glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]);
  constexpr double kLeast = 4 * std::numeric_limits<float>::min();  // room for roundings
  return !(square / std::max(norm, 1.0) > kLeast);
}

bool isOpaque(const scene::Shading& shading, const scene::MaterialPair& material) {
  if (!shading.lighting) return true;
  return faceAlpha(material.front, shading.colorMaterial.front) >= 1.0f &&
         (!shading.twoSided || faceAlpha(material.back, shading.colorMaterial.back) >= 1.0f);
}

}  // namespace

Reason Classifier::ofContext() const {
  if (p_.failsafe.aside()) return p_.failsafe.reason();
  if (p_.shadow.info.off) return Reason::off;
  if (p_.shadow.activeQueries > 0) return Reason::query;
  if (const Reason reason = p_.shadow.target().reason; reason != Reason::traced) return reason;
  // Draws by untraced programs, which programs make by the thousand, do not read it back.
  return p_.shadow.lastRaster().reason == Reason::renderMode ? Reason::renderMode : Reason::traced;
}

Reason Classifier::ofImages(bool large) const {
  const bool later =
      !large && p_.clock.choice.way() == EngineChoice::Way::mixed && !p_.pending.knowsSupport();
  return later || p_.pending.canTrace() ? Reason::traced : Reason::noGlsl;
}

Reason Classifier::ofDepths() const {
  const RasterState& raster = p_.shadow.raster();
  if (!raster.isReversed() && !raster.depthsFromZero) return Reason::traced;
  const bool impostors = raster.program != 0 && p_.shadow.attributes().shape != scene::Shape::triangles;
  if (impostors && raster.depthsFromZero) return Reason::clipControl;
  if (!raster.isReversed()) return Reason::traced;
  if (impostors || hasNoDepth()) return Reason::reversedDepth;
  if (raster.program == 0) return Reason::traced;
  const ProgramState& program = p_.shadow.program();
  const bool own = program.shading.fragment.writesDepth || program.depthOffset != scene::PolygonOffset{};
  return own ? Reason::reversedDepth : Reason::traced;
}

Reason Classifier::classify(PrimitiveClass kind) const {
  if (const Reason reason = ofContext(); reason != Reason::traced) return reason;
  const RasterState& raster = p_.shadow.raster();
  const bool solid = drawsSolids(p_.shadow.settings, kind);
  if (kind == PrimitiveClass::points && !solid) return Reason::points;
  if (kind == PrimitiveClass::lines && !solid) return Reason::lines;
  // Fixed function clamps colours to [0, 1].
  if (p_.shadow.target().wideColors && raster.program == 0) return Reason::framebuffer;
  if (solid) {
    if (const Reason reason = solidReason(p_.shadow, kind); reason != Reason::traced) return reason;
  } else if (raster.reason != Reason::traced && !p_.layers.drawn.mayBeDrawn()) {
    return raster.reason;
  }
  if (raster.program != 0) return solid ? Reason::program : ofProgram();
  if (const Reason reason = ofDepths(); reason != Reason::traced) return reason;
  if (raster.firstVertexProvokes && !p_.shadow.shading().smooth) return Reason::provokingVertex;
  if (const Reason reason = p_.shadow.textureReason(); reason != Reason::traced) return reason;
  if (!p_.shadow.modelviewIsInvertible() || !p_.shadow.projectionIsInvertible())
    return Reason::singularMatrix;
  return ofImages(false);
}

/// The shader program in use may compute what a family describes from gl_Vertex and other inputs of fixed
/// function. These inputs are read again for each draw.
Reason Classifier::ofProgram() const {
  ShadowState& shadow = p_.shadow;
  if (!shadow.isDirty(kProgram | kProgramTextures) && readsBuiltIns(shadow.program())) shadow.touch(kProgram);
  shadow.refresh(kProgram | kProgramTextures);
  const ProgramState& program = shadow.program();
  const RasterState& raster = shadow.raster();
  if (!program.known || !readsBuiltIns(program)) {
    const bool told = program.known && program.reason != Reason::traced;
    return told ? program.reason : Reason::program;
  }
  if (program.reason != Reason::traced) return program.reason;
  if (raster.reason != Reason::traced && !p_.layers.drawn.mayBeDrawn()) return raster.reason;
  if (const Reason reason = ofDepths(); reason != Reason::traced) return reason;
  if (raster.alphaTest != scene::AlphaTest{}) return Reason::alphaTest;
  // The alpha that is written equals the colour's only if it is clamped to 1.
  if (shadow.target().wideColors && program.known->family->opaqueColors) return Reason::framebuffer;
  if (!shadow.clipPlanes().empty()) return Reason::program;
  if (!shadow.modelviewIsInvertible() || !shadow.projectionIsInvertible()) return Reason::singularMatrix;
  return ofImages(false);
}

bool Classifier::isOpaqueByProgram(const scene::Mesh& mesh) const {
  return drawsOpaque(p_.shadow.program(), mesh, glm::make_vec4(p_.shadow.current[kColor]));
}

Reason Classifier::ofProgramsMesh(const scene::Mesh& mesh,
                                  const std::vector<MaterialChange>& materials) const {
  const ProgramState& program = p_.shadow.program();
  if (!materials.empty()) return Reason::program;  // programs read them as uniforms
  if (!hasDefinedColors(mesh, program)) return Reason::programValue;
  const scene::Shading& shading = program.shading;
  if (!shading.textures.empty() && !hasPlainTexcoords(mesh, p_.shadow.current[kTexCoord0]))
    return Reason::programValue;
  if (shading.fog.mode != scene::Fog::off && program.known->family->fog.absolute &&
      !isBeforeViewersPlane(mesh, p_.shadow.modelview()))
    return Reason::programValue;
  if (isOpaqueByProgram(mesh)) return Reason::traced;
  if (program.known->family->opaqueColors) return Reason::programValue;
  return p_.layers.drawn.mayBeDrawn() ? Reason::traced : p_.shadow.raster().unlessOpaque;
}

Reason Classifier::classify(const KnownMesh& known, const std::vector<MaterialChange>& materials) {
  Reason reason = whereEverythingIsTraced(known, materials);
  ShadowState& shadow = p_.shadow;
  const auto meetsSampled = [&] {
    return !scene::isSolid(known.mesh->shape) &&
           p_.surfaces.passes.meetsSampled(*known.mesh, shadow.modelview(), depthPlaceOf(shadow),
                                           isPushedBack());
  };
  if (reason == Reason::traced && meetsSampled()) reason = Reason::passes;
  const auto place = [&] {
    return placeOf(shadow.projection() * shadow.modelview(), Batch::offsetOf(shadow.pixelState()));
  };
  if (reason == Reason::traced && p_.surfaces.coplanar.meets(known.mesh, place()))
    reason = Reason::coincident;
  if (reason != Reason::traced) return reason;
  const uint32_t triangles = known.mesh->triangleCount;
  if (isLayer(*known.mesh, materials))
    return p_.layers.drawn.leaves(triangles) ? Reason::smallScene : ofImages(true);
  if (hasNoDepth()) return Reason::flat;
  const EngineChoice& choice = p_.clock.choice;
  const bool leave =
      choice.way() == EngineChoice::Way::mixed && choice.takes(triangles, p_.shadow.viewportPixels());
  return leave ? Reason::smallScene : ofImages(true);
}

Reason Classifier::whereEverythingIsTraced(const KnownMesh& known,
                                           const std::vector<MaterialChange>& materials) const {
  if (known.homogeneous) return Reason::homogeneous;
  if (!known.mesh) return Reason::lines;  // with adjacent vertices
  if (isFarAway(*known.mesh)) return Reason::farAway;
  if (!known.mesh->moderate) return Reason::notFinite;
  ShadowState& shadow = p_.shadow;
  if (normalizesShort(known, shadow)) return Reason::notFinite;
  const glm::dmat4 clipFromObject = shadow.projection() * shadow.modelview();
  const glm::ivec4& viewport = shadow.viewport().box;
  const glm::ivec2 size(viewport.z, viewport.w);
  if (RayPrecision::isFarFromOrigin(*known.mesh, clipFromObject, size)) return Reason::farFromOrigin;
  if (scene::isSolid(known.mesh->shape)) return ofSolids(*known.mesh, materials);
  SurfaceHistory& surfaces = p_.surfaces;
  if (surfaces.precision.isTooLarge(*known.mesh, clipFromObject, size)) return Reason::tooLarge;
  if (surfaces.passes.several(known.mesh->geometryId) ||
      surfaces.passes.meetsRasterised(*known.mesh, shadow.modelview(), depthPlaceOf(shadow), isPushedBack()))
    return Reason::passes;
  if (isFlat(*known.mesh, clipFromObject) || isThin(*known.mesh, clipFromObject)) return Reason::flat;
  const RasterState& raster = shadow.raster();
  // Behind fragments that fail, rays go on to the nearest hit.
  if (hasCoarseDepth() && raster.alphaTest != scene::AlphaTest{} && !isLayer(*known.mesh, materials))
    return Reason::alphaTest;
  if (raster.program != 0) return ofProgramsMesh(*known.mesh, materials);
  if (raster.unlessOpaque == Reason::traced && raster.alphaTest == scene::AlphaTest{}) return Reason::traced;
  if (isOpaque(*known.mesh, materials)) return Reason::traced;
  if (raster.unlessOpaque != Reason::traced && !p_.layers.drawn.mayBeDrawn()) return raster.unlessOpaque;
  // OpenGL tests alpha once per pixel, at its centre. With `--shading sample`, GLuRay tests once per sample.
  const bool perSample = raster.multisample && shadow.target().samples > 1;
  return perSample ? Reason::alphaTest : Reason::traced;
}

Reason Classifier::ofSolids(const scene::Mesh& mesh, const std::vector<MaterialChange>& materials) const {
  ShadowState& shadow = p_.shadow;
  const RasterState& raster = shadow.raster();
  // Plans and menus: if lines have the same depth as other lines, drawing order decides which are visible.
  if (isParallel(shadow.projection()) && isFlat(mesh, shadow.projection() * shadow.modelview()))
    return Reason::flat;
  const bool tested = raster.alphaTest != scene::AlphaTest{};
  if (tested && raster.multisample && shadow.target().samples > 1) return Reason::alphaTest;
  return isOpaque(mesh, materials) ? Reason::traced : raster.unlessOpaque;
}

SurfacePlace Classifier::placeOf(const glm::dmat4& clipFromObject, scene::PolygonOffset offset) const {
  const TargetState& target = p_.shadow.target();
  offset.resolution = target.depthResolution;
  return {depthPlaceOf(p_.shadow), clipFromObject, offset};
}

bool Classifier::isLayer(const scene::Mesh& mesh, const std::vector<MaterialChange>& materials) const {
  const RasterState& raster = p_.shadow.raster();
  if (scene::isSolid(mesh.shape)) return false;
  if (raster.reason != Reason::traced) return true;
  if (raster.unlessOpaque == Reason::traced) return false;
  return raster.program != 0 ? !isOpaqueByProgram(mesh) : !isOpaque(mesh, materials);
}

bool Classifier::isOpaque(const scene::Mesh& mesh, const std::vector<MaterialChange>& materials) const {
  const scene::Shading& shading = p_.shadow.shading();
  const scene::MaterialPair& material = p_.shadow.material();
  const bool vertices =
      !usesVertexAlpha(shading) || (mesh.colors ? mesh.opaqueColors : p_.shadow.current[kColor][3] >= 1.0f);
  const auto opaque = [&](const scene::MaterialPair& m) { return gl::isOpaque(shading, m); };
  return vertices && opaque(material) &&
         std::all_of(materials.begin(), materials.end(),
                     [&](const MaterialChange& change) { return opaque(change.appliedTo(material)); }) &&
         keepOpaque(p_.shadow.fixedTextures());
}

bool Classifier::meetsDepth(PrimitiveClass kind) const {
  const RasterState& raster = p_.shadow.raster();
  const bool tested = raster.reason != Reason::renderMode && raster.reason != Reason::noDepthTest &&
                      raster.depthFunc != GL_ALWAYS && raster.depthFunc != GL_NEVER;
  return kind == PrimitiveClass::surfaces && tested && !p_.failsafe.gone();
}

bool Classifier::leavesDepth(PrimitiveClass kind) const {
  const RasterState& raster = p_.shadow.raster();
  const bool drawn = raster.reason != Reason::renderMode && raster.reason != Reason::noDepthTest &&
                     raster.depthFunc != GL_EQUAL && raster.depthFunc != GL_NEVER;
  return kind == PrimitiveClass::surfaces && drawn && raster.writesDepth && !p_.failsafe.gone() &&
         !p_.shadow.info.off;
}

bool Classifier::isPushedBack() const { return !p_.shadow.raster().isReversed() && increasesDepth(); }

bool Classifier::increasesDepth() const {
  const RasterState& raster = p_.shadow.raster();
  return raster.reason != Reason::polygonMode && raster.increasesDepthOfFills();
}

bool Classifier::fillsArePushedBack() const {
  const RasterState& raster = p_.shadow.raster();
  return raster.reason == Reason::polygonMode && !raster.isReversed() && raster.increasesDepthOfFills();
}

}  // namespace gluray::gl
