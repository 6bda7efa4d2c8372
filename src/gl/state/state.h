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
  kViewport = 1 << 2,  // viewport, depth range, scissor box and test
  kRaster = 1 << 3,    // per-fragment operations and polygon state, with their enables
  kLighting = 1 << 4,  // lights, light model, shade model, colour material, normalisation
  kMaterial = 1 << 5,
  kFixedTextures = 1 << 6,  // texture units of fixed function
  kClip = 1 << 7,           // clip planes
  kTarget = 1 << 8,         // draw framebuffer and draw buffer
  kFixedArrays = 1 << 9,    // vertex array pointers and enables, of fixed function
  kCurrent = 1 << 10,       // current vertex attributes, changed other than by attribute calls
  kAttributes = 1 << 11,    // vertex arrays of shader programs
  kProgram = 1 << 12,       // the current shader program and its uniforms
  kArrays = kFixedArrays | kAttributes,
  kProgramTextures = 1 << 13,  // textures that shader programs sample
  kTexture = kFixedTextures | kProgramTextures,
  kAllGroups = (1 << 14) - 1,
  // No group: what the command does to held-back current values (CurrentValues) has been noted.
  kHeldNoted = 1 << 30
};
/// Groups that core profiles lack.
constexpr uint32_t kFixedFunction =
    kModelview | kProjection | kLighting | kMaterial | kFixedTextures | kClip | kFixedArrays | kCurrent;

/// Groups that glEnable and glDisable of this capability change.
uint32_t groupsOfCapability(GLenum capability);
/// Groups that glPopAttrib may change.
constexpr uint32_t kAttribGroups = kAllGroups & ~uint32_t{kArrays | kProjection};

struct RasterState {
  GLuint program = 0;                    // current shader program
  Reason reason = Reason::traced;        // why no surface can be traced, or `traced`
  Reason unlessOpaque = Reason::traced;  // why surfaces whose alpha is not 1 cannot be traced, or `traced`
  // `reason`, if all fog and the functions GREATER and GEQUAL were traced.
  Reason butDepthFunc = Reason::depthFunc;
  scene::ColorWrites colorWrites;  // channels that glColorMask and blending let draws write
  GLenum depthFunc = GL_LESS;
  /// Whether larger depths are nearer.
  bool isReversed() const { return depthFunc == GL_GREATER || depthFunc == GL_GEQUAL; }
  bool depthsFromZero = false;  // clip depths range from 0 to 1 (glClipControl)
  bool writesDepth = true;
  bool orderFree = false;  // rasterised draws merge with pending traced ones in any order
  /// For surfaces that blend or do not write depth: how they are blended, if they can be traced as layers in
  /// drawing order.
  std::optional<scene::Blending> layers;
  bool firstVertexProvokes = false;  // matters for flat shading
  bool multisample = true;
  scene::AlphaTest alphaTest;
  scene::CullFace cull = scene::CullFace::none;
  bool frontFaceCcw = true;
  bool offsetFill = false;
  float offsetFactor = 0, offsetUnits = 0;
  /// Whether filled polygons have an offset that increases depths.
  bool increasesDepthOfFills() const {
    return offsetFill && scene::PolygonOffset{.factor = offsetFactor, .units = offsetUnits}.pushesBack();
  }
};

/// The framebuffer that draws go to.
struct TargetState {
  Reason reason = Reason::traced;
  GLuint framebuffer = 0;
  GLenum drawBuffer = GL_BACK;
  int samples = 1;
  glm::ivec2 size{0};  // pixels, for a framebuffer object; {0, 0}: unknown
  std::vector<glm::vec2> samplePositions;
  bool wideColors = false;  // colours are floats
  bool eightBits = false;   // 8 of red, green, blue and, if `alpha`, alpha
  bool alpha = true;
  // Colours are of 8 bits or floats of 16 or 32, one draw buffer, one sample per pixel, not `encodes`.
  bool blendable = false;
  bool halfFloats = false;  // of wideColors that are blendable: 16 bits a channel
  double depthSteps = 0;    // from depth 0 to 1; 0: depth is floats
  /// depthSteps, if there are so few that surfaces behind each other may have equal depths; else 0.
  double coarseDepthSteps() const {
    constexpr double kMost = 65535;  // 16 bits
    return depthSteps <= kMost ? depthSteps : 0;
  }
  bool encodes = false;  // GL_FRAMEBUFFER_SRGB: colours may be encoded when written
  float depthResolution = 1.0f / 16777216.0f;
  // Unit of glPolygonOffset. If depthFloats, the unit is the last bit of the depth instead.
  float offsetUnit = 1.0f / 8388608.0f;
  bool depthFloats = false;
  // Not read back: number of the context in this process, and its drawable (window, pbuffer or pixmap).
  uint64_t context = 0;
  uintptr_t drawable = 0;
};

struct ViewportState {
  glm::ivec4 box{0, 0, 1, 1};      // x, y, width, height
  glm::ivec4 scissor{0, 0, 1, 1};  // x, y, width, height
  bool scissorTest = false;
  float depthNear = 0, depthFar = 1;
  /// The pixels that polygons may cover, in a framebuffer of at most 16,384 pixels a side. Its size is not
  /// negative.
  scene::Region region() const;
};

/// State that decides which pixels a draw may change, and how. Refers to the state that it was made from.
struct PixelState {
  const TargetState& target;
  const RasterState& raster;
  const ViewportState& viewport;
};

/// Reads GL_MODELVIEW_MATRIX or GL_PROJECTION_MATRIX.
glm::dmat4 readMatrix(const RealGl& real, GLenum name);
void readViewport(const RealGl& real, ViewportState& viewport);
/// Reads per-fragment and polygon state. `fog` is read if `has` says that there is fixed function.
void readRaster(const RealGl& real, const RareState& has, RasterState& raster, scene::Fog& fog);
/// Reads all of `shading` but fog, textures and alpha test.
void readLighting(const RealGl& real, const RareState& has, scene::Shading& shading);
/// Which materials follow the current colour, whether there is lighting or not.
scene::ColorMaterial readColorMaterial(const RealGl& real);
void readMaterial(const RealGl& real, scene::MaterialPair& material);
/// Reads light `name`, on or off.
scene::Light readLight(const RealGl& real, GLenum name);
/// Reads the enabled clip planes, in eye space.
std::vector<glm::dvec4> readClipPlanes(const RealGl& real);
void readTarget(const RealGl& real, const RareState& has, AttachedImages& images, TargetState& target);

}  // namespace gluray::gl
