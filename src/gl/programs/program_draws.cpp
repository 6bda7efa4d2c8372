#include "gl/programs/program_draws.h"

#include "gl/arrays/array_indices.h"
#include "gl/capture/mesh_builder.h"
#include "gl/context.h"
#include "gl/draws/affine.h"
#include "gl/programs/pixel_impostors.h"
#include "gl/state/state_queries.h"

#include <algorithm>

namespace gluray::gl {

void ProgramDraws::read() {
  ProgramState& program = c_.state.program;
  const GLuint name = isPresent(c_.real.UseProgram) ? [&] {
    GLint current = 0;
    c_.real.GetIntegerv(GL_CURRENT_PROGRAM, &current);
    return static_cast<GLuint>(current);
  }() : 0;
  const auto before = program.known;
  program.known = name ? known(name) : nullptr;
  if (program.known != before) c_.dirty |= kAttributes;
  if (!program.known) {
    program.reason = Reason::program;
    return;
  }
  readProgram(c_.real, c_.group(), c_.state.rare, c_.textures(), program);
  // A program that was deleted lives as long as it is in use: the write-back, which uses its own, would end
  // it.
  GLint deleted = 0;
  c_.real.GetProgramiv(name, GL_DELETE_STATUS, &deleted);
  if (deleted) program.reason = Reason::program;
}

std::shared_ptr<const KnownProgram> ProgramDraws::known(GLuint name) {
  return c_.group().program(c_.real, name, c_.info().families ? *c_.info().families : builtInFamilies());
}

const std::shared_ptr<const KnownProgram>& ProgramDraws::inUse() {
  c_.refresh(kProgram);
  return c_.state.program.known;
}

bool ProgramDraws::drawsFigures(GLenum mode) {
  if ((mode != GL_POINTS && mode != GL_LINES) || !isPresent(c_.real.UseProgram)) return false;
  GLint name = 0;
  c_.real.GetIntegerv(GL_CURRENT_PROGRAM, &name);
  if (name == 0) return false;
  const auto program = known(static_cast<GLuint>(name));
  if (!program || !program->family || !program->family->figures.given()) return false;
  return (mode == GL_LINES) == (program->family->figures.shape == scene::Shape::tubes);
}

Reason ProgramDraws::triageFigures() {
  c_.attributes.figureRadius = c_.state.program.figureRadius;
  if (c_.attributes.shape == scene::Shape::triangles) return Reason::traced;
  // Cards have two sides, of which one may be culled. Points have none.
  if (c_.attributes.shape != scene::Shape::beads && c_.state.raster.cull != scene::CullFace::none)
    return Reason::program;
  if (scene::isInWindow(c_.attributes.shape))
    return readPixelFigures(c_.real, c_.info().core, c_.attributes.shape, c_.state);
  return Reason::traced;
}

Reason ProgramDraws::triage(PrimitiveClass kind) {
  if (c_.aside()) return Reason::failure;
  if (c_.passthrough()) return Reason::off;
  if (c_.activeQueries > 0) return Reason::query;
  if (c_.state.target.reason != Reason::traced) return c_.state.target.reason;
  if (c_.state.raster.reason == Reason::renderMode) return Reason::renderMode;
  // What keeps the program from being traced says more than what kind of primitive it draws.
  if (c_.state.program.reason != Reason::traced) return c_.state.program.reason;
  if (kind == PrimitiveClass::points) return Reason::points;
  if (kind == PrimitiveClass::lines) return Reason::lines;
  if (c_.state.raster.reason != Reason::traced) return c_.state.raster.reason;
  if (c_.state.raster.alphaTest != scene::AlphaTest{}) return Reason::alphaTest;
  if (c_.state.program.known->program.blocks) c_.dirty |= kProgram;  // buffers change without our taking note
  if (!c_.info().core && !c_.state.clipPlanes.empty())
    return Reason::program;  // programs clip in ways of their own
  if (c_.attributes.reason != Reason::traced) return c_.attributes.reason;
  return c_.canTrace() ? Reason::traced : Reason::noGlsl;
}

namespace {

/// What is added to the depths of what the program draws: by itself, or by OpenGL where it does not write
/// them.
scene::PolygonOffset offsetOf(const State& state, scene::Shape shape) {
  const ProgramState& program = state.program;
  if (program.depthOffset != scene::PolygonOffset{}) return program.depthOffset;
  return shape == scene::Shape::triangles ? Batch::keyOf(state).offset : scene::PolygonOffset{};
}

/// Whether OpenGL adds an offset where the program has the last word about depth.
bool offsetsProgramDepth(const State& state, scene::Shape shape) {
  const RasterState& raster = state.raster;
  if (!raster.offsetFill || (raster.offsetFactor == 0 && raster.offsetUnits == 0)) return false;
  return shape == scene::Shape::triangles &&
         (state.program.shading.fragment.writesDepth || layersOf(state.program) != BatchKey::Layers::none);
}

/// Whether some buffer of the arrays may not be asked for.
bool haveUnreadableBuffers(const ArrayState& arrays) {
  return arrays.reason == Reason::deletedBuffer || arrays.reason == Reason::foreignBuffer ||
         arrays.reason == Reason::persistentMapping;
}

bool isOpaque(const ProgramState& program, const scene::Mesh& mesh) {
  using Color = scene::FragmentShading::Color;
  const scene::FragmentShading& f = program.shading.fragment;
  if (program.material.front.diffuse.a < 1) return false;
  if (f.backMaterial && program.material.back.diffuse.a < 1) return false;
  if (program.overridden && !(mesh.colors ? mesh.opaqueColors : program.color.a >= 1)) return false;
  if (f.color == Color::vertices && !program.instanceColors &&
      !(mesh.colors ? mesh.opaqueColors : program.color.a >= 1))
    return false;
  if (f.color == Color::map && !f.map.front().image->opaque) return false;
  if (f.color == Color::perTriangle && !program.opaqueTriangleColors) return false;
  return std::all_of(program.shading.textures.begin(), program.shading.textures.end(),
                     [](const scene::Texture& t) { return t.image->opaque; });
}

}  // namespace

Reason ProgramDraws::triage(const KnownMesh& known) const {
  Reason reason = triageAlways(known);
  const ProgramState& program = c_.state.program;
  if (layersOf(program) == BatchKey::Layers::peeled) return reason;
  const bool single = reason == Reason::traced && layersOf(program) == BatchKey::Layers::none &&
                      c_.attributes.instanceTransform.empty();
  if (single && c_.sheets.meets(known.mesh,
                                c_.sheetPlace(program.clipFromObject, offsetOf(c_.state, known.mesh->shape))))
    reason = Reason::coincident;
  // One by one, however much they are in all: a surface that is drawn again is drawn in the same way.
  const bool leave = reason == Reason::traced && c_.leavesAlone(known.mesh->triangleCount);
  return leave ? Reason::smallScene : reason;
}

Reason ProgramDraws::triageAlways(const KnownMesh& known) const {
  if (known.homogeneous || !known.mesh) return Reason::homogeneous;
  if (isFarAway(*known.mesh)) return Reason::farAway;
  if (offsetsProgramDepth(c_.state, known.mesh->shape)) return Reason::program;
  const ProgramState& program = c_.state.program;
  const glm::ivec4& viewport = c_.state.viewport;
  if (c_.attributes.instanceTransform.empty() &&
      c_.precision.isTooLarge(*known.mesh, program.clipFromObject, {viewport.z, viewport.w}))
    return Reason::tooLarge;
  if (layersOf(program) == BatchKey::Layers::none && isOneOfPasses(*known.mesh)) return Reason::passes;
  const uint64_t triangles = known.mesh->triangleCount;
  if (program.triangleColors && program.triangleOffset + triangles > program.triangleColorCount)
    return Reason::arrayState;
  if (program.triangleEdges && program.triangleOffset + triangles > program.triangleEdgeCount)
    return Reason::arrayState;
  if (program.triangleNormals && program.triangleOffset + triangles > program.triangleNormalCount)
    return Reason::arrayState;
  // Triangles that grow by their edges do so in the window: near the viewer's plane by any number of pixels.
  // The slope of what they grow to is not that of the triangle. Distances to edges with a corner behind the
  // viewer are no distances.
  const bool tilted = offsetOf(c_.state, known.mesh->shape).factor != 0 && program.shading.fragment.edgesGrow;
  if (program.triangleEdges && (tilted || !isBeforeViewer(*known.mesh, program.clipFromObject)))
    return Reason::program;
  const bool opaque =
      layersOf(c_.state.program) != BatchKey::Layers::none || gl::isOpaque(program, *known.mesh);
  if (opaque) return Reason::traced;
  if (c_.state.raster.unlessOpaque != Reason::traced) return c_.state.raster.unlessOpaque;
  return Reason::traced;
}

bool ProgramDraws::isOneOfPasses(const scene::Mesh& mesh) const {
  return c_.passes.several(mesh.geometryId) ||
         c_.passes.meetsRasterised(c_.state.target.framebuffer, mesh, c_.state.program.clipFromObject,
                                   offsetOf(c_.state, mesh.shape).pushesBack());
}

/// Makes the state ready for an instance of the current program: batch, camera and matrix. Nowhere: nothing
/// could be seen of it.
ProgramDraws::Placed ProgramDraws::place(scene::Shape shape, const glm::dvec3& reach) {
  const ProgramState& program = c_.state.program;
  // One projection serves a batch. What programs give is a product, and taken apart it differs by roundings
  // from draw to draw; so each draw is placed by what it does to points in the end.
  c_.state.projection = program.eyeFromObject ? program.clipFromObject * glm::inverse(*program.eyeFromObject)
                                              : program.clipFromObject;
  BatchKey key = Batch::keyOf(c_.state);
  key.layers = layersOf(c_.state.program);
  const bool peeled = key.layers == BatchKey::Layers::peeled;
  key.offset = peeled ? scene::PolygonOffset{} : offsetOf(c_.state, shape);
  c_.clampToTarget(key.region);
  c_.dirty |= kModelview | kProjection;  // of fixed function
  if (key.region.width <= 0 || key.region.height <= 0) return Placed::nowhere;
  const BatchKey* there = !c_.batch().empty() ? &c_.batch().key() : peeled ? c_.layers.tracedKey() : nullptr;
  if (there) {
    const glm::dmat4 placed = glm::inverse(there->projection) * program.clipFromObject;
    if (isAffine(placed, reach)) key.projection = there->projection;
    if (!peeled && !(*there == key)) c_.flush();
  }
  c_.state.projection = key.projection;
  c_.state.modelview = glm::inverse(c_.state.projection) * program.clipFromObject;
  c_.state.modelview /= c_.state.modelview[3][3];  // the same points
  for (int c = 0; c < 4; ++c) c_.state.modelview[c][3] = c == 3 ? 1.0 : 0.0;
  if (key.layers != BatchKey::Layers::none)
    return c_.layers.start(key) ? Placed::inBatch : Placed::otherCamera;
  if (c_.batch().empty()) {
    c_.settleBelow(key.samples);
    c_.batch().start(key, c_.state, c_.settings(), c_.frame);
  }
  return Placed::inBatch;
}

std::vector<std::vector<Triangle>> ProgramDraws::sampleArrays(GLenum mode, const Elements& elements) const {
  std::vector<std::vector<Triangle>> samples;
  const auto sample = [&](const ArraySource& source) {
    if (!source.enabled || !source.buffer || source.divisor != 0 || source.size < 3 || !isReadable(source))
      return;
    ArrayState positions;
    positions.vertex = source;
    positions.elements = c_.attributes.elements;
    samples.push_back(sampleTriangles(c_.real, positions, mode, elements));
  };
  sample(c_.attributes.vertex);
  for (const ArraySource& source : c_.attributes.generic) sample(source);
  return samples;
}

void ProgramDraws::meetPasses(PrimitiveClass kind, GLenum mode, const Elements& elements) {
  if (mode < GL_TRIANGLES || mode > GL_POLYGON || !c_.meetsDepth(kind)) return;
  const uint32_t framebuffer = c_.state.target.framebuffer;
  const uint64_t count = countTriangles(mode, static_cast<uint64_t>(elements.count));
  const bool meets = c_.passes.anyByProgram(framebuffer, count),
             leaves = integer(c_.real, GL_DEPTH_WRITEMASK) != 0;
  if (!(meets || leaves) || haveUnreadableBuffers(c_.attributes)) return;
  const ProgramState& program = c_.state.program;
  const bool placed = program.known && program.known->family && program.reason == Reason::traced;
  const bool pushedBack = offsetOf(c_.state, c_.attributes.shape).pushesBack();
  if (meets) c_.settleBelow(c_.state.target.samples);
  const glm::dmat4* matrix = placed ? &program.clipFromObject : nullptr;
  for (std::vector<Triangle>& samples : sampleArrays(mode, elements)) {
    if (meets) c_.rasteriseMet(c_.passes.meetsProgram(framebuffer, samples, count, matrix, pushedBack));
    if (leaves) c_.passes.rasterisedByProgram(framebuffer, count, std::move(samples), matrix, pushedBack);
  }
}

Reason ProgramDraws::add(const scene::MeshPtr& mesh, GLenum mode, const Elements& elements) {
  const bool many = !c_.attributes.instanceTransform.empty() || c_.attributes.instanceColor.enabled;
  const glm::dvec3 reach = many ? reachOfInstances(*mesh, elements) : reachOf(*mesh);
  if (mesh->triangleCount == 0) return Reason::traced;
  if (const Placed placed = place(mesh->shape, reach); placed != Placed::inBatch)
    return placed == Placed::nowhere ? Reason::traced : Reason::programPass;
  const ProgramState& program = c_.state.program;
  scene::Instance instance;
  instance.mesh = mesh;
  instance.eyeFromObject = c_.state.modelview;
  instance.lightingFromObject = glm::mat4(program.eyeFromObject.value_or(glm::dmat4(1)));
  instance.normalMatrix = program.normalMatrix;
  instance.color = program.color;
  instance.normal = program.normal;
  instance.texcoord = program.texcoord;
  if (program.texcoordAbove != glm::vec4(0, 0, 0, 1)) instance.texcoordsAbove = {program.texcoordAbove};
  instance.triangleColors = program.triangleColors;
  instance.triangleNormals = program.triangleNormals;
  instance.triangleEdges = program.triangleEdges;
  instance.triangleOffset = program.triangleOffset;
  instance.materials.push_back(program.material);
  instance.figures = program.figures;
  if (mesh->shape == scene::Shape::triangles) instance.cull = c_.state.raster.cull;  // points have no faces
  instance.frontFaceCcw = c_.state.raster.frontFaceCcw;
  const glm::dmat4 objectFromEye = glm::inverse(c_.state.modelview);
  for (const glm::dvec4& plane : program.clipPlanes) instance.clipPlanes.push_back(plane * objectFromEye);
  ProgramDraw kept =
      captureProgramDraw(c_.real, program.known->program, program.uniforms, c_.attributes, mode, elements);
  if (many) {
    addInstancesOf(instance, program.shading, elements);
  } else {
    c_.batch().add(std::move(instance), program.shading);
    if (c_.batch().key().layers == BatchKey::Layers::none && mesh->shape == scene::Shape::triangles)
      c_.passes.drawnByProgram(mesh, c_.state.modelview, program.clipFromObject, c_.state.target.framebuffer,
                               c_.batch().key().offset.pushesBack());
  }
  c_.batch().keep(std::move(kept));
  if (c_.aside())
    c_.flush();  // the flush above failed: later draws are rasterised and must find this one drawn
  return Reason::traced;
}

}  // namespace gluray::gl
