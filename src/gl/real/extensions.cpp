#include "gl/real/extensions.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

namespace gluray::gl {

int parseVersion(const GLubyte* text, int scale) {
  if (!text) return 0;
  char* end = nullptr;
  const long major = std::strtol(reinterpret_cast<const char*>(text), &end, 10);
  const long minor = *end == '.' ? std::strtol(end + 1, nullptr, 10) : 0;
  return static_cast<int>(major * scale + minor);
}

int versionOf(const RealGl& real) { return parseVersion(real.GetString(GL_VERSION), 10); }

int mesaVersionOf(const GLubyte* text) {
  constexpr std::string_view kName = " Mesa ";
  const std::string_view all = text ? reinterpret_cast<const char*>(text) : "";
  const size_t at = all.find(kName);
  return at == all.npos ? 0 : parseVersion(text + at + kName.size(), 100);
}

bool filtersBytes(const GLubyte* renderer, const GLubyte* version, const char* tuning) {
#if defined(__x86_64__) || defined(__i386__)
  const bool rounds = __builtin_cpu_supports("ssse3");  // it truncates without
#else
  const bool rounds = false;
#endif
  const std::string_view name = renderer ? reinterpret_cast<const char*>(renderer) : "";
  const auto holds = [](std::string_view text, std::string_view part) {
    return text.find(part) != text.npos;
  };
  const int mesa = mesaVersionOf(version);
  return rounds && mesa >= 2200 && mesa < 2600 && holds(name, "llvmpipe") &&
         (holds(name, "128 bits") || holds(name, "256 bits")) &&
         !(tuning && holds(tuning, "no_aos_sampling"));
}

bool misnumbersPrimitives(const GLubyte* renderer, const GLubyte* version) {
  const std::string_view name = renderer ? reinterpret_cast<const char*>(renderer) : "";
  const std::string_view text = version ? reinterpret_cast<const char*>(version) : "";
  const size_t at = text.find("Mesa ");
  int major = 0, minor = 0, patch = 0;
  if (name.find("llvmpipe") == name.npos || at == text.npos ||
      std::sscanf(text.data() + at, "Mesa %d.%d.%d", &major, &minor, &patch) < 2)
    return false;
  const int number = (major * 100 + minor) * 100 + patch;
  return number >= 250306 && number < 260200;
}

Extensions::Extensions(const RealGl& real, int version) {
  const auto add = [&](const GLubyte* name) {
    if (name) names_.emplace_back(reinterpret_cast<const char*>(name));
  };
  if (version >= 30) {
    GLint count = 0;
    real.GetIntegerv(GL_NUM_EXTENSIONS, &count);
    names_.reserve(static_cast<size_t>(std::max(count, 0)));
    for (int i = 0; i < count; ++i) add(real.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
  } else if (const GLubyte* text = real.GetString(GL_EXTENSIONS)) {
    const std::string_view all = reinterpret_cast<const char*>(text);
    for (size_t at = 0; at < all.size();) {
      const size_t end = std::min(all.find(' ', at), all.size());
      if (end > at) names_.push_back(all.substr(at, end - at));
      at = end + 1;
    }
  }
  std::sort(names_.begin(), names_.end());
}

bool Extensions::has(std::string_view name) const {
  return std::binary_search(names_.begin(), names_.end(), name);
}

bool hasExtension(const RealGl& real, int version, std::string_view name) {
  if (version >= 30) {
    GLint count = 0;
    real.GetIntegerv(GL_NUM_EXTENSIONS, &count);
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

bool isPrimitive(const RealGl& real, GLenum mode) {
  if (mode != GL_PATCHES)
    return mode <= GL_POLYGON || (mode >= GL_LINES_ADJACENCY && mode <= GL_TRIANGLE_STRIP_ADJACENCY);
  const int version = versionOf(real);
  return version >= 40 || hasExtension(real, version, "GL_ARB_tessellation_shader");
}

bool isSoftwareRenderer(std::string_view renderer) {
  return std::ranges::any_of(std::array{"llvmpipe", "softpipe", "swrast", "SWR", "Software"},
                             [&](std::string_view part) { return renderer.find(part) != renderer.npos; });
}

bool rendersInSoftware(const RealGl& real) {
  const auto* name = reinterpret_cast<const char*>(real.GetString(GL_RENDERER));
  return name && isSoftwareRenderer(name);
}

bool takesPackedFloats(const RealGl& real, int version) {
  return version >= 44 || hasExtension(real, version, "GL_ARB_vertex_type_10f_11f_11f_rev");
}

RareState readRareState(const RealGl& real) {
  const int version = versionOf(real);
  const Extensions extensions(real, version);
  const auto has = [&](int since, std::string_view extension) {
    return version >= since || extensions.has(extension);
  };
  RareState rare;
  rare.asked = true;
  rare.framebufferObjects = has(30, "GL_ARB_framebuffer_object") || has(30, "GL_EXT_framebuffer_object");
  rare.rasterizerDiscard = has(30, "GL_EXT_transform_feedback");
  rare.feedbackActive = has(40, "GL_ARB_transform_feedback2");
  rare.framebufferSrgb = has(30, "GL_ARB_framebuffer_sRGB") || has(30, "GL_EXT_framebuffer_sRGB");
  rare.depthClamp = has(32, "GL_ARB_depth_clamp");
  rare.depthBounds = extensions.has("GL_EXT_depth_bounds_test");
  rare.clipControl = has(45, "GL_ARB_clip_control");
  rare.provokingVertex = has(32, "GL_ARB_provoking_vertex") || has(32, "GL_EXT_provoking_vertex");
  rare.offsetClamp = has(46, "GL_ARB_polygon_offset_clamp") || has(46, "GL_EXT_polygon_offset_clamp");
  rare.fogDistance = extensions.has("GL_NV_fog_distance");
  rare.sampleMask = has(32, "GL_ARB_texture_multisample");
  rare.rectangles = has(31, "GL_ARB_texture_rectangle");
  rare.textureTypes = has(30, "GL_ARB_texture_float");
  rare.textureSwizzle = has(33, "GL_ARB_texture_swizzle") || has(33, "GL_EXT_texture_swizzle");
  rare.textureStorage = version >= 43;  // with GL_TEXTURE_IMMUTABLE_LEVELS
  rare.textureSrgb = extensions.has("GL_EXT_texture_sRGB_decode");
  rare.anisotropy = has(46, "GL_EXT_texture_filter_anisotropic");
  rare.seamlessCubes = has(32, "GL_ARB_seamless_cube_map");
  rare.debugOutput = has(43, "GL_KHR_debug");
  rare.pipelines = has(41, "GL_ARB_separate_shader_objects");
  rare.assemblyPrograms = extensions.has("GL_ARB_vertex_program");
  rare.secondaryColor = has(14, "GL_EXT_secondary_color");
  rare.fogCoord = has(14, "GL_EXT_fog_coord");
  rare.fogsWholeSum = mesaVersionOf(real.GetString(GL_VERSION)) > 0;
  rare.byteFilters =
      filtersBytes(real.GetString(GL_RENDERER), real.GetString(GL_VERSION), std::getenv("GALLIVM_PERF"));
  return rare;
}

}  // namespace gluray::gl
