#include "gl/state.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <glm/gtc/type_ptr.hpp>

#include <cmath>

namespace gluray::gl {
namespace {

GLint integer(const RealGl& real, GLenum name) {
  GLint value = 0;
  real.GetIntegerv(name, &value);
  return value;
}

bool isOn(const RealGl& real, GLenum capability) { return real.IsEnabled(capability) == GL_TRUE; }

glm::dmat4 matrix(const RealGl& real, GLenum name) {
  glm::dmat4 m(1);
  real.GetDoublev(name, glm::value_ptr(m));
  return m;
}

bool isInvertible(const glm::dmat4& m) {
  const double d = glm::determinant(m);
  return std::isfinite(d) && d != 0.0;
}

}  // namespace

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
    case GL_SCISSOR_TEST:
    case GL_DEPTH_TEST:
    case GL_CULL_FACE:
    case GL_BLEND:
    case GL_ALPHA_TEST:
    case GL_STENCIL_TEST:
    case GL_POLYGON_OFFSET_FILL:
    case GL_FOG:
    case GL_MULTISAMPLE:
    case GL_DITHER: return kRaster;
    default: return kRaster | kTexture | kLighting;
  }
}

void readModelview(const RealGl& real, State& state) {
  state.modelview = matrix(real, GL_MODELVIEW_MATRIX);
  state.modelviewInvertible = isInvertible(state.modelview);
}

void readProjection(const RealGl& real, State& state) {
  state.projection = matrix(real, GL_PROJECTION_MATRIX);
  state.projectionInvertible = isInvertible(state.projection);
}

void readViewport(const RealGl& real, State& state) {
  real.GetIntegerv(GL_VIEWPORT, &state.viewport.x);
  real.GetIntegerv(GL_SCISSOR_BOX, &state.scissor.x);
  GLfloat range[2] = {0, 1};
  real.GetFloatv(GL_DEPTH_RANGE, range);
  state.depthNear = range[0], state.depthFar = range[1];
}

namespace {

/// Why blending rules tracing out; sets `needsOpaque` where it does not for opaque surfaces.
Reason blendReason(const RealGl& real, bool& needsOpaque) {
  needsOpaque = false;
  if (!isOn(real, GL_BLEND)) return Reason::traced;
  const auto source = integer(real, GL_BLEND_SRC_RGB), destination = integer(real, GL_BLEND_DST_RGB);
  const auto sourceAlpha = integer(real, GL_BLEND_SRC_ALPHA),
             destinationAlpha = integer(real, GL_BLEND_DST_ALPHA);
  if (integer(real, GL_BLEND_EQUATION_RGB) != GL_FUNC_ADD ||
      integer(real, GL_BLEND_EQUATION_ALPHA) != GL_FUNC_ADD)
    return Reason::blend;
  const auto isOne = [](GLint f) { return f == GL_ONE || f == GL_SRC_ALPHA; };
  const auto isZero = [](GLint f) { return f == GL_ZERO || f == GL_ONE_MINUS_SRC_ALPHA; };
  if (!isOne(source) || !isZero(destination) || !isOne(sourceAlpha) || !isZero(destinationAlpha))
    return Reason::blend;
  needsOpaque = source == GL_SRC_ALPHA || sourceAlpha == GL_SRC_ALPHA ||
                destination == GL_ONE_MINUS_SRC_ALPHA || destinationAlpha == GL_ONE_MINUS_SRC_ALPHA;
  return Reason::traced;
}

/// State of later versions and extensions that hardly any fixed-function program sets.
Reason rareReason(const RealGl& real, const RareState& has) {
  if (has.depthClamp && isOn(real, GL_DEPTH_CLAMP)) return Reason::depthClamp;
  if (has.depthBounds && isOn(real, GL_DEPTH_BOUNDS_TEST_EXT)) return Reason::depthClamp;
  if (has.rasterizerDiscard && isOn(real, GL_RASTERIZER_DISCARD)) return Reason::transformFeedback;
  if (has.clipControl && (integer(real, GL_CLIP_ORIGIN) != GL_LOWER_LEFT ||
                          integer(real, GL_CLIP_DEPTH_MODE) != GL_NEGATIVE_ONE_TO_ONE))
    return Reason::clipControl;
  if (has.provokingVertex && integer(real, GL_PROVOKING_VERTEX) != GL_LAST_VERTEX_CONVENTION &&
      integer(real, GL_SHADE_MODEL) == GL_FLAT)
    return Reason::provokingVertex;
  GLfloat clamp = 0;
  if (has.offsetClamp) real.GetFloatv(GL_POLYGON_OFFSET_CLAMP, &clamp);
  return clamp != 0 ? Reason::depthClamp : Reason::traced;
}

scene::AlphaTest readAlphaTest(const RealGl& real) {
  scene::AlphaTest test;
  if (!isOn(real, GL_ALPHA_TEST)) return test;
  using Function = scene::AlphaTest;
  switch (integer(real, GL_ALPHA_TEST_FUNC)) {
    case GL_NEVER: test.function = Function::never; break;
    case GL_LESS: test.function = Function::less; break;
    case GL_LEQUAL: test.function = Function::lessOrEqual; break;
    case GL_EQUAL: test.function = Function::equal; break;
    case GL_GEQUAL: test.function = Function::greaterOrEqual; break;
    case GL_GREATER: test.function = Function::greater; break;
    case GL_NOTEQUAL: test.function = Function::notEqual; break;
    default: break;
  }
  real.GetFloatv(GL_ALPHA_TEST_REF, &test.reference);
  return test;
}

scene::Fog readFog(const RealGl& real) {
  scene::Fog fog;
  if (!isOn(real, GL_FOG)) return fog;
  switch (integer(real, GL_FOG_MODE)) {
    case GL_LINEAR: fog.mode = scene::Fog::linear; break;
    case GL_EXP2: fog.mode = scene::Fog::exp2; break;
    default: fog.mode = scene::Fog::exp; break;
  }
  real.GetFloatv(GL_FOG_DENSITY, &fog.density);
  real.GetFloatv(GL_FOG_START, &fog.start);
  real.GetFloatv(GL_FOG_END, &fog.end);
  GLfloat color[4] = {};
  real.GetFloatv(GL_FOG_COLOR, color);
  fog.color = {color[0], color[1], color[2]};
  return fog;
}

/// Why fog rules tracing out: where it does not go by the distance from the viewer's plane.
Reason fogReason(const RealGl& real, const RareState& has) {
  if (!isOn(real, GL_FOG)) return Reason::traced;
  if (integer(real, GL_FOG_COORD_SRC) != GL_FRAGMENT_DEPTH) return Reason::fog;
  const bool usual = !has.fogDistance || integer(real, GL_FOG_DISTANCE_MODE_NV) == GL_EYE_PLANE_ABSOLUTE_NV;
  return usual ? Reason::traced : Reason::fog;
}

/// Why per-fragment operations rule tracing out, cheapest and commonest questions first.
Reason fragmentReason(const RealGl& real, const RareState& has, RasterState& raster) {
  if (integer(real, GL_RENDER_MODE) != GL_RENDER) return Reason::renderMode;
  if (!isOn(real, GL_DEPTH_TEST)) return Reason::noDepthTest;
  if (raster.depthFunc != GL_LESS && raster.depthFunc != GL_LEQUAL) return Reason::depthFunc;
  if (!integer(real, GL_DEPTH_WRITEMASK)) return Reason::depthMask;
  GLboolean mask[4] = {};
  real.GetBooleanv(GL_COLOR_WRITEMASK, mask);
  if (!mask[0] || !mask[1] || !mask[2] || !mask[3]) return Reason::colorMask;
  if (isOn(real, GL_STENCIL_TEST)) return Reason::stencil;
  if (isOn(real, GL_COLOR_LOGIC_OP)) return Reason::logicOp;
  if (const Reason fog = fogReason(real, has); fog != Reason::traced) return fog;
  if (isPresent(real.UseProgram) && integer(real, GL_CURRENT_PROGRAM) != 0) return Reason::program;
  if (isPresent(real.BindProgramPipeline) && integer(real, GL_PROGRAM_PIPELINE_BINDING) != 0)
    return Reason::program;
  if (has.assemblyPrograms && (isOn(real, GL_VERTEX_PROGRAM_ARB) || isOn(real, GL_FRAGMENT_PROGRAM_ARB)))
    return Reason::program;
  if (isOn(real, GL_COLOR_SUM)) return Reason::colorSum;
  if (isOn(real, GL_SAMPLE_ALPHA_TO_COVERAGE) || isOn(real, GL_SAMPLE_COVERAGE) ||
      isOn(real, GL_SAMPLE_ALPHA_TO_ONE) || (has.sampleMask && isOn(real, GL_SAMPLE_MASK)))
    return Reason::multisampleState;
  if (const Reason rare = rareReason(real, has); rare != Reason::traced) return rare;
  bool needsOpaque = false;
  const Reason blend = blendReason(real, needsOpaque);
  if (needsOpaque) raster.unlessOpaque = Reason::blend;
  return blend;
}

Reason polygonReason(const RealGl& real) {
  GLint mode[2] = {GL_FILL, GL_FILL};
  real.GetIntegerv(GL_POLYGON_MODE, mode);
  if (mode[0] != GL_FILL || mode[1] != GL_FILL) return Reason::polygonMode;
  if (isOn(real, GL_POLYGON_STIPPLE)) return Reason::polygonStipple;
  if (isOn(real, GL_POLYGON_SMOOTH)) return Reason::polygonSmooth;
  return Reason::traced;
}

scene::CullFace readCull(const RealGl& real) {
  if (!isOn(real, GL_CULL_FACE)) return scene::CullFace::none;
  switch (integer(real, GL_CULL_FACE_MODE)) {
    case GL_FRONT: return scene::CullFace::front;
    case GL_BACK: return scene::CullFace::back;
    default: return scene::CullFace::both;
  }
}

}  // namespace

void readRaster(const RealGl& real, State& state) {
  RasterState& raster = state.raster;
  raster.depthFunc = static_cast<GLenum>(integer(real, GL_DEPTH_FUNC));
  raster.scissorTest = isOn(real, GL_SCISSOR_TEST);
  raster.unlessOpaque = Reason::traced;
  raster.reason = fragmentReason(real, state.rare, raster);
  // A draw that tests and writes depth, and replaces colour, meets pending traced surfaces in the depth
  // buffer.
  raster.orderFree =
      (raster.reason == Reason::traced || raster.reason == Reason::fog || raster.reason == Reason::program ||
       raster.reason == Reason::colorSum || raster.reason == Reason::renderMode) &&
      !isOn(real, GL_BLEND);
  if (raster.reason == Reason::traced) raster.reason = polygonReason(real);
  raster.multisample = isOn(real, GL_MULTISAMPLE);
  raster.alphaTest = readAlphaTest(real);
  state.shading.fog = readFog(real);
  raster.cull = readCull(real);
  raster.frontFaceCcw = integer(real, GL_FRONT_FACE) == GL_CCW;
  raster.offsetFill = isOn(real, GL_POLYGON_OFFSET_FILL);
  real.GetFloatv(GL_POLYGON_OFFSET_FACTOR, &raster.offsetFactor);
  real.GetFloatv(GL_POLYGON_OFFSET_UNITS, &raster.offsetUnits);
}

namespace {

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

}  // namespace

void readLighting(const RealGl& real, State& state) {
  scene::Shading& shading = state.shading;
  shading.lighting = isOn(real, GL_LIGHTING);
  shading.smooth = integer(real, GL_SHADE_MODEL) == GL_SMOOTH;
  shading.lights.clear();
  shading.colorMaterial = {};
  shading.twoSided = shading.localViewer = shading.separateSpecular = false;
  // Normals also enter generated texture coordinates.
  shading.normalize = isOn(real, GL_NORMALIZE);
  shading.rescaleNormal = isOn(real, GL_RESCALE_NORMAL);
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

void readMaterial(const RealGl& real, State& state) {
  const auto read = [&](GLenum face, scene::Material& m) {
    real.GetMaterialfv(face, GL_AMBIENT, glm::value_ptr(m.ambient));
    real.GetMaterialfv(face, GL_DIFFUSE, glm::value_ptr(m.diffuse));
    real.GetMaterialfv(face, GL_SPECULAR, glm::value_ptr(m.specular));
    real.GetMaterialfv(face, GL_EMISSION, glm::value_ptr(m.emission));
    real.GetMaterialfv(face, GL_SHININESS, &m.shininess);
  };
  read(GL_FRONT, state.material.front);
  read(GL_BACK, state.material.back);
}

void readClipPlanes(const RealGl& real, State& state) {
  state.clipPlanes.clear();
  const GLint count = integer(real, GL_MAX_CLIP_PLANES);
  for (GLint i = 0; i < count; ++i) {
    const auto name = static_cast<GLenum>(GL_CLIP_PLANE0 + i);
    if (!isOn(real, name)) continue;
    glm::dvec4 plane(0);
    real.GetClipPlane(name, glm::value_ptr(plane));
    state.clipPlanes.push_back(plane);
  }
}

namespace {

bool isSingleDrawBuffer(GLenum buffer) {
  switch (buffer) {
    case GL_FRONT:
    case GL_BACK:
    case GL_FRONT_LEFT:
    case GL_BACK_LEFT:
    case GL_FRONT_AND_BACK:
    case GL_LEFT: return true;
    default: return buffer >= GL_COLOR_ATTACHMENT0 && buffer < GL_COLOR_ATTACHMENT0 + 16;
  }
}

/// Whether the colour buffer holds eight-bit normalised values, which is what the write-back delivers.
bool isByteColor(const RealGl& real, const TargetState& target) {
  if (target.framebuffer == 0) return integer(real, GL_RED_BITS) == 8;
  GLint type = 0, bits = 0;
  real.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, target.drawBuffer,
                                           GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
  real.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, target.drawBuffer,
                                           GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, &bits);
  return type == GL_UNSIGNED_NORMALIZED && bits == 8;
}

}  // namespace

namespace {

/// Size of the image that is attached to the framebuffer object's draw buffer; {0, 0} where it is of a kind
/// not asked about.
glm::ivec2 attachmentSize(const RealGl& real, GLenum attachment) {
  const auto ask = [&](GLenum name) {
    GLint value = 0;
    real.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, name, &value);
    return value;
  };
  if (ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_RENDERBUFFER) return {0, 0};
  glm::ivec2 size(0);
  const GLint bound = integer(real, GL_RENDERBUFFER_BINDING);
  real.BindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME)));
  real.GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &size.x);
  real.GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_HEIGHT, &size.y);
  real.BindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(bound));
  return size;
}

}  // namespace

void readTarget(const RealGl& real, State& state, bool core) {
  TargetState& target = state.target;
  target.size = {0, 0};
  target.reason = Reason::traced;
  const bool objects = state.rare.framebufferObjects;
  target.framebuffer = objects ? static_cast<GLuint>(integer(real, GL_DRAW_FRAMEBUFFER_BINDING)) : 0;
  target.drawBuffer = static_cast<GLenum>(integer(real, GL_DRAW_BUFFER));
  target.samples = std::max(1, integer(real, GL_SAMPLES));
  target.samplePositions.assign(static_cast<size_t>(target.samples), glm::vec2(0.5f));
  if (core) {
    target.reason = Reason::program;  // core profiles draw with shaders only
    return;
  }
  if (!isSingleDrawBuffer(target.drawBuffer)) target.reason = Reason::drawBuffer;
  if (target.framebuffer != 0) {
    if (real.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      target.reason = Reason::framebuffer;
    if (integer(real, GL_DRAW_BUFFER0 + 1) != GL_NONE) target.reason = Reason::drawBuffer;
    target.size = attachmentSize(real, target.drawBuffer);
  }
  const GLint depthBits = integer(real, GL_DEPTH_BITS);
  target.depthResolution = std::ldexp(1.0f, -std::min(std::max(depthBits, 1), 24));
  if (target.reason != Reason::traced) return;
  if (depthBits == 0)
    target.reason = Reason::noDepthBuffer;
  else if (!isByteColor(real, target) || (state.rare.framebufferSrgb && isOn(real, GL_FRAMEBUFFER_SRGB)))
    target.reason = Reason::framebuffer;
  if (target.samples > 1 && isPresent(real.GetMultisamplefv))
    for (GLuint i = 0; i < static_cast<GLuint>(target.samples); ++i)
      real.GetMultisamplefv(GL_SAMPLE_POSITION, i, glm::value_ptr(target.samplePositions[i]));
  else if (target.samples > 1)
    target.reason = Reason::framebuffer;
}

}  // namespace gluray::gl
