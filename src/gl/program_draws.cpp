// Surfaces that shader programs draw: whether they can be traced, and how they join the batch.
#include "gl/affine.h"
#include "gl/context.h"
#include "gl/mesh_builder.h"
#include "gl/pixel_figures.h"

#include <algorithm>

namespace gluray::gl {

void Context::readCurrentProgram() {
  ProgramState& program = state.program;
  const GLuint name = isPresent(real.UseProgram) ? [&] {
    GLint current = 0;
    real.GetIntegerv(GL_CURRENT_PROGRAM, &current);
    return static_cast<GLuint>(current);
  }() : 0;
  const auto before = program.known;
  program.known = name ? group_->program(real, name, families()) : nullptr;
  if (program.known != before) dirty |= kAttributes;
  if (!program.known) {
    program.reason = Reason::program;
    return;
  }
  readProgram(real, *group_, state.rare, textures_, program);
  // A program that was deleted lives as long as it is in use: the write-back, which uses its own, would end
  // it.
  GLint deleted = 0;
  real.GetProgramiv(name, GL_DELETE_STATUS, &deleted);
  if (deleted) program.reason = Reason::program;
}

const FamilyList& Context::families() const { return info_.families ? *info_.families : builtInFamilies(); }

const std::shared_ptr<const KnownProgram>& Context::programInUse() {
  refresh(kProgram);
  return state.program.known;
}

bool Context::drawsFigures(GLenum mode) {
  if ((mode != GL_POINTS && mode != GL_LINES) || !isPresent(real.UseProgram)) return false;
  GLint name = 0;
  real.GetIntegerv(GL_CURRENT_PROGRAM, &name);
  if (name == 0) return false;
  const auto known = group_->program(real, static_cast<GLuint>(name), families());
  if (!known || !known->family || !known->family->figures.given()) return false;
  return (mode == GL_LINES) == (known->family->figures.shape == scene::Shape::tubes);
}

Reason Context::triageFigures() {
  attributes.figureRadius = state.program.figureRadius;
  if (attributes.shape == scene::Shape::triangles) return Reason::traced;
  // Cards have two sides, of which one may be culled. Points have none.
  if (attributes.shape != scene::Shape::beads && state.raster.cull != scene::CullFace::none)
    return Reason::program;
  if (scene::isSizedInPixels(attributes.shape))
    return readPixelFigures(real, info_.core, attributes.shape, state);
  return Reason::traced;
}

Reason Context::triageProgram(PrimitiveClass kind) {
  if (aside_) return Reason::failure;
  if (passthrough_) return Reason::off;
  if (activeQueries > 0) return Reason::query;
  if (state.target.reason != Reason::traced) return state.target.reason;
  if (state.raster.reason == Reason::renderMode) return Reason::renderMode;
  // What keeps the program from being traced says more than what kind of primitive it draws.
  if (state.program.reason != Reason::traced) return state.program.reason;
  if (kind == PrimitiveClass::points) return Reason::points;
  if (kind == PrimitiveClass::lines) return Reason::lines;
  if (state.raster.reason != Reason::traced) return state.raster.reason;
  if (state.raster.alphaTest != scene::AlphaTest{}) return Reason::alphaTest;
  if (state.program.known->program.blocks) dirty |= kProgram;  // buffers change without our taking note
  if (!info_.core && !state.clipPlanes.empty()) return Reason::program;  // programs clip in ways of their own
  if (attributes.reason != Reason::traced) return attributes.reason;
  return canTrace() ? Reason::traced : Reason::noGlsl;
}

namespace {

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

/// Whether all of the mesh's bounds have positive w.
bool isBeforeViewer(const scene::Mesh& mesh, const glm::dmat4& clipFromObject) {
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec4 p(mesh.lower, 1);
    for (int c = 0; c < 3; ++c)
      if (corner >> c & 1) p[c] = mesh.upper[c];
    if (!((clipFromObject * p).w > 0)) return false;
  }
  return true;
}

}  // namespace

Reason Context::triageProgram(const KnownMesh& known) const {
  const Reason reason = triageProgramAlways(known);
  if (layersOf(state.program) == BatchKey::Layers::peeled) return reason;
  // One by one, however much they are in all: a surface that is drawn again is drawn in the same way.
  const bool leave = reason == Reason::traced && leavesAlone(known.mesh->triangleCount);
  return leave ? Reason::smallScene : reason;
}

Reason Context::triageProgramAlways(const KnownMesh& known) const {
  if (known.homogeneous || !known.mesh) return Reason::homogeneous;
  if (isFarAway(*known.mesh)) return Reason::farAway;
  const ProgramState& program = state.program;
  const uint64_t triangles = known.mesh->triangleCount;
  if (program.triangleColors && program.triangleOffset + triangles > program.triangleColorCount)
    return Reason::arrayState;
  if (program.triangleEdges && program.triangleOffset + triangles > program.triangleEdgeCount)
    return Reason::arrayState;
  if (program.triangleNormals && program.triangleOffset + triangles > program.triangleNormalCount)
    return Reason::arrayState;
  // Triangles that grow by their edges do so in the window: near the viewer's plane by any number of pixels.
  // The slope of what they grow to is not that of the triangle.
  if (program.triangleEdges &&
      (program.depthOffset.factor != 0 || !isBeforeViewer(*known.mesh, program.clipFromObject)))
    return Reason::program;
  const bool opaque = layersOf(state.program) != BatchKey::Layers::none || gl::isOpaque(program, *known.mesh);
  if (opaque) return Reason::traced;
  if (state.raster.unlessOpaque != Reason::traced) return state.raster.unlessOpaque;
  return Reason::traced;
}

/// Makes the state ready for an instance of the current program: batch, camera and matrix. Nowhere: nothing
/// could be seen of it.
Context::Placed Context::placeProgramDraw(const glm::dvec3& reach) {
  const ProgramState& program = state.program;
  // One projection serves a batch. What programs give is a product, and taken apart it differs by roundings
  // from draw to draw; so each draw is placed by what it does to points in the end.
  state.projection = program.eyeFromObject ? program.clipFromObject * glm::inverse(*program.eyeFromObject)
                                           : program.clipFromObject;
  BatchKey key = Batch::keyOf(state);
  key.layers = layersOf(state.program);
  const bool peeled = key.layers == BatchKey::Layers::peeled;
  key.offset = peeled ? scene::PolygonOffset{} : program.depthOffset;
  clampToTarget(key.region);
  dirty |= kModelview | kProjection;  // of fixed function
  if (key.region.width <= 0 || key.region.height <= 0) return Placed::nowhere;
  const BatchKey* there = !batch_.empty() ? &batch_.key() : peeled ? layers.tracedKey() : nullptr;
  if (there) {
    const glm::dmat4 placed = glm::inverse(there->projection) * program.clipFromObject;
    if (isAffine(placed, reach)) key.projection = there->projection;
    if (!peeled && !(*there == key)) flush();
  }
  state.projection = key.projection;
  state.modelview = glm::inverse(state.projection) * program.clipFromObject;
  state.modelview /= state.modelview[3][3];  // the same points
  for (int c = 0; c < 4; ++c) state.modelview[c][3] = c == 3 ? 1.0 : 0.0;
  if (key.layers != BatchKey::Layers::none) return layers.start(key) ? Placed::inBatch : Placed::otherCamera;
  if (batch_.empty()) {
    settleBelow(key.samples);
    batch_.start(key, state, info_.settings, frame);
  }
  return Placed::inBatch;
}

Reason Context::addProgramInstances(const scene::MeshPtr& mesh, GLenum mode, const Elements& elements) {
  const bool many = !attributes.instanceTransform.empty() || attributes.instanceColor.enabled;
  const glm::dvec3 reach = many ? reachOfInstances(*mesh, elements) : reachOf(*mesh);
  if (mesh->triangleCount == 0) return Reason::traced;
  if (const Placed placed = placeProgramDraw(reach); placed != Placed::inBatch)
    return placed == Placed::nowhere ? Reason::traced : Reason::programPass;
  const ProgramState& program = state.program;
  scene::Instance instance;
  instance.mesh = mesh;
  instance.eyeFromObject = state.modelview;
  instance.lightingFromObject = glm::mat4(program.eyeFromObject.value_or(glm::dmat4(1)));
  instance.normalMatrix = program.normalMatrix;
  instance.color = program.color;
  instance.normal = program.normal;
  instance.texcoord = program.texcoord;
  instance.triangleColors = program.triangleColors;
  instance.triangleNormals = program.triangleNormals;
  instance.triangleEdges = program.triangleEdges;
  instance.triangleOffset = program.triangleOffset;
  instance.materials.push_back(program.material);
  instance.figures = program.figures;
  if (mesh->shape == scene::Shape::triangles) instance.cull = state.raster.cull;  // points have no faces
  instance.frontFaceCcw = state.raster.frontFaceCcw;
  const glm::dmat4 objectFromEye = glm::inverse(state.modelview);
  for (const glm::dvec4& plane : program.clipPlanes) instance.clipPlanes.push_back(plane * objectFromEye);
  ProgramDraw kept =
      captureProgramDraw(real, program.known->program, program.uniforms, attributes, mode, elements);
  if (many) {
    addInstancesOf(instance, program.shading, elements);
  } else {
    batch_.add(std::move(instance), program.shading);
    if (batch_.key().layers == BatchKey::Layers::none && mesh->shape == scene::Shape::triangles)
      passes_.drawn(mesh, state.modelview, Passes::How::pending, isPushedBack());
  }
  batch_.keep(std::move(kept));
  if (aside_) flush();  // the flush above failed: later draws are rasterised and must find this one drawn
  return Reason::traced;
}

}  // namespace gluray::gl
