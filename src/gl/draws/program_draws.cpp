#include "gl/draws/program_draws.h"

#include "gl/arrays/array_indices.h"
#include "gl/basics/affine.h"
#include "gl/basics/regions.h"
#include "gl/capture/mesh_builder.h"
#include "gl/classify/solid_draws.h"
#include "gl/impostors/sent_billboards.h"
#include "gl/layers/layer_draws.h"
#include "gl/real/state_queries.h"
#include "scene/secondary_scene.h"

#include <algorithm>

namespace gluray::gl {

namespace {

/// Why points or lines are not traced.
Reason reasonOf(PrimitiveClass kind) {
  return kind == PrimitiveClass::points ? Reason::points : Reason::lines;
}

}  // namespace

Reason ProgramDraws::classify(PrimitiveClass kind) {
  const Reason context = p_.classifier.ofContext();
  // Volumes need no depth buffer.
  if (context == Reason::noDepthBuffer && p_.shadow.program().reason == Reason::volume) return Reason::volume;
  if (context != Reason::traced) return context;
  const bool solid = drawsSolids(p_.shadow.settings, kind);
  // The program's reason is more useful to the user than the kind of primitive, unless it follows from it.
  const auto& known = p_.shadow.program().known;
  const bool ofSurfaces = known && known->family && known->family->pulling.given();
  if (kind != PrimitiveClass::surfaces && ofSurfaces && !solid) return reasonOf(kind);
  if (p_.shadow.program().reason != Reason::traced) return p_.shadow.program().reason;
  if (!solid && p_.shadow.program().known->family->onlySolids) return Reason::program;
  if (kind != PrimitiveClass::surfaces && !solid) return reasonOf(kind);
  if (solid) {
    if (layersOf(p_.shadow.program()) != BatchKey::Layers::none) return Reason::lines;
    if (const Reason reason = programSolidReason(p_.shadow, kind); reason != Reason::traced) return reason;
  } else if (p_.shadow.raster().reason != Reason::traced && !mayBeBlended()) {
    return p_.shadow.raster().reason;
  }
  if (const Reason reason = p_.classifier.ofDepths(); reason != Reason::traced) return reason;
  if (p_.shadow.raster().alphaTest != scene::AlphaTest{}) return Reason::alphaTest;
  // The program's colours may pass through gl_FrontColor.
  if (const Family& family = *p_.shadow.program().known->family;
      !p_.shadow.info.core && family.clampedColors) {
    p_.shadow.setProgramWhy(builtInColorObstacle(p_.shadow.real, family));
    if (!p_.shadow.program().why.empty()) return Reason::programValue;
  }
  if (p_.shadow.program().known->program.blocks)
    p_.shadow.expire(kProgram);  // changes of uniform buffers are not tracked
  if (!p_.shadow.info.core && !p_.shadow.clipPlanes().empty())
    return Reason::program;  // programs compute clip distances in unknown ways
  if (p_.shadow.attributes().reason != Reason::traced) return p_.shadow.attributes().reason;
  return p_.classifier.ofImages(false);
}

namespace {

/// The depth offset of the program's draws: the program's own or, if it does not write depth, OpenGL's.
scene::PolygonOffset offsetOf(ShadowState& shadow, scene::Shape shape) {
  const ProgramState& program = shadow.program();
  if (scene::isSolid(shape) || shadow.raster().isReversed()) return {};  // not traced
  if (program.depthOffset != scene::PolygonOffset{}) return program.depthOffset;
  return shape == scene::Shape::triangles ? Batch::offsetOf(shadow.pixelState()) : scene::PolygonOffset{};
}

/// Whether a polygon offset is on, but the program writes depth itself or draws layers.
bool offsetsProgramDepth(ShadowState& shadow, scene::Shape shape) {
  const RasterState& raster = shadow.raster();
  const ProgramState& program = shadow.program();
  if (!raster.offsetFill || (raster.offsetFactor == 0 && raster.offsetUnits == 0)) return false;
  return shape == scene::Shape::triangles &&
         (program.shading.fragment.writesDepth || layersOf(program) != BatchKey::Layers::none);
}

/// Whether the draw has values that its program clamps, or that its family does not describe.
bool hasOtherValues(const ProgramState& program, const scene::Mesh& mesh, const Settings& settings) {
  const bool edgesAlone = program.shading.fragment.edges && program.shading.fragment.edgesAlone;
  if (edgesAlone && scene::needsSecondaryScene(settings)) return true;  // rays from elsewhere meet triangles
  return program.known->family->colorsFromZero && hasNegativeColors(mesh, program.color);
}

/// Whether one of the arrays is in a buffer whose contents cannot be read.
bool haveUnreadableBuffers(const ArrayState& arrays) {
  return arrays.reason == Reason::deletedBuffer || arrays.reason == Reason::foreignBuffer ||
         arrays.reason == Reason::persistentMapping;
}

}  // namespace

Reason ProgramDraws::classify(const KnownMesh& known, uint64_t load) {
  Reason reason = classifyAlways(known);
  const ProgramState& program = p_.shadow.program();
  if (layersOf(program) == BatchKey::Layers::peeled)
    return reason == Reason::traced ? p_.classifier.ofImages(true) : reason;
  const bool single = reason == Reason::traced && layersOf(program) == BatchKey::Layers::none &&
                      p_.shadow.attributes().instanceTransform.empty();
  if (single &&
      p_.surfaces.coplanar.meets(
          known.mesh, p_.classifier.placeOf(program.clipFromObject, offsetOf(p_.shadow, known.mesh->shape))))
    reason = Reason::coincident;
  if (reason != Reason::traced) return reason;
  if (isBlended(*known.mesh))
    return p_.layers.drawn.leaves(load) ? Reason::smallScene : p_.classifier.ofImages(true);
  if (p_.classifier.hasNoDepth()) return Reason::flat;
  // Judged for each draw and not for their sum, so that a surface that is drawn again is drawn in the same
  // way.
  const bool leave = p_.clock.leavesAlone(load, p_.shadow.viewportPixels());
  return leave ? Reason::smallScene : p_.classifier.ofImages(true);
}

Reason ProgramDraws::classifyAlways(const KnownMesh& known) const {
  if (known.homogeneous) return Reason::homogeneous;
  if (!known.mesh)  // incomplete billboards; lines with adjacent vertices
    return p_.shadow.attributes().sentBillboards ? Reason::arrayState : Reason::lines;
  if (known.mesh->shape == scene::Shape::sticks &&
      !showsSticks(p_.shadow.real, p_.shadow.program(), *known.mesh))
    return Reason::program;
  if (isFarAway(*known.mesh)) return Reason::farAway;
  if (!known.mesh->moderate) return Reason::notFinite;
  if (offsetsProgramDepth(p_.shadow, known.mesh->shape)) return Reason::program;
  const ProgramState& program = p_.shadow.program();
  if (showsOpacityBeneath(program, *known.mesh, program.color) ||
      hasOtherValues(program, *known.mesh, p_.shadow.settings) || movesHighlights(*known.mesh))
    return Reason::programValue;
  if (p_.shadow.attributes().instanceTransform.empty()) {  // otherwise classifyInstances() checks each
    const glm::ivec4& viewport = p_.shadow.viewport().box;
    const glm::ivec2 size(viewport.z, viewport.w);
    if (RayPrecision::isFarFromOrigin(*known.mesh, program.clipFromObject, size))
      return Reason::farFromOrigin;
    if (p_.surfaces.precision.isTooLarge(*known.mesh, program.clipFromObject, size)) return Reason::tooLarge;
  }
  const bool solid = scene::isSolid(known.mesh->shape);
  if (solid && isParallel(program.clipFromObject) && isFlat(*known.mesh, program.clipFromObject))
    return Reason::flat;
  if (!solid && layersOf(program) == BatchKey::Layers::none && isOneOfPasses(*known.mesh))
    return Reason::passes;
  const uint64_t triangles = known.mesh->triangleCount;
  if (program.triangleColors && program.triangleOffset + triangles > program.triangleColorCount)
    return Reason::arrayState;
  if (program.triangleEdges && program.triangleOffset + triangles > program.triangleEdgeCount)
    return Reason::arrayState;
  if (program.triangleNormals && program.triangleOffset + triangles > program.triangleNormalCount)
    return Reason::arrayState;
  // The part by which triangles grow has another depth slope than the triangle.
  if (offsetOf(p_.shadow, known.mesh->shape).factor != 0 && program.shading.fragment.edges &&
      program.shading.fragment.edgesGrow)
    return Reason::program;
  if (layersOf(program) != BatchKey::Layers::none) return Reason::traced;
  return ofBlending(*known.mesh);
}

bool ProgramDraws::isOneOfPasses(const scene::Mesh& mesh) const {
  return p_.surfaces.passes.several(mesh.geometryId) ||
         p_.surfaces.passes.meetsRasterised(depthPlaceOf(p_.shadow), mesh, p_.shadow.program().clipFromObject,
                                            offsetOf(p_.shadow, mesh.shape).pushesBack());
}

/// Prepares batch, camera and `modelview` for the current shader program's instance. Returns Placed::nowhere
/// if it covers no pixel.
ProgramDraws::Placed ProgramDraws::preparePlace(const scene::Mesh& mesh, const glm::dvec3& reach,
                                                glm::dmat4& modelview) {
  const scene::Shape shape = mesh.shape;
  const ProgramState& program = p_.shadow.program();
  const glm::dmat4 projection = program.eyeFromObject
                                    ? program.clipFromObject * glm::inverse(*program.eyeFromObject)
                                    : program.clipFromObject;
  BatchKey key = Batch::keyOf(p_.shadow.pixelState(), projection);
  key.layers = layersOf(program);
  const bool blended = isBlended(mesh);
  if (blended) p_.layers.drawn.describe(key, BatchKey::DrawnBy::arrays);
  const bool peeled = key.layers == BatchKey::Layers::peeled;
  key.offset = peeled ? scene::PolygonOffset{} : offsetOf(p_.shadow, shape);
  if (program.window) key.region = common(key.region, *program.window);
  p_.filler.clampToTarget(key.region);
  if (key.region.width <= 0 || key.region.height <= 0) return Placed::nowhere;
  const BatchKey* there = !p_.pending.batch.empty() ? &p_.pending.batch.key()
                          : peeled                  ? p_.layers.held.tracedKey()
                                                    : nullptr;
  modelview = p_.filler.factor(program.clipFromObject, reach, there, key, !peeled);
  if (key.layers != BatchKey::Layers::none && !blended)
    return p_.layers.start(key, modelview) ? Placed::inBatch : Placed::otherCamera;
  p_.filler.open(key, modelview);
  return Placed::inBatch;
}

std::vector<std::vector<Triangle>> ProgramDraws::sampleArrays(GLenum mode, const Elements& elements) const {
  std::vector<std::vector<Triangle>> samples;
  const auto sample = [&](const ArraySource& source) {
    if (!source.enabled || !source.buffer || source.divisor != 0 || source.size < 3 || !isReadable(source))
      return;
    ArrayState positions;
    positions.vertex = source;
    positions.elements = p_.shadow.vertices().elements;
    samples.push_back(sampleTriangles(p_.shadow.real, positions, mode, elements));
  };
  sample(p_.shadow.vertices().vertex);
  for (const ArraySource& source : p_.shadow.attributes().generic) sample(source);
  return samples;
}

void ProgramDraws::meetPasses(PrimitiveClass kind, GLenum mode, const Elements& elements) {
  if (mode < GL_TRIANGLES || mode > GL_POLYGON || !p_.classifier.meetsDepth(kind)) return;
  const uint64_t count = countTriangles(mode, static_cast<uint64_t>(elements.count));
  const bool meets = p_.surfaces.passes.anyByProgram(p_.shadow.target().framebuffer, count),
             leaves = integer(p_.shadow.real, GL_DEPTH_WRITEMASK) != 0;
  if (!(meets || leaves) || haveUnreadableBuffers(p_.shadow.attributes())) return;
  const ProgramState& program = p_.shadow.program();
  const bool placed = program.known && program.known->family && program.reason == Reason::traced;
  const bool pushedBack = offsetOf(p_.shadow, p_.shadow.attributes().shape).pushesBack();
  if (meets) p_.flusher.settleBelow(p_.shadow.target().samples);
  const glm::dmat4* matrix = placed ? &program.clipFromObject : nullptr;
  for (std::vector<Triangle>& samples : sampleArrays(mode, elements)) {
    if (meets)
      p_.raster.rasteriseMet(
          p_.surfaces.passes.meetsProgram(depthPlaceOf(p_.shadow), samples, count, matrix, pushedBack));
    if (leaves)
      p_.surfaces.passes.rasterisedByProgram(depthPlaceOf(p_.shadow), count, std::move(samples), matrix,
                                             pushedBack);
  }
}

namespace {

scene::CullFace withBackCulled(scene::CullFace cull) {
  using Cull = scene::CullFace;
  return cull == Cull::front || cull == Cull::both ? Cull::both : Cull::back;
}

/// The instance of the mesh, with the state of the shader program in use.
scene::Instance instanceOf(const scene::MeshPtr& mesh, const glm::dmat4& modelview, ShadowState& shadow) {
  const ProgramState& program = shadow.program();
  scene::Instance instance;
  instance.mesh = mesh;
  instance.eyeFromObject = modelview;
  instance.lightingFromObject = glm::mat4(program.eyeFromObject.value_or(glm::dmat4(1)));
  instance.normalMatrix = program.normalMatrix;
  instance.color = program.color;
  instance.normal = program.normal;
  instance.texcoord = program.texcoord;
  if (program.texcoordAbove != glm::vec4(0, 0, 0, 1)) instance.texcoordsAbove = {program.texcoordAbove};
  if (program.tangent != glm::vec3(0)) {
    instance.texcoordsAbove.resize(scene::PbrSurface::kTangentUnit, glm::vec4(0, 0, 0, 1));
    instance.texcoordsAbove.back() = glm::vec4(program.tangent, 1);
  }
  instance.triangleColors = program.triangleColors;
  instance.triangleNormals = program.triangleNormals;
  instance.triangleEdges = program.triangleEdges;
  instance.triangleOffset = program.triangleOffset;
  instance.materials.push_back(program.material);
  instance.impostors = program.impostors;
  if (mesh->shape == scene::Shape::triangles)  // points have no faces
    instance.cull = program.hidesBackFaces ? withBackCulled(shadow.raster().cull) : shadow.raster().cull;
  if (scene::isSolid(mesh->shape)) makeProgramSolid(shadow, instance);
  instance.frontFaceCcw = shadow.raster().frontFaceCcw;
  const glm::dmat4 objectFromEye = glm::inverse(modelview);
  if (!scene::isSolid(mesh->shape))
    for (const glm::dvec4& plane : program.clipPlanes) instance.clipPlanes.push_back(plane * objectFromEye);
  return instance;
}

}  // namespace

Reason ProgramDraws::add(const scene::MeshPtr& mesh, GLenum mode, const Elements& elements) {
  const bool many =
      !p_.shadow.attributes().instanceTransform.empty() || p_.shadow.attributes().instanceColor.enabled;
  const glm::dvec3 reach = many ? reachOfInstances(*mesh, elements) : reachOf(*mesh);
  if (mesh->triangleCount == 0) return Reason::traced;
  glm::dmat4 modelview(1);
  if (const Placed placed = preparePlace(*mesh, reach, modelview); placed != Placed::inBatch)
    return placed == Placed::nowhere ? Reason::traced : Reason::programPass;
  const ProgramState& program = p_.shadow.program();
  scene::Instance instance = instanceOf(mesh, modelview, p_.shadow);
  ProgramDraw kept = captureProgramDraw(p_.shadow.real, program.known->program, program.uniforms,
                                        p_.shadow.attributes(), mode, elements);
  if (many) {
    addInstancesOf(instance, program.shading, elements);
  } else {
    p_.pending.batch.add(std::move(instance), program.shading);
  }
  p_.pending.batch.keep(std::move(kept));
  const BatchKey& key = p_.pending.batch.key();
  const bool tests = key.layers == BatchKey::Layers::none || key.layers == BatchKey::Layers::drawn,
             leaves = key.layers == BatchKey::Layers::none || key.blending.writesDepth;
  if (!many && tests && mesh->shape == scene::Shape::triangles)
    p_.filler.reportDrawnByProgram(mesh, modelview, program.clipFromObject, leaves);
  p_.filler.settleFailure();
  return Reason::traced;
}

}  // namespace gluray::gl
