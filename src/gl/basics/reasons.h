// Why a draw is not traced, not culled or not lit: the names that `--report` and `gluray explain` print. A
// reason against tracing can also be a reason against culling and light.
#pragma once
#include <array>
#include <string_view>

namespace gluray::gl {

/// Reasons why the real OpenGL makes a draw.
#define GLURAY_REASONS(X)                                                                    \
  X(points, "points")                                                                        \
  X(multisampledPoints, "points as spheres whose multisampled coordinates are unclear")      \
  X(lines, "lines")                                                                          \
  X(lineStyle, "lines or points with a style that tubes and spheres lack")                   \
  X(polygonMode, "polygon mode is not fill")                                                 \
  X(renderMode, "selection or feedback")                                                     \
  X(noDepthTest, "depth test off")                                                           \
  X(depthFunc, "depth function is not LESS, LEQUAL, GREATER or GEQUAL")                      \
  X(reversedDepth, "depth function GREATER or GEQUAL where only LESS or LEQUAL is traced")   \
  X(depthMask, "depth writes off")                                                           \
  X(noDepthBuffer, "framebuffer has no depth buffer")                                        \
  X(framebuffer, "framebuffer format not traced")                                            \
  X(drawBuffer, "draw buffer selection not traced")                                          \
  X(colorMask, "colour mask")                                                                \
  X(stencil, "stencil test")                                                                 \
  X(alphaTest, "alpha test")                                                                 \
  X(blend, "blending")                                                                       \
  X(logicOp, "logic operation")                                                              \
  X(fog, "fog distance mode")                                                                \
  X(polygonStipple, "polygon stipple")                                                       \
  X(polygonSmooth, "polygon smoothing")                                                      \
  X(polygonOffset, "polygon offset for lines or points, but not for fills")                  \
  X(program, "vertex or fragment program")                                                   \
  X(programCode, "program with statements that its family does not know")                    \
  X(programValue, "program with a value that its family does not cover")                     \
  X(programPass, "program that is never traced")                                             \
  X(colorMaterial, "material of a list, between glBegin and glEnd, that follows the colour") \
  X(volume, "volume with state or values that are not traced")                               \
  X(textureUnits, "texture unit beyond the eighth")                                          \
  X(textureEnv, "texture environment not traced")                                            \
  X(textureFormat, "texture format not traced")                                              \
  X(textureAnisotropy, "anisotropic texture filter")                                         \
  X(textureIncomplete, "texture incomplete")                                                 \
  X(texGen, "texture coordinate generation")                                                 \
  X(transformFeedback, "transform feedback")                                                 \
  X(depthClamp, "depth clamp or depth bounds")                                               \
  X(clipControl, "clip control: upper left origin, or other than opaque surfaces")           \
  X(provokingVertex, "flat shading by the first vertex")                                     \
  X(query, "query active")                                                                   \
  X(multisampleState, "multisample coverage state")                                          \
  X(homogeneous, "homogeneous vertices (w is not 1)")                                        \
  X(farAway, "vertices farther away than rays reach")                                        \
  X(farFromOrigin, "vertices so far from their origin that rounding shows")                  \
  X(notFinite, "normals, colours or texture coordinates that are infinite or no numbers")    \
  X(tooLarge, "triangles too large or small for the precision of rays")                      \
  X(singularMatrix, "matrix without inverse")                                                \
  X(untraceable, "surface that rays cannot meet")                                            \
  X(flat, "flat layer: drawing order decides")                                               \
  X(coincident, "coincident surfaces: drawing order decides")                                \
  X(passes, "drawn in several passes")                                                       \
  X(arrayState, "vertex array form not traced")                                              \
  X(foreignBuffer, "buffer written where it is not seen")                                    \
  X(persistentMapping, "persistent mapping (quirk hide-persistent-mapping)")                 \
  X(deletedBuffer, "buffer deleted while arrays hold it")                                    \
  X(evaluators, "evaluators")                                                                \
  X(noGlsl, "real OpenGL lacks shaders for the write-back")                                  \
  X(smallScene, "small scene: the real OpenGL is faster")                                    \
  X(instanced, "several instances, or a base instance")                                      \
  X(off, "switched off")                                                                     \
  X(shortage, "memory or threads ran out")                                                   \
  X(failure, "GLuRay failed and stepped aside")

/// Further reasons why the real OpenGL makes a draw whole, although parts of it may be hidden.
#define GLURAY_CULL_REASONS(X)                                            \
  X(fragmentDepth, "fragment shader that writes depth")                   \
  X(primitiveNumbers, "shader that reads numbers of primitives or draws") \
  X(memoryWrites, "shader that writes memory")                            \
  X(geometryShader, "geometry or tessellation shader, or layers")         \
  X(noSource, "shader whose source is not known")                         \
  X(positions, "positions that are no matrix times an attribute")         \
  X(instanceNumbers, "shader that reads numbers of instances")            \
  X(instanceArrays, "arrays of instances that cannot be drawn in parts")  \
  X(indirect, "indirect draw whose commands are not known")               \
  X(mode, "primitives other than triangles")                              \
  X(offsetNearer, "polygon offset towards the viewer")                    \
  X(drawBuffers, "several draw buffers")                                  \
  X(unsteady, "vertices that have just changed")                          \
  X(smallDraw, "draw too small to cull")                                  \
  X(samplesInUse, "multisampled window that holds more than a clear")     \
  X(mostShows, "draw of which most shows")                                \
  X(notTheSame, "culled picture was not the same")

/// Further reasons why a rasterised draw gets no light from GLuRay.
#define GLURAY_LIGHT_REASONS(X)                \
  X(clipDistances, "clip planes or distances") \
  X(leavesOut, "fragment shader that discards")

#define X(name, text) name,
/// Why a draw is rasterised by the real OpenGL instead of traced.
enum class Reason { traced, GLURAY_REASONS(X) };
/// Why a rasterised draw is not culled.
enum class CullReason { culled, GLURAY_REASONS(X) GLURAY_CULL_REASONS(X) };
/// Why a rasterised draw is not lit.
enum class LightReason { lit, GLURAY_REASONS(X) GLURAY_CULL_REASONS(X) GLURAY_LIGHT_REASONS(X) };
#undef X

/// A reason against tracing is also one against culling. Reason::traced becomes CullReason::culled.
constexpr CullReason cullReason(Reason reason) { return static_cast<CullReason>(reason); }
/// A reason against culling is also one against light. CullReason::culled becomes LightReason::lit.
constexpr LightReason lightReason(CullReason reason) { return static_cast<LightReason>(reason); }
constexpr LightReason lightReason(Reason reason) { return lightReason(cullReason(reason)); }

#define X(name, text) +1
inline constexpr int kReasonCount = 1 GLURAY_REASONS(X);
#undef X

/// The reason in plain words.
constexpr std::string_view describe(LightReason reason) {
#define X(name, text) text,
  constexpr std::array texts{"lit", GLURAY_REASONS(X) GLURAY_CULL_REASONS(X) GLURAY_LIGHT_REASONS(X)};
#undef X
  return texts.at(static_cast<size_t>(reason));
}
constexpr std::string_view describe(CullReason reason) {
  return reason == CullReason::culled ? "culled" : describe(lightReason(reason));
}
constexpr std::string_view describe(Reason reason) {
  return reason == Reason::traced ? "traced" : describe(cullReason(reason));
}

}  // namespace gluray::gl
