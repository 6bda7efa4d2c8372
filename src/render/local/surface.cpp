#include "render/local/surface.h"

#include "render/local/lighting_space.h"
#include "scene/failure.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

// The triangle's plane in object space, in double: precise enough for any float input.
glm::dvec4 planeOf(const scene::Mesh& mesh, uint32_t primitive) {
  const glm::dvec3 p0(mesh.position(mesh.corner(primitive, 0)));
  const glm::dvec3 p1(mesh.position(mesh.corner(primitive, 1)));
  const glm::dvec3 p2(mesh.position(mesh.corner(primitive, 2)));
  const glm::dvec3 n = glm::cross(p1 - p0, p2 - p0);
  return {n, -glm::dot(n, p0)};
}

glm::dvec3 pointOf(const scene::Mesh& mesh, uint32_t primitive, double u, double v) {
  const glm::dvec3 p0(mesh.position(mesh.corner(primitive, 0)));
  const glm::dvec3 p1(mesh.position(mesh.corner(primitive, 1)));
  const glm::dvec3 p2(mesh.position(mesh.corner(primitive, 2)));
  return (1 - u - v) * p0 + u * p1 + v * p2;
}

PlaneDepth makePlaneDepth(const View& view, const glm::dmat4& objectFromClip,
                          const glm::dmat4& eyeFromObject) {
  PlaneDepth depth;
  depth.aX = objectFromClip[0] * view.window.ndcScale.x;
  depth.aY = objectFromClip[1] * view.window.ndcScale.y;
  depth.a = objectFromClip * glm::dvec4(view.window.ndcOffset, 0.0, 1.0);
  depth.b = objectFromClip[2];
  depth.areaSign = glm::determinant(eyeFromObject) < 0 ? -view.areaSign : view.areaSign;
  return depth;
}

ImpostorSpace makeImpostorSpace(const View& view, const Surface& s, const glm::dmat4& objectFromClip) {
  const glm::dmat4 lightingFromObject(s.instance->lightingFromObject);
  const glm::dmat4 lightingFromClip = lightingFromObject * objectFromClip;
  const glm::dmat4 clipRows = glm::transpose(s.clipFromObject * glm::inverse(lightingFromObject));
  ImpostorSpace space;
  space.startX = lightingFromClip[0] * view.window.ndcScale.x;
  space.startY = lightingFromClip[1] * view.window.ndcScale.y;
  space.start = lightingFromClip * glm::dvec4(view.window.ndcOffset, -view.away, 1.0);
  space.step = lightingFromClip[2] * view.away;
  space.clipZ = clipRows[2], space.clipW = clipRows[3];
  return space;
}

void prepareNormals(Surface& s, const scene::Shading& shading, const glm::dmat3& objectFromEye) {
  s.eyeFromObjectNormal = glm::mat3(glm::transpose(objectFromEye));
  const std::optional<glm::dmat3> own = eyeFromVertexNormal(*s.instance, shading);
  s.eyeFromVertexNormal = own ? glm::mat3(*own) : s.eyeFromObjectNormal;
  const double third = glm::length(glm::dvec3(objectFromEye[0][2], objectFromEye[1][2], objectFromEye[2][2]));
  s.rescale = third > 0 ? static_cast<float>(1.0 / third) : 1.0f;
}

void prepareMaterials(Surface& s, const scene::Instance& instance,
                      const scene::ColorMaterial& colorMaterial) {
  s.colorsVary = static_cast<bool>(instance.mesh->colors);
  s.materials = instance.materials.data();
  s.materialCount = static_cast<uint32_t>(instance.materials.size());
  if (s.colorsVary || colorMaterial == scene::ColorMaterial{}) return;
  s.coloredMaterials = instance.materials;
  for (scene::MaterialPair& pair : s.coloredMaterials) {
    applyColorMaterial(colorMaterial.front, instance.color, pair.front);
    applyColorMaterial(colorMaterial.back, instance.color, pair.back);
  }
  s.materials = s.coloredMaterials.data();
}

}  // namespace

void applyColorMaterial(scene::ColorMaterial::Mode mode, const glm::vec4& color, scene::Material& m) {
  using Mode = scene::ColorMaterial;
  if (mode == Mode::emission) m.emission = color;
  if (mode == Mode::ambient || mode == Mode::ambientAndDiffuse) m.ambient = color;
  if (mode == Mode::diffuse || mode == Mode::ambientAndDiffuse) m.diffuse = color;
  if (mode == Mode::specular) m.specular = color;
}

View::View(const scene::Camera& camera)
    : window(camera.viewport),
      clipFromEye(camera.clipFromEye),
      eyeFromClip(glm::inverse(camera.clipFromEye)),
      areaSign(glm::determinant(camera.clipFromEye) < 0 ? -1.0 : 1.0),
      away(-camera.firstNdcDepth()) {}

Surface makeSurface(const View& view, const scene::Instance& instance, const Lighting& lighting,
                    bool sharedClipPlanes) {
  Surface s;
  s.instance = &instance;
  s.mesh = instance.mesh.get();
  s.lighting = &lighting;
  s.clipFromObject = view.clipFromEye * instance.eyeFromObject;
  s.eyeFromObject = glm::mat4(instance.eyeFromObject);
  const glm::dmat4 objectFromEye = glm::inverse(instance.eyeFromObject);
  const glm::dmat4 objectFromClip = objectFromEye * view.eyeFromClip;
  if (!std::isfinite(glm::determinant(objectFromClip))) {
    throw scene::Untraceable("the modelview matrix of an instance cannot be inverted");
  }
  s.depth = makePlaneDepth(view, objectFromClip, instance.eyeFromObject);
  if (s.mesh->shape != scene::Shape::triangles) s.impostors = makeImpostorSpace(view, s, objectFromClip);
  // Modelview matrices are affine: the inverse's upper left 3x3 part is the inverse of the upper left part.
  prepareNormals(s, *lighting.shading, glm::dmat3(objectFromEye));
  prepareMaterials(s, instance, lighting.shading->colorMaterial);

  const bool cullsFront = instance.cull == scene::CullFace::front || instance.cull == scene::CullFace::both;
  const bool cullsBack = instance.cull == scene::CullFace::back || instance.cull == scene::CullFace::both;
  s.frontIsCcw = instance.frontFaceCcw;
  s.cullsCcw = s.frontIsCcw ? cullsFront : cullsBack;
  s.cullsCw = s.frontIsCcw ? cullsBack : cullsFront;
  s.ownClipPlanes = !sharedClipPlanes && !instance.clipPlanes.empty();
  return s;
}

bool Surface::isCcwFrom(const glm::dvec4& viewer, uint32_t primitive) const {
  return depth.areaSign * glm::dot(planeOf(*mesh, primitive), viewer) > 0;
}

bool Surface::acceptsFrom(const glm::dvec4& viewer, uint32_t primitive, float u, float v) const {
  if ((cullsCcw || cullsCw) && (isCcwFrom(viewer, primitive) ? cullsCcw : cullsCw)) return false;
  return !ownClipPlanes || !isCutAway(primitive, u, v);
}

bool Surface::isCutAway(uint32_t primitive, float u, float v) const {
  const glm::dvec4 eye = instance->eyeFromObject * glm::dvec4(pointOf(*mesh, primitive, u, v), 1.0);
  return !std::all_of(instance->clipPlanes.begin(), instance->clipPlanes.end(),
                      [&](const glm::dvec4& plane) { return glm::dot(plane, eye) >= 0; });
}

glm::vec3 Surface::centerOfImpostor(const glm::vec3& object) const {
  return scene::impostorCenter(instance->lightingFromObject, object);
}

glm::vec2 Surface::weightsAt(uint32_t primitive, const glm::dvec2& ndc) const {
  glm::dvec3 clip[3];  // x, y, w
  for (uint32_t k = 0; k < 3; ++k) {
    const glm::dvec4 c = clipFromObject * glm::dvec4(mesh->position(mesh->corner(primitive, k)), 1.0);
    clip[k] = {c.x, c.y, c.w};
  }
  const glm::dvec3 at(ndc, 1.0);
  const glm::dvec3 edge(glm::dot(glm::cross(clip[1], clip[2]), at),
                        glm::dot(glm::cross(clip[2], clip[0]), at),
                        glm::dot(glm::cross(clip[0], clip[1]), at));
  const double sum = edge.x + edge.y + edge.z;
  return sum != 0 ? glm::vec2(edge.y / sum, edge.z / sum) : glm::vec2(0);
}

double Surface::ndcDepth(uint32_t primitive, float u, float v) const {
  const glm::dvec4 clip = clipFromObject * glm::dvec4(pointOf(*mesh, primitive, u, v), 1.0);
  return clip.z / clip.w;
}

glm::dvec2 Surface::ndcDepths(uint32_t primitive) const {
  glm::dvec2 range(1, -1);
  for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1)}) {
    const glm::dvec4 clip = clipFromObject * glm::dvec4(pointOf(*mesh, primitive, corner.x, corner.y), 1.0);
    // The near plane clips points behind the viewer.
    const double depth = clip.w > 0 ? std::clamp(clip.z / clip.w, -1.0, 1.0) : -1.0;
    range = {std::min(range.x, depth), std::max(range.y, depth)};
  }
  return range;
}

}  // namespace gluray::render
