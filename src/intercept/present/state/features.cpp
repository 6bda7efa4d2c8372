#include "intercept/present/state/features.h"

#include "gl/real/extensions.h"

#include <algorithm>

namespace gluray::present {
namespace {

using gl::hasExtension;

int integerOf(const gl::RealGl& real, GLenum name) {
  GLint value = 0;
  real.GetIntegerv(name, &value);
  return value;
}

bool fixedFunction(const gl::RealGl& real, int version) {
  if (version < 30) return true;
  if (integerOf(real, GL_CONTEXT_FLAGS) & GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT) return false;
  if (version == 30) return true;
  if (version == 31) return hasExtension(real, version, "GL_ARB_compatibility");
  return (integerOf(real, GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_CORE_PROFILE_BIT) == 0;
}

}  // namespace

Features readFeatures(const gl::RealGl& real) {
  Features f;
  f.version = gl::versionOf(real);
  const int v = f.version;
  const gl::Extensions extensions(real, v);
  const auto has = [&](int since, std::string_view extension) {
    return v >= since || extensions.has(extension);
  };
  if (v >= 20) {
    f.glslVersion = gl::parseVersion(real.GetString(GL_SHADING_LANGUAGE_VERSION), 100);
    f.maxDrawBuffers = std::max(1, integerOf(real, GL_MAX_DRAW_BUFFERS));
    f.textureUnit = std::max(0, std::min(integerOf(real, GL_MAX_TEXTURE_IMAGE_UNITS), 16) - 2);
  }
  f.compatibility = fixedFunction(real, v);
  f.maxTextureSize = integerOf(real, GL_MAX_TEXTURE_SIZE);
  f.maxClipDistances = integerOf(real, GL_MAX_CLIP_PLANES);
  f.indexedDrawBuffers = has(30, "GL_EXT_draw_buffers2");
  f.indexedBlending = has(40, "GL_ARB_draw_buffers_blend");
  f.indexedViewports = has(41, "GL_ARB_viewport_array");
  f.offsetClamp = has(46, "GL_ARB_polygon_offset_clamp") || has(46, "GL_EXT_polygon_offset_clamp");
  f.clipControl = has(45, "GL_ARB_clip_control");
  f.samplerObjects = has(33, "GL_ARB_sampler_objects");
  f.multisample = has(13, "GL_ARB_multisample");
  f.sampleMask = has(32, "GL_ARB_texture_multisample");
  f.rasterizerDiscard = has(30, "GL_EXT_transform_feedback");
  f.transformFeedbackPause = has(40, "GL_ARB_transform_feedback2");
  f.debugOutput = has(43, "GL_KHR_debug");
  f.rectangles = v >= 31 || extensions.has("GL_ARB_texture_rectangle");
  f.readFramebuffers = has(30, "GL_ARB_framebuffer_object") || extensions.has("GL_EXT_framebuffer_blit");
  f.depthBounds = extensions.has("GL_EXT_depth_bounds_test");
  f.encoding = has(30, "GL_ARB_framebuffer_sRGB") || has(30, "GL_EXT_framebuffer_sRGB");
  f.floatTextures = has(30, "GL_ARB_texture_float");
  f.redFloatTextures = v >= 30 || (f.floatTextures && extensions.has("GL_ARB_texture_rg"));
  return f;
}

}  // namespace gluray::present
