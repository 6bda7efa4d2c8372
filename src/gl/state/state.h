// The GL state that draws depend on, in groups, and the functions that read it back from the real OpenGL.
// ShadowState keeps the copies. GL thread.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/real/extensions.h"
#include "gl/real/real.h"
#include "gl/state/attached_images.h"
#include "scene/snapshot.h"

#include <GL/gl.h>
#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace gluray::gl {

/// Groups of state that are read back together. spec/policy.toml names them for each command.
enum StateGroup : uint32_t {
  kModelview = 1 << 0,
  kProjection = 1 << 1,
  kViewport = 1 << 2,  // viewport, depth range, scissor box
  kRaster = 1 << 3,    // per-fragment operations and polygon state, with their enables
  kLighting = 1 << 4,  // lights, light model, shade model, colour material, normalisation
  kMaterial = 1 << 5,
  kFixedTextures = 1 << 6,  // texture units of fixed function
  kClip = 1 << 7,           // clip planes
  kTarget = 1 << 8,         // draw framebuffer and draw buffer
  kFixedArrays = 1 << 9,    // vertex array pointers and enables, of fixed function
  kCurrent = 1 << 10,       // current vertex attributes were changed other than by attribute calls
  kAttributes = 1 << 11,    // vertex arrays of shader programs
  kProgram = 1 << 12,       // the current shader program and its uniforms
  kArrays = kFixedArrays | kAttributes,
  kProgramTextures = 1 << 13,  // textures that shader programs sample
  kTexture = kFixedTextures | kProgramTextures,
  kAllGroups = (1 << 14) - 1,
  // No group: what the command does to held-back current values (CurrentValues) has been noted.
  kHeldNoted = 1 << 30
};
/// Groups that core profiles do not have.
constexpr uint32_t kFixedFunction =
    kModelview | kProjection | kLighting | kMaterial | kFixedTextures | kClip | kFixedArrays | kCurrent;

/// Groups that glEnable and glDisable of this capability touch.
uint32_t groupsOfCapability(GLenum capability);
/// Groups that glPopAttrib may touch.
constexpr uint32_t kAttribGroups = kAllGroups & ~uint32_t{kArrays | kProjection};

struct RasterState {
  GLuint program = 0;                    // current shader program
  Reason reason = Reason::traced;        // why no surface can be traced, or `traced`
  Reason unlessOpaque = Reason::traced;  // why surfaces whose alpha is not 1 cannot be traced, or `traced`
  // The same as `reason`, were all fog, GREATER and GEQUAL traced.
  Reason butDepthFunc = Reason::depthFunc;
  scene::ColorWrites colorWrites;  // channels that glColorMask and blending let draws write
  bool scissorTest = false;
  GLenum depthFunc = GL_LESS;
  /// Whether larger depths are nearer.
  bool isReversed() const { return depthFunc == GL_GREATER || depthFunc == GL_GEQUAL; }
  bool writesDepth = true;
  bool orderFree = false;  // rasterised draws merge with pending traced ones in any order
  /// For surfaces that blend or do not write depth: how they are blended, if they can be traced as layers in
  /// the order of drawing.
  std::optional<scene::Blending> layers;
  bool firstVertexProvokes = false;  // matters for flat shading
  bool multisample = true;
  scene::AlphaTest alphaTest;
  scene::CullFace cull = scene::CullFace::none;
  bool frontFaceCcw = true;
  bool offsetFill = false;
  float offsetFactor = 0, offsetUnits = 0;
};

/// The framebuffer that draws go to.
struct TargetState {
  Reason reason = Reason::traced;
  GLuint framebuffer = 0;
  GLenum drawBuffer = GL_BACK;
  int samples = 1;
  glm::ivec2 size{0};  // pixels, of a framebuffer object; {0, 0}: unknown
  std::vector<glm::vec2> samplePositions;
  bool wideColors = false;  // colours are floats
  bool eightBits = false;   // 8 each of red, green, blue and, if `alpha`, alpha; read with fixed function
  bool alpha = true;
  bool blendable = false;  // eightBits, one draw buffer, one sample per pixel, not `encodes`
  double depthSteps = 0;   // from depth 0 to 1; 0: depth is floats
  bool encodes = false;    // GL_FRAMEBUFFER_SRGB: colours may be encoded when written
  float depthResolution = 1.0f / 16777216.0f;
  // Unit of glPolygonOffset; if depthFloats (depth is floats), it is the last bit of the depth instead.
  float offsetUnit = 1.0f / 8388608.0f;
  bool depthFloats = false;
  // Not read back: number of the context in this process, and its window, pbuffer or pixmap.
  uint64_t context = 0;
  uintptr_t drawable = 0;
};

struct ViewportState {
  glm::ivec4 box{0, 0, 1, 1};      // x, y, width, height
  glm::ivec4 scissor{0, 0, 1, 1};  // the same; counts while RasterState::scissorTest is on
  float depthNear = 0, depthFar = 1;
};

/// What decides which pixels a draw may change, and how. Refers to the state it was made from.
struct PixelState {
  const TargetState& target;
  const RasterState& raster;
  const ViewportState& viewport;
};

/// GL_MODELVIEW_MATRIX or GL_PROJECTION_MATRIX.
glm::dmat4 readMatrix(const RealGl& real, GLenum name);
void readViewport(const RealGl& real, ViewportState& viewport);
/// `fog` is read where `has` says that there is fixed function.
void readRaster(const RealGl& real, const RareState& has, RasterState& raster, scene::Fog& fog);
/// Reads all of `shading` but fog, textures and alpha test.
void readLighting(const RealGl& real, const RareState& has, scene::Shading& shading);
/// Which materials follow the current colour, whether there is lighting or not.
scene::ColorMaterial readColorMaterial(const RealGl& real);
void readMaterial(const RealGl& real, scene::MaterialPair& material);
/// Light `name`, on or off.
scene::Light readLight(const RealGl& real, GLenum name);
/// Those that are enabled, in eye space.
std::vector<glm::dvec4> readClipPlanes(const RealGl& real);
void readTarget(const RealGl& real, const RareState& has, AttachedImages& images, TargetState& target);

}  // namespace gluray::gl
