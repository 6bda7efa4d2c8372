// All data of one flush, frozen. The GL thread builds it and hands it over; it is immutable and needs no
// lock. Unchanged meshes are shared with earlier snapshots.
#pragma once
#include "scene/blending.h"
#include "scene/impostors.h"
#include "scene/light_sampling.h"
#include "scene/mesh.h"
#include "scene/region.h"
#include "scene/shading.h"
#include "scene/volumes/placed_volume.h"
#include "settings/settings.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace gluray::scene {

enum class CullFace : uint8_t { none, front, back, both };

/// glPolygonOffset of a batch: adds factor*m + units*r to the window depth (GL 2.1, 3.5.5). m is the larger
/// of the depth slopes along x and y; `euclidean`: the length of both, for fragment programs that compute the
/// offset. r is `resolution`; `floats`: for a float depth buffer, 2^(exponent of z - 23) with a triangle's
/// largest depth z.
struct PolygonOffset {
  float factor = 0, units = 0;
  float resolution = 1.0f / 16777216.0f;
  bool euclidean = false, floats = false;
  /// Whether it moves every surface away from the viewer.
  bool pushesBack() const { return factor >= 0 && units >= 0 && factor + units > 0; }
  bool operator==(const PolygonOffset&) const = default;
};

/// The transform from eye space to the window. Rays come from its inverse, whatever the projection.
struct Camera {
  glm::dmat4 clipFromEye{1};
  glm::ivec4 viewport{0, 0, 1, 1};    // x, y, width, height
  float depthNear = 0, depthFar = 1;  // glDepthRange
  // Height of a framebuffer whose rows the real OpenGL counts from the top, 0 if it counts from the bottom:
  // determines the 2x2 pixel quads over which texture coordinates are differentiated.
  int rowsFromTop = 0;
  // GL_GREATER, GL_GEQUAL: of two surfaces the one with the larger window depth is visible.
  bool largestWins = false;
  bool depthsFromZero =
      false;  // draws had clip depths from 0 to 1 (glClipControl); clipFromEye has the usual
  /// NDC depth of the plane before all others in the order of the depth test: rays start there.
  double firstNdcDepth() const { return (depthNear <= depthFar) != largestWins ? -1.0 : 1.0; }
  bool operator==(const Camera&) const = default;
};

/// Colour channels of the framebuffer that are written; the others keep their values.
struct ColorWrites {
  bool red = true, green = true, blue = true, alpha = true;
  bool all() const { return red && green && blue && alpha; }
  bool operator==(const ColorWrites&) const = default;
};

/// Number of the program's object that the instance belongs to (gl/objects), from 1; 0: unknown. Ignored in
/// comparisons of instances, because rules by object are settings.
struct ObjectNumber {
  uint32_t value = 0;
  bool operator==(const ObjectNumber&) const { return true; }
};

/// A mesh placed in the scene, with the state it was drawn with. "World" is the object space of the
/// snapshot's first instance, so that a camera move changes only eyeFromWorld.
struct Instance {
  MeshPtr mesh;
  glm::dmat4 eyeFromObject{1};   // the modelview matrix of the draw
  glm::mat4 worldFromObject{1};  // exactly the identity if eyeFromObject equals the snapshot's eyeFromWorld
  uint32_t shading = 0;          // index into Snapshot::shadings
  uint32_t order = 0;            // instances with higher numbers were drawn later
  ObjectNumber object;
  // Values of attributes that the mesh does not carry.
  glm::vec4 color{1};
  glm::vec3 normal{0, 0, 1};
  glm::vec3 secondaryColor{0};
  float fogCoord = 0;
  glm::vec4 texcoord{0, 0, 0, 1};         // of texture unit 0
  std::vector<glm::vec4> texcoordsAbove;  // of units 1, 2 ...; may be shorter
  glm::vec4 texcoordOf(uint32_t unit) const {
    if (unit == 0) return texcoord;
    return unit <= texcoordsAbove.size() ? texcoordsAbove[unit - 1] : glm::vec4(0, 0, 0, 1);
  }
  std::vector<MaterialPair>
      materials;  // indexed by the mesh's materials attribute; [0] where it has none. Never empty
  // Further inputs of fragment shaders (Shading::fragment).
  glm::mat4 lightingFromObject{1};  // the program's eye space
  glm::mat3 normalMatrix{1};        // the program's own, for normals per vertex and per triangle
  Attribute triangleColors;         // float4 or unorm8x4: triangle t has element triangleOffset + t
  Attribute triangleNormals;        // float3 or float4, object space
  Attribute triangleEdges;          // bits8: bit k: paint the edge from corner k to the next; none: all
  uint32_t triangleOffset = 0;
  Impostors impostors;  // unless the mesh's shape is triangles
  CullFace cull = CullFace::none;
  bool frontFaceCcw = true;            // GL_CCW is front
  std::vector<glm::dvec4> clipPlanes;  // eye space; keeps points p with dot(plane, p) >= 0 for every plane
  bool ground = false;                 // added by the setting `ground`; not part of the scene's bounds
  bool operator==(const Instance&) const = default;
};

/// Transparent surfaces: every hit along a ray contributes.
struct Layers {
  enum class Of : uint8_t {
    /// Front to back ("over"): a pixel is the sum of the layers' colours, each times its opacity and the
    /// transmittance of the layers before it; its alpha is the total opacity.
    order,
    /// Independent of order: weighted sums, of which the program computes a colour (Image::kSums).
    sums,
    /// In the order of drawing, with OpenGL's blending: each fragment that passes the depth test changes the
    /// colour and, if it writes depth, the depth that later fragments are tested against.
    drawn,
  };
  Of of = Of::order;
  /// Window depth of the opaque surfaces, one per pixel of the region, bottom row first; layers behind it are
  /// hidden. Negative: nothing opaque. For `drawn`: the framebuffer's initial depth.
  std::vector<float> opaqueDepth;
  /// For `order`: surfaces whose depths differ by at most this form one layer; each channel of the pixel
  /// takes the largest of the values that they would yield.
  float tolerance = 1e-7f;
  /// For `order`: number of dual depth peels after which the program blends the remaining layers in the order
  /// of drawing; 0: no limit. Each peel takes a pixel's nearest and farthest layer; the first one takes the
  /// opaque surface in place of the farthest.
  uint32_t peels = 0;
  // For `drawn` only.
  // The framebuffer's initial colours, in the order of opaqueDepth: RGBA8 or, of snapshots with wideColors,
  // floats, which blending does not clamp.
  std::vector<uint32_t> colors;
  std::vector<glm::vec4> floatColors;
  bool halfFloats = false;  // of floatColors: the framebuffer keeps 16 bits of each
  Blending blending;
  double depthSteps = 0;  // steps of the framebuffer's depth between 0 and 1; 0: float depth
  bool operator==(const Layers&) const = default;
};

/// Use of the ground in a batch (setting `ground`).
enum class GroundUse : uint8_t {
  none,
  around,  // the ground blocks and reflects the batch's light; another batch of the view draws it
  drawn,
};

struct Backdrop;
struct SecondaryScene;

/// One batch, which is traced together and written to one framebuffer.
struct Snapshot {
  uint64_t frame = 0;  // counts the context's frames, from 1
  uint64_t view = 0;   // equal in all snapshots that show the same part of the same framebuffer
  // Counts the view's frames, also without swaps: a frame begins with the first tracing after its colours
  // were cleared. 0: no light effects.
  uint64_t viewFrame = 0;
  uint64_t swaps = 0;   // buffer swaps of the context so far; 0 in programs that never swap
  uint64_t number = 0;  // number of the snapshot in the process; equal for all its passes
  LightSampling lightSampling;
  Camera camera;
  glm::dmat4 eyeFromWorld{1};
  Region region;                           // window pixels to trace
  int samples = 1;                         // of the framebuffer
  std::vector<glm::vec2> samplePositions;  // in [0,1)^2 from the pixel's lower left corner, `samples` of them
  PolygonOffset polygonOffset;
  // Steps of a coarse depth buffer between depths 0 and 1: surfaces in one step are equally deep, as in
  // OpenGL. 0: depths are compared exactly. Batches without layers only.
  double depthSteps = 0;
  std::shared_ptr<const Layers> layers;  // null: only the nearest surface is visible. One sample per pixel
  bool wideColors = false;               // colours are returned as floats, not clamped to [0, 1]
  // With wide colours: averages of several samples are those of samples rounded to bytes, as in a framebuffer
  // of bytes, but are not rounded themselves.
  bool byteSamples = false;
  // With wide colours: samples are limited to [0, 1] before they are averaged, as in a framebuffer of bytes.
  // Not sent to workers, which make no pictures for files.
  bool limitedSamples = false;
  bool encodes =
      false;  // GL_FRAMEBUFFER_SRGB was on; then colours are wide, and the real OpenGL encodes them
  ColorWrites colorWrites;  // of the destination framebuffer; tracing uses it only for Layers::Of::drawn
  bool laterWins = false;  // GL_LEQUAL: of coincident surfaces the last drawn is visible; otherwise the first
  std::vector<Shading> shadings;
  std::vector<Instance> instances;
  std::vector<PlacedVolume> volumes;  // drawn in place of instances, of which there are none then
  std::shared_ptr<const SecondaryScene> secondaryScene;  // null: no other surfaces block or reflect light
  // Diagonal of the scene's bounds in eye space, where the program leaves out parts of the scene that are out
  // of view; 0: the surfaces above are the whole scene.
  float extent = 0;
  GroundUse ground = GroundUse::none;
  // The surfaces are already in the framebuffer. The image is black, with the fraction of blocked light as
  // opacity; empty without light effects.
  bool catches = false;
  std::shared_ptr<const Backdrop> backdrop;  // null: pixels of misses keep the framebuffer's content
  Settings settings;
};
using SnapshotPtr = std::shared_ptr<const Snapshot>;

/// Whether it has a ground or a background of the settings.
inline bool hasScenery(const Snapshot& s) { return s.ground != GroundUse::none || s.backdrop; }
/// Whether its image shows the ground or the background.
inline bool showsScenery(const Snapshot& s) { return s.ground == GroundUse::drawn || s.backdrop; }

}  // namespace gluray::scene
