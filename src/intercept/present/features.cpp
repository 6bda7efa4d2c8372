#include "intercept/present/features.h"

#include <algorithm>
#include <cstdlib>

namespace gluray::present {
namespace {

/// "4.5 (Compatibility Profile) Mesa" -> major * scale + minor; 0 where there is no such string.
int parseVersion(const GLubyte* text, int scale) {
  if (!text) return 0;
  char* end = nullptr;
  const long major = std::strtol(reinterpret_cast<const char*>(text), &end, 10);
  const long minor = *end == '.' ? std::strtol(end + 1, nullptr, 10) : 0;
  return static_cast<int>(major * scale + minor);
}

int integer(const gl::RealGl& real, GLenum name) {
  GLint value = 0;
  real.GetIntegerv(name, &value);
  return value;
}

bool fixedFunction(const gl::RealGl& real, int version) {
  if (version < 30) return true;
  if (integer(real, GL_CONTEXT_FLAGS) & GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT) return false;
  if (version == 30) return true;
  if (version == 31) return hasExtension(real, version, "GL_ARB_compatibility");
  return (integer(real, GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_CORE_PROFILE_BIT) == 0;
}

}  // namespace

bool hasExtension(const gl::RealGl& real, int version, std::string_view name) {
  if (version >= 30) {
    const int count = integer(real, GL_NUM_EXTENSIONS);
    for (int i = 0; i < count; ++i) {
      const auto* text =
          reinterpret_cast<const char*>(real.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
      if (text && name == text) return true;
    }
    return false;
  }
  const auto* text = reinterpret_cast<const char*>(real.GetString(GL_EXTENSIONS));
  const std::string_view all = text ? text : "";
  for (size_t at = all.find(name); at != all.npos; at = all.find(name, at + 1)) {
    const size_t end = at + name.size();
    if ((at == 0 || all[at - 1] == ' ') && (end == all.size() || all[end] == ' ')) return true;
  }
  return false;
}

Features readFeatures(const gl::RealGl& real) {
  Features f;
  f.version = parseVersion(real.GetString(GL_VERSION), 10);
  const int v = f.version;
  const auto has = [&](int since, std::string_view extension) {
    return v >= since || hasExtension(real, v, extension);
  };
  if (v >= 20) {
    f.glslVersion = parseVersion(real.GetString(GL_SHADING_LANGUAGE_VERSION), 100);
    f.maxDrawBuffers = std::max(1, integer(real, GL_MAX_DRAW_BUFFERS));
    f.textureUnit = std::max(0, std::min(integer(real, GL_MAX_TEXTURE_IMAGE_UNITS), 16) - 2);
  }
  f.compatibility = fixedFunction(real, v);
  f.maxTextureSize = integer(real, GL_MAX_TEXTURE_SIZE);
  f.maxClipDistances = integer(real, GL_MAX_CLIP_PLANES);
  f.indexedDrawBuffers = has(30, "GL_EXT_draw_buffers2");
  f.indexedViewports = has(41, "GL_ARB_viewport_array");
  f.samplerObjects = has(33, "GL_ARB_sampler_objects");
  f.multisample = has(13, "GL_ARB_multisample");
  f.sampleMask = has(32, "GL_ARB_texture_multisample");
  f.rasterizerDiscard = has(30, "GL_EXT_transform_feedback");
  f.transformFeedbackPause = has(40, "GL_ARB_transform_feedback2");
  f.debugOutput = has(43, "GL_KHR_debug");
  f.rectangles = v >= 31 || hasExtension(real, v, "GL_ARB_texture_rectangle");
  f.depthBounds = hasExtension(real, v, "GL_EXT_depth_bounds_test");
  f.floatTextures = has(30, "GL_ARB_texture_float");
  f.redFloatTextures = v >= 30 || (f.floatTextures && hasExtension(real, v, "GL_ARB_texture_rg"));
  return f;
}

}  // namespace gluray::present
