// Why a draw is rasterised by the real OpenGL instead of traced: the names that `--report` and `gluray
// explain` print.
#pragma once
#include <string_view>

namespace gluray::gl {

#define GLURAY_REASONS(X)                                                    \
  X(traced, "traced")                                                        \
  X(points, "points")                                                        \
  X(lines, "lines")                                                          \
  X(lineStyle, "lines or points with a style that tubes and spheres lack")   \
  X(polygonMode, "polygon mode is not fill")                                 \
  X(renderMode, "selection or feedback")                                     \
  X(noDepthTest, "depth test off")                                           \
  X(depthFunc, "depth function is not LESS or LEQUAL")                       \
  X(depthMask, "depth writes off")                                           \
  X(noDepthBuffer, "framebuffer has no depth buffer")                        \
  X(framebuffer, "framebuffer format not traced")                            \
  X(drawBuffer, "draw buffer selection not traced")                          \
  X(colorMask, "colour mask")                                                \
  X(stencil, "stencil test")                                                 \
  X(alphaTest, "alpha test")                                                 \
  X(blend, "blending")                                                       \
  X(logicOp, "logic operation")                                              \
  X(fog, "fog distance mode")                                                \
  X(polygonStipple, "polygon stipple")                                       \
  X(polygonSmooth, "polygon smoothing")                                      \
  X(program, "vertex or fragment program")                                   \
  X(programCode, "program with statements that its family does not know")    \
  X(programValue, "program with a value that its family does not cover")     \
  X(programPass, "program that is never traced")                             \
  X(textureUnits, "texture unit beyond the eighth")                          \
  X(textureEnv, "texture environment not traced")                            \
  X(textureFormat, "texture format not traced")                              \
  X(textureAnisotropy, "anisotropic texture filter")                         \
  X(textureIncomplete, "texture incomplete")                                 \
  X(texGen, "texture coordinate generation")                                 \
  X(transformFeedback, "transform feedback")                                 \
  X(depthClamp, "depth clamp or depth bounds")                               \
  X(clipControl, "clip control")                                             \
  X(provokingVertex, "flat shading by the first vertex")                     \
  X(query, "query active")                                                   \
  X(multisampleState, "multisample coverage state")                          \
  X(homogeneous, "homogeneous vertices (w is not 1)")                        \
  X(farAway, "vertices farther away than rays reach")                        \
  X(tooLarge, "triangles too large or small for the precision of rays")      \
  X(singularMatrix, "matrix without inverse")                                \
  X(untraceable, "surface that rays cannot meet")                            \
  X(flat, "flat layer: drawing order decides")                               \
  X(coincident, "coincident surfaces: drawing order decides")                \
  X(passes, "drawn in several passes")                                       \
  X(arrayState, "vertex array form not traced")                              \
  X(foreignBuffer, "buffer written where it is not seen")                    \
  X(persistentMapping, "persistent mapping (quirk hide-persistent-mapping)") \
  X(deletedBuffer, "buffer deleted while arrays hold it")                    \
  X(evaluators, "evaluators")                                                \
  X(noGlsl, "real OpenGL lacks shaders for the write-back")                  \
  X(smallScene, "small scene: the real OpenGL is faster")                    \
  X(fragmentDepth, "fragment shader that writes depth")                      \
  X(primitiveNumbers, "shader that reads numbers of primitives or draws")    \
  X(memoryWrites, "shader that writes memory")                               \
  X(geometryShader, "geometry or tessellation shader, or layers")            \
  X(noSource, "shader whose source is not known")                            \
  X(positions, "positions that are no matrix times an attribute")            \
  X(instanced, "several instances, or a base instance")                      \
  X(instanceNumbers, "shader that reads numbers of instances")               \
  X(instanceArrays, "arrays of instances that cannot be drawn in parts")     \
  X(indirect, "indirect draw whose commands are not known")                  \
  X(mode, "primitives other than triangles")                                 \
  X(offsetNearer, "polygon offset towards the viewer")                       \
  X(drawBuffers, "several draw buffers")                                     \
  X(unsteady, "vertices that have just changed")                             \
  X(smallDraw, "draw too small to cull")                                     \
  X(samplesInUse, "multisampled window that holds more than a clear")        \
  X(mostShows, "draw of which most shows")                                   \
  X(clipDistances, "clip planes or distances")                               \
  X(leavesOut, "fragment shader that discards")                              \
  X(notTheSame, "culled picture was not the same")                           \
  X(off, "switched off")                                                     \
  X(shortage, "memory or threads ran out")                                   \
  X(failure, "GLuRay failed and stepped aside")

enum class Reason {
#define X(name, text) name,
  GLURAY_REASONS(X)
#undef X
};
#define X(name, text) +1
inline constexpr int kReasonCount = 0 GLURAY_REASONS(X);
#undef X

/// The reason in plain words.
constexpr std::string_view describe(Reason reason) {
  constexpr std::string_view texts[] = {
#define X(name, text) text,
      GLURAY_REASONS(X)
#undef X
  };
  return texts[static_cast<int>(reason)];
}

}  // namespace gluray::gl
