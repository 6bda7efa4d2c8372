// The real OpenGL's version, extensions and optional state. They are read once, so that queries that it would
// refuse are not made. GL thread, context current.
#pragma once
#include "gl/real/real.h"

#include <string_view>
#include <vector>

namespace gluray::gl {

/// "4.5 (Compatibility Profile) Mesa" -> major * scale + minor; 0 for null. `scale` is 10 for versions of
/// OpenGL, 100 for those of GLSL.
int parseVersion(const GLubyte* text, int scale);
/// 10 * major + minor.
int versionOf(const RealGl& real);
/// "4.5 (Compatibility Profile) Mesa 22.3.6" -> 2203, 100 * major + minor of Mesa; 0 if it is not Mesa.
int mesaVersionOf(const GLubyte* text);
/// The names of the current context's extensions, sorted for repeated queries: OpenGL implementations take
/// long to find the n-th name.
class Extensions {
 public:
  /// May throw std::bad_alloc.
  Extensions(const RealGl& real, int version);
  bool has(std::string_view name) const;

 private:
  std::vector<std::string_view> names_;  // sorted
};
/// Whether the current context's extension list has `name` ("GL_ARB_texture_rg").
bool hasExtension(const RealGl& real, int version, std::string_view name);

/// Whether `mode` is a primitive of glBegin and draws. Patches need OpenGL 4.0 or ARB_tessellation_shader.
bool isPrimitive(const RealGl& real, GLenum mode);
/// Whether generic attributes of type GL_UNSIGNED_INT_10F_11F_11F_REV exist: OpenGL 4.4 or
/// ARB_vertex_type_10f_11f_11f_rev. `version`: of the current context.
bool takesPackedFloats(const RealGl& real, int version);

/// Whether an OpenGL with this GL_RENDERER renders on the CPU.
bool isSoftwareRenderer(std::string_view renderer);
/// Whether the current context's OpenGL does.
bool rendersInSoftware(const RealGl& real);

/// Which state of later versions and extensions a context has, beyond that of OpenGL 1.5.
struct RareState {
  bool asked = false;
  bool fixedFunction = true;  // false in core profiles
  bool framebufferObjects = false, rasterizerDiscard = false, feedbackActive = false, framebufferSrgb = false;
  bool depthClamp = false, depthBounds = false, clipControl = false, provokingVertex = false;
  bool offsetClamp = false, fogDistance = false, sampleMask = false, rectangles = false;
  bool textureTypes = false, textureSwizzle = false, textureStorage = false, textureSrgb = false;
  bool anisotropy = false, seamlessCubes = false;
  bool debugOutput = false, pipelines = false;
  bool assemblyPrograms = false, secondaryColor = false, fogCoord = false;
  bool fogsWholeSum = false;  // quirk fog-sum
  bool byteFilters = false;   // scene::Texture::byteFilter is known to be as the real OpenGL filters
};

/// Whether an OpenGL with these names (GL_RENDERER, GL_VERSION) filters textures with eight bits per
/// component in eight bits, rounded to the nearest value: llvmpipe of Mesa 22 to 25 with vectors of 128 or
/// 256 bits and SSSE3. `tuning`: GALLIVM_PERF of the environment, or null.
bool filtersBytes(const GLubyte* renderer, const GLubyte* version, const char* tuning);

/// Whether an OpenGL with these names (GL_RENDERER, GL_VERSION) numbers primitives wrongly (gl_PrimitiveID)
/// in shader programs without a geometry shader: llvmpipe of Mesa 25.3.6 to 26.1.
bool misnumbersPrimitives(const GLubyte* renderer, const GLubyte* version);

/// Queries the current context. Raises no GL error.
RareState readRareState(const RealGl& real);

}  // namespace gluray::gl
