#include "gl/state/state.h"

#include "gl/real/state_queries.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gluray::gl {
namespace {

scene::Region intersect(glm::ivec4 a, glm::ivec4 b) {
  const int x0 = std::max(a.x, b.x), y0 = std::max(a.y, b.y);
  const int64_t x1 = std::min(int64_t{a.x} + a.z, int64_t{b.x} + b.z),
                y1 = std::min(int64_t{a.y} + a.w, int64_t{b.y} + b.w);
  return {x0, y0, static_cast<int>(std::max<int64_t>(0, x1 - x0)),
          static_cast<int>(std::max<int64_t>(0, y1 - y0))};
}

}  // namespace

scene::Region ViewportState::region() const {
  constexpr int kLargest = 16384;  // no framebuffer is larger; limits images for absurd viewports
  const scene::Region r = intersect(box, {0, 0, kLargest, kLargest});
  return scissorTest ? intersect({r.x, r.y, r.width, r.height}, scissor) : r;
}

uint32_t groupsOfCapability(GLenum capability) {
  if (capability >= GL_LIGHT0 && capability <= GL_LIGHT0 + 31) return kLighting;
  if (capability >= GL_CLIP_PLANE0 && capability <= GL_CLIP_PLANE0 + 31) return kClip;
  switch (capability) {
    case GL_LIGHTING:
    case GL_NORMALIZE:
    case GL_RESCALE_NORMAL: return kLighting;
    case GL_COLOR_MATERIAL: return kLighting | kMaterial;
    case GL_TEXTURE_1D:
    case GL_TEXTURE_2D:
    case GL_TEXTURE_3D:
    case GL_TEXTURE_CUBE_MAP:
    case GL_TEXTURE_RECTANGLE:
    case GL_TEXTURE_GEN_S:
    case GL_TEXTURE_GEN_T:
    case GL_TEXTURE_GEN_R:
    case GL_TEXTURE_GEN_Q: return kTexture;
    case GL_SCISSOR_TEST: return kViewport;
    case GL_DEPTH_TEST:
    case GL_CULL_FACE:
    case GL_BLEND:
    case GL_ALPHA_TEST:
    case GL_STENCIL_TEST:
    case GL_POLYGON_OFFSET_FILL:
    case GL_POLYGON_OFFSET_LINE:
    case GL_POLYGON_OFFSET_POINT:
    case GL_FOG:
    case GL_MULTISAMPLE:
    case GL_DITHER: return kRaster;
    case GL_FRAMEBUFFER_SRGB: return kTarget;
    case GL_PRIMITIVE_RESTART:
    case GL_PRIMITIVE_RESTART_FIXED_INDEX: return kArrays;
    default: return kRaster | kTexture | kLighting;
  }
}

glm::dmat4 readMatrix(const RealGl& real, GLenum name) {
  glm::dmat4 m(1);
  real.GetDoublev(name, glm::value_ptr(m));
  return m;
}

void readViewport(const RealGl& real, ViewportState& viewport) {
  real.GetIntegerv(GL_VIEWPORT, &viewport.box.x);
  real.GetIntegerv(GL_SCISSOR_BOX, &viewport.scissor.x);
  viewport.scissorTest = isOn(real, GL_SCISSOR_TEST);
  GLfloat range[2] = {0, 1};
  real.GetFloatv(GL_DEPTH_RANGE, range);
  viewport.depthNear = range[0], viewport.depthFar = range[1];
}

scene::ColorMaterial readColorMaterial(const RealGl& real) {
  scene::ColorMaterial result;
  if (!isOn(real, GL_COLOR_MATERIAL)) return result;
  auto mode = scene::ColorMaterial::off;
  switch (integer(real, GL_COLOR_MATERIAL_PARAMETER)) {
    case GL_EMISSION: mode = scene::ColorMaterial::emission; break;
    case GL_AMBIENT: mode = scene::ColorMaterial::ambient; break;
    case GL_DIFFUSE: mode = scene::ColorMaterial::diffuse; break;
    case GL_SPECULAR: mode = scene::ColorMaterial::specular; break;
    default: mode = scene::ColorMaterial::ambientAndDiffuse; break;
  }
  const auto face = integer(real, GL_COLOR_MATERIAL_FACE);
  if (face != GL_BACK) result.front = mode;
  if (face != GL_FRONT) result.back = mode;
  return result;
}

scene::Light readLight(const RealGl& real, GLenum name) {
  scene::Light light;
  real.GetLightfv(name, GL_AMBIENT, glm::value_ptr(light.ambient));
  real.GetLightfv(name, GL_DIFFUSE, glm::value_ptr(light.diffuse));
  real.GetLightfv(name, GL_SPECULAR, glm::value_ptr(light.specular));
  real.GetLightfv(name, GL_POSITION, glm::value_ptr(light.position));
  GLfloat direction[4] = {0, 0, -1, 0};
  real.GetLightfv(name, GL_SPOT_DIRECTION, direction);
  light.spotDirection = {direction[0], direction[1], direction[2]};
  real.GetLightfv(name, GL_SPOT_EXPONENT, &light.spotExponent);
  real.GetLightfv(name, GL_SPOT_CUTOFF, &light.spotCutoff);
  real.GetLightfv(name, GL_CONSTANT_ATTENUATION, &light.attenuation.x);
  real.GetLightfv(name, GL_LINEAR_ATTENUATION, &light.attenuation.y);
  real.GetLightfv(name, GL_QUADRATIC_ATTENUATION, &light.attenuation.z);
  return light;
}

void readLighting(const RealGl& real, const RareState& has, scene::Shading& shading) {
  shading.lighting = isOn(real, GL_LIGHTING);
  shading.smooth = integer(real, GL_SHADE_MODEL) == GL_SMOOTH;
  shading.lights.clear();
  shading.colorMaterial = {};
  shading.twoSided = shading.localViewer = shading.separateSpecular = false;
  // Normals also affect generated texture coordinates.
  shading.normalize = isOn(real, GL_NORMALIZE);
  shading.rescaleNormal = isOn(real, GL_RESCALE_NORMAL);
  shading.colorSum = !shading.lighting && has.secondaryColor && isOn(real, GL_COLOR_SUM);
  if (!shading.lighting) return;
  shading.twoSided = integer(real, GL_LIGHT_MODEL_TWO_SIDE) != 0;
  shading.localViewer = integer(real, GL_LIGHT_MODEL_LOCAL_VIEWER) != 0;
  shading.separateSpecular = integer(real, GL_LIGHT_MODEL_COLOR_CONTROL) == GL_SEPARATE_SPECULAR_COLOR;
  real.GetFloatv(GL_LIGHT_MODEL_AMBIENT, glm::value_ptr(shading.globalAmbient));
  shading.colorMaterial = readColorMaterial(real);
  const GLint count = integer(real, GL_MAX_LIGHTS);
  for (GLint i = 0; i < count; ++i) {
    const auto name = static_cast<GLenum>(GL_LIGHT0 + i);
    if (isOn(real, name)) shading.lights.push_back(readLight(real, name));
  }
}

void readMaterial(const RealGl& real, scene::MaterialPair& material) {
  const auto read = [&](GLenum face, scene::Material& m) {
    real.GetMaterialfv(face, GL_AMBIENT, glm::value_ptr(m.ambient));
    real.GetMaterialfv(face, GL_DIFFUSE, glm::value_ptr(m.diffuse));
    real.GetMaterialfv(face, GL_SPECULAR, glm::value_ptr(m.specular));
    real.GetMaterialfv(face, GL_EMISSION, glm::value_ptr(m.emission));
    real.GetMaterialfv(face, GL_SHININESS, &m.shininess);
  };
  read(GL_FRONT, material.front);
  read(GL_BACK, material.back);
}

std::vector<glm::dvec4> readClipPlanes(const RealGl& real) {
  std::vector<glm::dvec4> planes;
  const GLint count = integer(real, GL_MAX_CLIP_PLANES);
  for (GLint i = 0; i < count; ++i) {
    const auto name = static_cast<GLenum>(GL_CLIP_PLANE0 + i);
    if (!isOn(real, name)) continue;
    glm::dvec4 plane(0);
    real.GetClipPlane(name, glm::value_ptr(plane));
    planes.push_back(plane);
  }
  return planes;
}

}  // namespace gluray::gl
