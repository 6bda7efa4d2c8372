#include "gl/classify/solid_draws.h"

#include "gl/real/state_queries.h"

#include <GL/glext.h>

#include <algorithm>
#include <cmath>

namespace gluray::gl {
namespace {

/// Whether a reason against tracing surfaces does not apply to lines and points.
bool isOfPolygons(Reason reason) {
  return reason == Reason::polygonMode || reason == Reason::polygonStipple ||
         reason == Reason::polygonSmooth || reason == Reason::polygonOffset;
}

/// Whether the size of points depends on their distance.
bool isAttenuated(const RealGl& real) {
  if (!isPresent(real.PointParameterf)) return false;
  GLfloat attenuation[3] = {1, 0, 0};
  real.GetFloatv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
  return attenuation[0] != 1 || attenuation[1] != 0 || attenuation[2] != 0;
}

/// The program's line width or point size in pixels.
float programSize(const RealGl& real, bool core, bool points) {
  GLfloat size = 1, range[2] = {1, 1};
  real.GetFloatv(points ? GL_POINT_SIZE : GL_LINE_WIDTH, &size);
  const GLenum pointRange = core ? GL_POINT_SIZE_RANGE : GL_ALIASED_POINT_SIZE_RANGE;
  real.GetFloatv(points ? pointRange : GL_ALIASED_LINE_WIDTH_RANGE, range);
  return std::clamp(size, range[0], std::max(range[0], range[1]));
}

/// Mean scale factor of a matrix (cube root of its determinant): the size in eye space of object-space size
/// 1.
double stretchOf(const glm::dmat4& eyeFromObject) {
  return std::cbrt(std::abs(glm::determinant(glm::dmat3(eyeFromObject))));
}

/// `ofProgram`: the size in pixels that the shader program sets; 0: none.
void setSize(ShadowState& shadow, scene::Shape shape, const glm::dmat4& eyeFromObject, float ofProgram,
             scene::Impostors& look) {
  const bool points = shape == scene::Shape::balls;
  const Settings& s = shadow.settings;
  look.radius =
      static_cast<float>(double{points ? s.points.radius : s.lines.radius} * stretchOf(eyeFromObject));
  const float asked = points ? s.points.size : s.lines.width;
  float pixels = asked > 0 ? asked : ofProgram;
  if (!(pixels > 0)) pixels = programSize(shadow.real, shadow.info.core, points);
  look.size = glm::vec2(2 * pixels) / glm::vec2(shadow.viewport().box.z, shadow.viewport().box.w);
}

/// The viewer, where lines of sight meet, in homogeneous coordinates of eye space.
glm::vec4 viewerOf(const glm::dmat4& clipFromEye) {
  const glm::dvec4 viewer = -glm::inverse(clipFromEye)[2];
  if (isParallel(clipFromEye)) return {glm::vec3(glm::normalize(glm::dvec3(viewer))), 0};
  return {glm::vec3(glm::dvec3(viewer) / viewer.w), 1};
}

void lightFromViewer(const glm::dmat4& clipFromEye, scene::Instance& instance, scene::Shading& shading) {
  shading.lighting = true;
  shading.twoSided = shading.localViewer = shading.separateSpecular = shading.colorSum = false;
  shading.globalAmbient = {0, 0, 0, 1};
  shading.colorMaterial = {scene::ColorMaterial::diffuse, scene::ColorMaterial::diffuse};
  scene::Light light;
  light.diffuse = glm::vec4(1);
  light.position = viewerOf(clipFromEye);
  shading.lights = {light};
  scene::Material black;
  black.ambient = black.diffuse = {0, 0, 0, 1};
  instance.materials.assign(1, {black, black});
}

}  // namespace

bool isParallel(const glm::dmat4& clipFromEye) {
  return clipFromEye[0].w == 0 && clipFromEye[1].w == 0 && clipFromEye[2].w == 0;
}

Reason solidReason(ShadowState& shadow, PrimitiveClass kind) {
  const RasterState& raster = shadow.raster();
  if (raster.reason != Reason::traced && !isOfPolygons(raster.reason)) return raster.reason;
  if (raster.isReversed()) return Reason::reversedDepth;
  if (raster.depthsFromZero) return Reason::clipControl;
  const RealGl& real = shadow.real;
  const bool points = kind == PrimitiveClass::points;
  const bool blends = raster.unlessOpaque != Reason::traced;
  if (blends && isOn(real, points ? GL_POINT_SMOOTH : GL_LINE_SMOOTH)) return Reason::blend;
  if (!points && isOn(real, GL_LINE_STIPPLE)) return Reason::lineStyle;
  const bool ownSize = points && shadow.settings.points.size == 0 && shadow.settings.points.radius == 0;
  if (ownSize && isAttenuated(real)) return Reason::lineStyle;
  if (!shadow.fixedTextures().empty() || (shadow.shading().colorSum && !shadow.shading().lighting))
    return Reason::lineStyle;
  return Reason::traced;
}

void makeSolid(ShadowState& shadow, scene::Instance& instance, scene::Shading& shading) {
  scene::Impostors& look = instance.impostors;
  setSize(shadow, instance.mesh->shape, instance.eyeFromObject, 0, look);
  look.parallelView = isParallel(shadow.projection());
  look.unlit = !shading.lighting;
  for (const glm::dvec4& plane : instance.clipPlanes)
    look.centerPlanes.emplace_back(plane * instance.eyeFromObject);
  instance.clipPlanes.clear();
  instance.cull = scene::CullFace::none;
  instance.lightingFromObject = glm::mat4(instance.eyeFromObject);
  if (look.unlit) lightFromViewer(shadow.projection(), instance, shading);
}

Reason programSolidReason(ShadowState& shadow, PrimitiveClass kind) {
  const RasterState& raster = shadow.raster();
  if (raster.reason != Reason::traced && !isOfPolygons(raster.reason)) return raster.reason;
  if (raster.isReversed()) return Reason::reversedDepth;
  if (raster.depthsFromZero) return Reason::clipControl;
  const RealGl& real = shadow.real;
  const bool points = kind == PrimitiveClass::points;
  const bool blends = raster.unlessOpaque != Reason::traced;
  const bool compatible = !shadow.info.core;
  if (blends && (points ? compatible && isOn(real, GL_POINT_SMOOTH) : isOn(real, GL_LINE_SMOOTH)))
    return Reason::blend;
  if (!points && compatible && isOn(real, GL_LINE_STIPPLE)) return Reason::lineStyle;
  const bool ownSize = points && shadow.settings.points.size == 0 && shadow.settings.points.radius == 0;
  if (ownSize && isOn(real, GL_PROGRAM_POINT_SIZE) && !(shadow.program().pixelSize > 0))
    return Reason::lineStyle;
  const scene::Shading& shading = shadow.program().shading;
  if (!shading.textures.empty() || shading.fragment.edges ||
      shadow.attributes().shape != scene::Shape::triangles || !shadow.attributes().instanceTransform.empty())
    return Reason::lineStyle;
  return Reason::traced;
}

namespace {

/// Eye space as the program knows it: the program may have only the matrix for normals, or none.
glm::dmat4 eyeOf(const ProgramState& program) {
  if (program.eyeFromObject) return *program.eyeFromObject;
  const glm::dmat3 linear = glm::inverse(glm::transpose(glm::dmat3(program.normalMatrix)));
  return std::isfinite(glm::determinant(linear)) ? glm::dmat4(linear) : glm::dmat4(1);
}

/// Width of lines or size of points in pixels, as the program knows it; 0: it knows none.
float pixelSizeOf(ShadowState& shadow) {
  const ProgramState& program = shadow.program();
  const auto width = static_cast<float>(shadow.viewport().box.z);
  return program.lineSize > 0 ? 0.5f * program.lineSize * width : program.pixelSize;
}

}  // namespace

void makeProgramSolid(ShadowState& shadow, scene::Instance& instance) {
  const ProgramState& program = shadow.program();
  const glm::dmat4 eyeFromObject = eyeOf(program);
  scene::Impostors& look = instance.impostors;
  look = {};
  setSize(shadow, instance.mesh->shape, eyeFromObject, pixelSizeOf(shadow), look);
  look.parallelView = isParallel(program.clipFromObject);
  look.unlit = program.shading.fragment.model == scene::FragmentShading::Model::unlit;
  look.centerPlanes.assign(program.clipPlanes.begin(), program.clipPlanes.end());
  instance.clipPlanes.clear();
  instance.lightingFromObject = glm::mat4(eyeFromObject);
}

}  // namespace gluray::gl
