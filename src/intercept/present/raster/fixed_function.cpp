#include "intercept/present/raster/fixed_function.h"

#include "gl/real/extensions.h"

#include <glm/gtc/type_ptr.hpp>

namespace gluray::present {
namespace {

using gl::hasExtension;
using gl::RealGl;

void enable(const RealGl& real, GLenum capability, bool on) {
  on ? real.Enable(capability) : real.Disable(capability);
}

GLenum colorMaterialName(scene::ColorMaterial::Mode mode) {
  switch (mode) {
    case scene::ColorMaterial::emission: return GL_EMISSION;
    case scene::ColorMaterial::ambient: return GL_AMBIENT;
    case scene::ColorMaterial::diffuse: return GL_DIFFUSE;
    case scene::ColorMaterial::specular: return GL_SPECULAR;
    default: return GL_AMBIENT_AND_DIFFUSE;
  }
}

void setLight(const RealGl& real, GLenum name, const scene::Light& light) {
  real.Lightfv(name, GL_AMBIENT, glm::value_ptr(light.ambient));
  real.Lightfv(name, GL_DIFFUSE, glm::value_ptr(light.diffuse));
  real.Lightfv(name, GL_SPECULAR, glm::value_ptr(light.specular));
  real.Lightfv(name, GL_POSITION, glm::value_ptr(light.position));
  real.Lightfv(name, GL_SPOT_DIRECTION, glm::value_ptr(light.spotDirection));
  real.Lightf(name, GL_SPOT_EXPONENT, light.spotExponent);
  real.Lightf(name, GL_SPOT_CUTOFF, light.spotCutoff);
  real.Lightf(name, GL_CONSTANT_ATTENUATION, light.attenuation.x);
  real.Lightf(name, GL_LINEAR_ATTENUATION, light.attenuation.y);
  real.Lightf(name, GL_QUADRATIC_ATTENUATION, light.attenuation.z);
}

void setColorMaterial(const RealGl& real, const scene::ColorMaterial& modes) {
  using Mode = scene::ColorMaterial;
  real.Disable(GL_COLOR_MATERIAL);
  if (modes.front == Mode::off && modes.back == Mode::off) return;
  const GLenum face = modes.back == Mode::off    ? GL_FRONT
                      : modes.front == Mode::off ? GL_BACK
                                                 : GL_FRONT_AND_BACK;
  real.ColorMaterial(face, colorMaterialName(modes.front == Mode::off ? modes.back : modes.front));
  real.Enable(GL_COLOR_MATERIAL);
}

void setFog(const RealGl& real, const Features& features, const scene::Fog& fog) {
  enable(real, GL_FOG, fog.mode != scene::Fog::off);
  if (fog.mode == scene::Fog::off) return;
  real.Fogi(GL_FOG_MODE, fog.mode == scene::Fog::linear ? GL_LINEAR
                         : fog.mode == scene::Fog::exp  ? GL_EXP
                                                        : GL_EXP2);
  if (features.version >= 14)
    real.Fogi(GL_FOG_COORD_SRC, fog.fromCoordinates ? GL_FOG_COORD : GL_FRAGMENT_DEPTH);
  real.Fogf(GL_FOG_DENSITY, fog.density);
  real.Fogf(GL_FOG_START, fog.start);
  real.Fogf(GL_FOG_END, fog.end);
  const glm::vec4 color(fog.color, 1);
  real.Fogfv(GL_FOG_COLOR, glm::value_ptr(color));
}

GLenum functionName(scene::AlphaTest::Function function) {
  switch (function) {
    case scene::AlphaTest::never: return GL_NEVER;
    case scene::AlphaTest::less: return GL_LESS;
    case scene::AlphaTest::lessOrEqual: return GL_LEQUAL;
    case scene::AlphaTest::equal: return GL_EQUAL;
    case scene::AlphaTest::greaterOrEqual: return GL_GEQUAL;
    case scene::AlphaTest::greater: return GL_GREATER;
    case scene::AlphaTest::notEqual: return GL_NOTEQUAL;
    default: return GL_ALWAYS;
  }
}

void setAlphaTest(const RealGl& real, const scene::AlphaTest& test) {
  enable(real, GL_ALPHA_TEST, test.function != scene::AlphaTest::always);
  real.AlphaFunc(functionName(test.function), test.reference);
}

void setMaterial(const RealGl& real, GLenum face, const scene::Material& material) {
  real.Materialfv(face, GL_AMBIENT, glm::value_ptr(material.ambient));
  real.Materialfv(face, GL_DIFFUSE, glm::value_ptr(material.diffuse));
  real.Materialfv(face, GL_SPECULAR, glm::value_ptr(material.specular));
  real.Materialfv(face, GL_EMISSION, glm::value_ptr(material.emission));
  real.Materialf(face, GL_SHININESS, material.shininess);
}

}  // namespace

void neutralFixedFunction(const RealGl& real, const Features& features) {
  real.Disable(GL_FOG);
  if (features.version >= 14) real.Disable(GL_COLOR_SUM);
  if (hasExtension(real, features.version, "GL_ARB_vertex_program")) real.Disable(GL_VERTEX_PROGRAM_ARB);
  if (hasExtension(real, features.version, "GL_ARB_fragment_program")) real.Disable(GL_FRAGMENT_PROGRAM_ARB);
  GLint units = 1;
  if (features.version >= 13) real.GetIntegerv(GL_MAX_TEXTURE_UNITS, &units);
  for (int unit = units - 1; unit >= 0; --unit) {
    if (features.version >= 13) real.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    for (GLenum target : {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP})
      if (target < GL_TEXTURE_3D || features.version >= 13) real.Disable(target);
    if (features.rectangles) real.Disable(GL_TEXTURE_RECTANGLE);
    for (GLenum generator : {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q})
      real.Disable(generator);
  }
}

void setShading(const RealGl& real, const Features& features, const scene::Shading& shading,
                ShadingTextures& textures) {
  // Light positions are in eye space.
  real.MatrixMode(GL_MODELVIEW);
  real.LoadIdentity();
  enable(real, GL_LIGHTING, shading.lighting);
  enable(real, GL_NORMALIZE, shading.normalize);
  if (features.version >= 12) {
    enable(real, GL_RESCALE_NORMAL, shading.rescaleNormal);
    real.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                     shading.separateSpecular ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
  }
  if (features.version >= 14) enable(real, GL_COLOR_SUM, shading.colorSum);
  real.ShadeModel(shading.smooth ? GL_SMOOTH : GL_FLAT);
  real.LightModelfv(GL_LIGHT_MODEL_AMBIENT, glm::value_ptr(shading.globalAmbient));
  real.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, shading.localViewer);
  real.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, shading.twoSided);
  GLint limit = 8;
  real.GetIntegerv(GL_MAX_LIGHTS, &limit);
  for (GLint i = 0; i < limit; ++i) {
    const bool on = static_cast<size_t>(i) < shading.lights.size();
    enable(real, GL_LIGHT0 + static_cast<GLenum>(i), on);
    if (on) setLight(real, GL_LIGHT0 + static_cast<GLenum>(i), shading.lights[static_cast<size_t>(i)]);
  }
  setFog(real, features, shading.fog);
  setAlphaTest(real, shading.alphaTest);
  textures.set(shading.textures);
  setColorMaterial(real, shading.colorMaterial);
}

void setInstanceState(const RealGl& real, const scene::Instance& instance) {
  real.MatrixMode(GL_MODELVIEW);
  real.LoadIdentity();
  GLint limit = 6;
  real.GetIntegerv(GL_MAX_CLIP_PLANES, &limit);
  for (GLint i = 0; i < limit; ++i) {
    const auto name = GL_CLIP_PLANE0 + static_cast<GLenum>(i);
    const bool on = static_cast<size_t>(i) < instance.clipPlanes.size();
    enable(real, name, on);
    if (on) real.ClipPlane(name, glm::value_ptr(instance.clipPlanes[static_cast<size_t>(i)]));
  }
  real.LoadMatrixd(glm::value_ptr(instance.eyeFromObject));
  enable(real, GL_CULL_FACE, instance.cull != scene::CullFace::none);
  if (instance.cull != scene::CullFace::none)
    real.CullFace(instance.cull == scene::CullFace::front  ? GL_FRONT
                  : instance.cull == scene::CullFace::back ? GL_BACK
                                                           : GL_FRONT_AND_BACK);
  real.FrontFace(instance.frontFaceCcw ? GL_CCW : GL_CW);
  setMaterials(real, instance.materials.front());
}

void setMaterials(const RealGl& real, const scene::MaterialPair& materials) {
  if (materials.front == materials.back) return setMaterial(real, GL_FRONT_AND_BACK, materials.front);
  setMaterial(real, GL_FRONT, materials.front);
  setMaterial(real, GL_BACK, materials.back);
}

}  // namespace gluray::present
