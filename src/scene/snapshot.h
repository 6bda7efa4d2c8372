// Everything one flush needs, frozen. The GL thread builds it, then gives it away: no lock guards it because
// nobody can write to it. Unchanged meshes are shared with earlier snapshots.
#pragma once
#include "scene/blending.h"
#include "scene/impostors.h"
#include "scene/mesh.h"
#include "scene/shading.h"
#include "settings/settings.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace gluray::scene {

enum class CullFace : uint8_t { none, front, back, both };

/// glPolygonOffset of a batch: window depth is moved by factor*m + units*r (GL 2.1, 3.5.5), m the larger of
/// the slopes along x and y, or the length of both where a fragment program offsets itself. r is
/// `resolution`, or in a depth buffer of floats the last digit of a triangle's largest depth z: 2^(exponent
/// of z - 23).
struct PolygonOffset {
  float factor = 0, units = 0;
  float resolution = 1.0f / 16777216.0f;
  bool euclidean = false, floats = false;
  /// Whether it moves everything away from the viewer, if anything.
  bool pushesBack() const { return factor >= 0 && units >= 0 && factor + units > 0; }
  bool operator==(const PolygonOffset&) const = default;
};

/// How eye space reaches the window. Rays come from the inverse, so that every projection is one code path.
struct Camera {
  glm::dmat4 clipFromEye{1};
  glm::ivec4 viewport{0, 0, 1, 1};    // x, y, width, height
  float depthNear = 0, depthFar = 1;  // glDepthRange
  // Height of a framebuffer whose rows the real OpenGL counts from the top, 0 where it counts from the
  // bottom: decides which pixels form the 2x2 quads that texture coordinates are differentiated over.
  int rowsFromTop = 0;
  bool operator==(const Camera&) const = default;
};

/// The rectangle of pixels to trace: viewport, scissor and framebuffer intersected. Never empty in a
/// snapshot.
struct Region {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const Region&) const = default;
};

/// Channels of the framebuffer's colours that are written; the others keep what is there.
struct ColorWrites {
  bool red = true, green = true, blue = true, alpha = true;
  bool all() const { return red && green && blue && alpha; }
  bool operator==(const ColorWrites&) const = default;
};

/// A mesh placed in the scene, with the state it was drawn with.
/// "World" is the object space of the snapshot's first instance, so that moving the camera changes
/// eyeFromWorld alone.
struct Instance {
  MeshPtr mesh;
  glm::dmat4 eyeFromObject{1};  // the modelview matrix of the draw
  glm::mat4 worldFromObject{
      1};                // exactly the identity where eyeFromObject equals the snapshot's eyeFromWorld
  uint32_t shading = 0;  // index into Snapshot::shadings
  uint32_t order = 0;    // instances with higher numbers were drawn later
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
  // What fragment programs are given beside (Shading::fragment).
  glm::mat4 lightingFromObject{1};  // the program's eye space
  glm::mat3 normalMatrix{1};        // the program's own, for the mesh's normals and those a triangle
  Attribute triangleColors;         // float4 or unorm8x4: triangle t has element triangleOffset + t
  Attribute triangleNormals;        // float3 or float4, object space
  Attribute triangleEdges;          // bits8: bit k, the edge from corner k to the next is painted
  uint32_t triangleOffset = 0;
  Impostors impostors;  // of meshes of other shapes than triangles
  CullFace cull = CullFace::none;
  bool frontFaceCcw = true;  // GL_CCW is front
  std::vector<glm::dvec4>
      clipPlanes;  // eye space; a point p is kept where dot(plane, p) >= 0 for every plane
  bool operator==(const Instance&) const = default;
};

/// Surfaces that are seen through: all along a ray count.
struct Layers {
  enum class Of : uint8_t {
    /// From the front backwards: a pixel becomes the sum of their colours, each times its opacity and what
    /// those before it let through; its alpha is the opacity of all.
    order,
    /// Whatever their order: sums of what each is, for the program to make a colour of
    /// (Image::kSums).
    sums,
    /// In the order of drawing, as OpenGL blends them: each fragment that passes the depth test changes the
    /// colour that is there and, where depth is written, the depth that those after it are tested against.
    drawn,
  };
  Of of = Of::order;
  /// Window depth of what is opaque, one a pixel of the region, lowest row first: what lies behind it does
  /// not count. Negative: there is nothing opaque. Of `drawn`: the framebuffer's depth, before them.
  std::vector<float> opaqueDepth;
  /// In order, surfaces whose depths differ by no more are at one place: of what each would make of the
  /// pixel, every channel keeps the largest.
  float tolerance = 1e-7f;
  /// In order: 0, or after how many dual depth peels the program blends what is left in the order of drawing.
  /// Each peel takes a pixel's nearest layer and its farthest; the first one finds what is opaque in the
  /// place of the farthest.
  uint32_t peels = 0;
  // Of `drawn` alone.
  std::vector<uint32_t> colors;  // the framebuffer's, before them: RGBA8, one a pixel, like opaqueDepth
  Blending blending;
  double depthSteps = 0;  // from depth 0 to 1, as the framebuffer keeps it; 0: floats
  bool operator==(const Layers&) const = default;
};

/// One batch: what is traced in one go and written to one framebuffer.
struct Snapshot {
  uint64_t frame = 0;  // counts the program's frames, from 1
  Camera camera;
  glm::dmat4 eyeFromWorld{1};
  Region region;                           // window pixels to trace
  int samples = 1;                         // of the framebuffer
  std::vector<glm::vec2> samplePositions;  // in [0,1)^2 from the pixel's lower left corner, `samples` of them
  PolygonOffset polygonOffset;
  std::shared_ptr<const Layers> layers;  // null: the nearest surface alone is seen. One sample a pixel
  bool wideColors = false;               // colours are handed over as floats, and not cut off at 0 and 1
  bool encodes =
      false;  // GL_FRAMEBUFFER_SRGB was on; then colours are wide, and the real OpenGL encodes them
  ColorWrites colorWrites;  // of where the picture goes; used for tracing layers of kind `drawn` alone
  bool laterWins = false;   // GL_LEQUAL: of surfaces at one place the last drawn is seen; otherwise the first
  std::vector<Shading> shadings;
  std::vector<Instance> instances;
  Settings settings;
};
using SnapshotPtr = std::shared_ptr<const Snapshot>;

}  // namespace gluray::scene
