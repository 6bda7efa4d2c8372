// What the real OpenGL of a context has: asked once, so that questions it would refuse are not asked. GL
// thread, context current.
#pragma once
#include "gl/real.h"

#include <string_view>

namespace gluray::gl {

/// "4.5 (Compatibility Profile) Mesa" -> major * scale + minor; 0 where there is no such string. `scale` is
/// 10 for OpenGL's versions, 100 for those of GLSL.
int parseVersion(const GLubyte* text, int scale);
/// 10 * major + minor.
int versionOf(const RealGl& real);
/// "4.5 (Compatibility Profile) Mesa 22.3.6" -> 2203, 100 * major + minor of Mesa; 0 where it is not Mesa.
int mesaVersionOf(const GLubyte* text);
/// Whether the current context's extension list has `name` ("GL_ARB_texture_rg").
bool hasExtension(const RealGl& real, int version, std::string_view name);

/// State of later versions and extensions that a context may have beside that of OpenGL 1.5.
struct RareState {
  bool asked = false;
  bool fixedFunction = true;  // not in core profiles
  bool framebufferObjects = false, rasterizerDiscard = false, framebufferSrgb = false;
  bool depthClamp = false, depthBounds = false, clipControl = false, provokingVertex = false;
  bool offsetClamp = false, fogDistance = false, sampleMask = false, rectangles = false;
  bool textureTypes = false, textureSwizzle = false, textureStorage = false, textureSrgb = false;
  bool anisotropy = false, seamlessCubes = false;
  bool assemblyPrograms = false, secondaryColor = false, fogCoord = false;
  bool fogsWholeSum = false;  // quirk fog-sum
};

/// Asks the current context. Raises no GL error.
RareState readRareState(const RealGl& real);

}  // namespace gluray::gl
