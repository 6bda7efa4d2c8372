#include "intercept/present/raster/raster_fallback.h"

#include "gl/real/clip_depths.h"
#include "intercept/present/raster/fixed_function.h"
#include "intercept/present/raster/program_replay.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace gluray::present {
namespace {

/// Saves and restores the matrices that drawing changes; by value, as the program may have filled a stack.
class KeptMatrices {
 public:
  explicit KeptMatrices(const gl::RealGl& real) : real_(real) {
    for (int i = 0; i < kCount; ++i) real_.GetDoublev(kNames[i], values_[i]);
  }
  ~KeptMatrices() {
    for (int i = 0; i < kCount; ++i) {
      real_.MatrixMode(kModes[i]);
      real_.LoadMatrixd(values_[i]);
    }
  }
  KeptMatrices(const KeptMatrices&) = delete;
  KeptMatrices& operator=(const KeptMatrices&) = delete;

 private:
  static constexpr int kCount = 3;  // the last is that of the active texture unit
  static constexpr GLenum kNames[] = {GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX, GL_TEXTURE_MATRIX};
  static constexpr GLenum kModes[] = {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE};
  const gl::RealGl& real_;
  GLdouble values_[kCount][16];
};

bool isByProgram(const scene::Snapshot& snapshot, const scene::Instance& instance) {
  return snapshot.shadings[instance.shading].fragment.model != scene::FragmentShading::Model::off;
}

bool attribStackHasRoom(const gl::RealGl& real) {
  GLint depth = 0, limit = 0;
  real.GetIntegerv(GL_ATTRIB_STACK_DEPTH, &depth);
  real.GetIntegerv(GL_MAX_ATTRIB_STACK_DEPTH, &limit);
  return depth < limit;
}

void setUpCamera(const gl::RealGl& real, const scene::Snapshot& snapshot) {
  real.MatrixMode(GL_PROJECTION);
  const scene::Camera& camera = snapshot.camera;
  const glm::dmat4 projection =
      camera.depthsFromZero ? gl::toDepthsFromZero(camera.clipFromEye) : camera.clipFromEye;
  real.LoadMatrixd(glm::value_ptr(projection));
  if (snapshot.polygonOffset.factor != 0 || snapshot.polygonOffset.units != 0) {
    real.Enable(GL_POLYGON_OFFSET_FILL);
    real.PolygonOffset(snapshot.polygonOffset.factor, snapshot.polygonOffset.units);
  } else {
    real.Disable(GL_POLYGON_OFFSET_FILL);
  }
}

/// Sets the blending of layers that are blended in the order of drawing.
void setBlending(const gl::RealGl& real, const scene::Blending& blending) {
  const auto name = [](auto value) { return static_cast<GLenum>(value); };
  const auto &rgb = blending.rgb, &alpha = blending.alpha;
  real.Enable(GL_BLEND);
  real.BlendEquationSeparate(name(rgb.equation), name(alpha.equation));
  real.BlendFuncSeparate(name(rgb.source), name(rgb.destination), name(alpha.source),
                         name(alpha.destination));
  if (gl::isPresent(real.BlendColor))
    real.BlendColor(blending.constant.r, blending.constant.g, blending.constant.b, blending.constant.a);
  real.DepthMask(blending.writesDepth);
}

void sendVertex(const gl::RealGl& real, const scene::Instance& instance, uint32_t vertex,
                uint32_t& material) {
  const scene::Mesh& mesh = *instance.mesh;
  if (mesh.materials) {
    const std::byte* at = mesh.materials.data + static_cast<size_t>(vertex) * mesh.materials.stride;
    const uint32_t wanted = *reinterpret_cast<const uint32_t*>(at);
    if (wanted != material && wanted < instance.materials.size())
      setMaterials(real, instance.materials[material = wanted]);
  }
  if (mesh.normals) real.Normal3fv(glm::value_ptr(scene::fetch(mesh.normals, vertex)));
  if (mesh.colors) real.Color4fv(glm::value_ptr(scene::fetch(mesh.colors, vertex)));
  if (mesh.secondaryColors)
    real.SecondaryColor3fv(glm::value_ptr(scene::fetch(mesh.secondaryColors, vertex)));
  if (mesh.fogCoords) real.FogCoordfv(glm::value_ptr(scene::fetch(mesh.fogCoords, vertex)));
  if (mesh.texcoords) real.TexCoord4fv(glm::value_ptr(scene::fetch(mesh.texcoords, vertex)));
  for (uint32_t unit = 1; unit <= mesh.texcoordsAbove.size(); ++unit)
    if (const scene::Attribute* texcoords = mesh.texcoordsOf(unit))
      real.MultiTexCoord4fv(GL_TEXTURE0 + unit, glm::value_ptr(scene::fetch(*texcoords, vertex)));
  real.Vertex3fv(glm::value_ptr(mesh.position(vertex)));
}

/// Lines and points as the program sent them, of the size of their tubes and spheres.
void setSolidState(const gl::RealGl& real, const scene::Instance& instance, const scene::Camera& camera) {
  const float pixels = instance.impostors.size.x * 0.5f * static_cast<float>(camera.viewport.z);
  real.LineWidth(pixels), real.PointSize(pixels);
  if (instance.impostors.unlit) real.Disable(GL_LIGHTING);
  for (GLenum i = 0; i < instance.impostors.centerPlanes.size(); ++i) {
    real.ClipPlane(GL_CLIP_PLANE0 + i, glm::value_ptr(glm::dvec4(instance.impostors.centerPlanes[i])));
    real.Enable(GL_CLIP_PLANE0 + i);
  }
}

void drawInstance(const gl::RealGl& real, const scene::Instance& instance, const scene::Camera& camera) {
  setInstanceState(real, instance);
  const scene::Shape shape = instance.mesh->shape;
  if (scene::isSolid(shape)) setSolidState(real, instance, camera);
  real.Color4fv(glm::value_ptr(instance.color));
  real.Normal3fv(glm::value_ptr(instance.normal));
  real.SecondaryColor3fv(glm::value_ptr(instance.secondaryColor));
  real.FogCoordf(instance.fogCoord);
  real.TexCoord4fv(glm::value_ptr(instance.texcoord));
  for (uint32_t unit = 1; unit <= instance.texcoordsAbove.size(); ++unit)
    real.MultiTexCoord4fv(GL_TEXTURE0 + unit, glm::value_ptr(instance.texcoordOf(unit)));
  uint32_t material = 0;
  real.Begin(shape == scene::Shape::balls      ? GL_POINTS
             : shape == scene::Shape::capsules ? GL_LINES
                                               : GL_TRIANGLES);
  for (uint32_t t = 0; t < instance.mesh->triangleCount; ++t)
    for (uint32_t k = 0; k < scene::cornersOf(shape); ++k)
      sendVertex(real, instance, instance.mesh->corner(t, k), material);
  real.End();
}

}  // namespace

bool drawWithFixedFunction(const gl::RealGl& real, const Features& features, const scene::Snapshot& snapshot,
                           GLenum depthFunc, const DepthPass* again) {
  if (!features.compatibility || !attribStackHasRoom(real)) return false;
  StateGuard guard(real, features);
  guard.plainUnpack();
  guard.drawInto(snapshot, depthFunc);
  guard.lastVertexProvokes();
  if (features.version >= 20) guard.program(again ? again->program : 0);
  if (features.version >= 13) guard.activeTexture(GL_TEXTURE0);
  for (int unit = scene::kTextureUnits - 1; unit >= 0 && features.samplerObjects; --unit)
    guard.texture2D(unit, 0);
  if (again && again->sample >= 0) guard.onlySample(again->sample);
  if (again && again->multisampled)
    guard.textureMultisample(0, again->depth);
  else if (again)
    guard.texture2D(0, again->depth);

  real.PushAttrib(GL_ALL_ATTRIB_BITS);
  {
    const KeptMatrices matrices(real);
    setUpCamera(real, snapshot);
    neutralFixedFunction(real, features);
    if (again)
      real.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    else if (snapshot.layers && snapshot.layers->of == scene::Layers::Of::drawn)
      setBlending(real, snapshot.layers->blending);
    ShadingTextures textures(real, features);
    for (const scene::Instance& instance : snapshot.instances) {
      if (!again && isByProgram(snapshot, instance)) continue;
      if (!again) setShading(real, features, snapshot.shadings[instance.shading], textures);
      drawInstance(real, instance, snapshot.camera);
    }
  }
  real.PopAttrib();
  return true;
}

namespace {

/// Replays the draws of programs that take their vertices from fixed function's attributes.
void replayBuiltInDraws(const gl::RealGl& real, const Features& features, const scene::Snapshot& snapshot,
                        GLenum depthFunc, const std::vector<gl::ProgramDraw>& draws) {
  StateGuard guard(real, features);
  guard.drawInto(snapshot, depthFunc);
  guard.lastVertexProvokes();
  guard.activeTexture(GL_TEXTURE0);
  real.PushAttrib(GL_ALL_ATTRIB_BITS);
  real.Disable(GL_VERTEX_PROGRAM_TWO_SIDE);
  {
    const KeptMatrices matrices(real);
    setUpCamera(real, snapshot);
    if (snapshot.layers && snapshot.layers->of == scene::Layers::Of::drawn)
      setBlending(real, snapshot.layers->blending);
    ShadingTextures none(real, features);
    for (const gl::ProgramDraw& draw : draws) {
      if (!draw.builtIn) continue;
      setShading(real, features, draw.builtIn->state, none);
      real.MatrixMode(GL_TEXTURE);
      real.LoadMatrixf(glm::value_ptr(draw.builtIn->textureMatrix));
      real.MatrixMode(GL_MODELVIEW);
      drawWithInputs(real, features, draw,
                     [&] { drawInstance(real, draw.builtIn->instance, snapshot.camera); });
    }
  }
  real.PopAttrib();
}

}  // namespace

bool drawByRealGl(const gl::RealGl& real, const Features& features, const scene::Snapshot& snapshot,
                  const gl::PresentTarget& target) {
  const bool fixedFunction =
      std::any_of(snapshot.instances.begin(), snapshot.instances.end(),
                  [&](const scene::Instance& instance) { return !isByProgram(snapshot, instance); });
  const bool builtIn = std::any_of(target.programDraws.begin(), target.programDraws.end(),
                                   [](const gl::ProgramDraw& draw) { return draw.builtIn != nullptr; });
  if (builtIn && (!features.compatibility || !attribStackHasRoom(real))) return false;
  if (fixedFunction && !drawWithFixedFunction(real, features, snapshot, target.depthFunc)) return false;
  if (builtIn) replayBuiltInDraws(real, features, snapshot, target.depthFunc, target.programDraws);
  replayProgramDraws(real, features, snapshot, target.depthFunc, target.programDraws);
  return true;
}

}  // namespace gluray::present
