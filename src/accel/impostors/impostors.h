// Spheres, discs and cylinders that fragment programs make (scene/impostors.h): their bounds for acceleration
// structures, and where rays meet them. Any thread.
#pragma once
#include "accel/ray_packet.h"
#include "base/hash.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::accel {

/// How far the impostors of an instance reach from their centres in object space. Rounded up so that it stays
/// the same while the camera moves, which changes the matrices by roundings.
struct ImpostorReach {
  glm::vec3 perRadius{0};  // along each axis, for a radius of 1
  glm::mat3 alongAxis{0};  // half a cylinder's axis in object space is this times half of Mesh::axes
  glm::vec3 perLength{0};  // what rounding may have taken from that, for a length of 1
  glm::vec3 further{0};    // whatever the radius
  bool operator==(const ImpostorReach&) const = default;
  static ImpostorReach of(const scene::Instance&, const scene::Camera&);
};

/// The next power of 2^(1/64), so that a few roundings more or less seldom make a difference.
float roundedUp(double length);

/// Lower and upper corner of impostor `primitive`; lower > upper where it does not exist.
struct Box {
  glm::vec3 lower, upper;
};
Box boundsOfImpostor(const scene::Mesh&, const ImpostorReach&, uint32_t primitive);

/// A vertex in the window, in the precision that programs have.
struct WindowVertex {
  float x = 0, y = 0;  // pixels
  float ndc = 0;       // depth
  float w = -1;        // clip space; where it is not positive the others mean nothing
};

/// The impostors of one instance as rays of a snapshot meet them.
struct PlacedImpostors {
  scene::MeshPtr mesh;  // null: triangles
  scene::Impostors look;
  glm::mat4 lightingFromObject{1}, lightingFromEye{1};
  // Of impostors whose size is in pixels: the window.
  glm::dmat4 clipFromObject{1};
  glm::dvec4 clipZ{0}, clipW{0};              // rows of clipFromEye
  glm::dvec2 windowCenter{0}, windowHalf{1};  // of the viewport, pixels
  double depthScale = 0.5, depthOffset = 0.5;
  double halfWidthPerW = 0;  // of beads and tubes: half their width in lighting space, by clip-space w
  std::vector<WindowVertex> window;  // by vertex
  PlacedImpostors() = default;
  PlacedImpostors(const scene::Instance&, const scene::Camera&);
};

/// One of them, in the lighting space.
struct Impostor {
  scene::Shape shape;
  scene::Impostors::Billboards billboards;
  bool parallelView, inside;
  glm::vec3 center;
  float radius, cardRadius;
  glm::vec3 toViewer;       // unit: the billboard's normal
  glm::vec3 right, up;      // unit: the billboard's axes; of cylinders across and towards the back of the box
  glm::vec3 axis{0, 0, 1};  // unit
  float halfLength = 0;
  /// False where the impostor is not there.
  static bool make(const PlacedImpostors&, uint32_t primitive, Impostor&);
};

/// A packet's pixel rays in the lighting space of one instance.
struct alignas(64) ImpostorRays {
  float org[3][kLanes], dir[3][kLanes];
  float inverseLength[kLanes];  // of dir
  float eye[kLanes];            // t where the ray passes the viewer
  float tFar[kLanes];
};
void toLighting(const PlacedImpostors&, const PixelRays&, ImpostorRays&);

/// Which of `lanes` (bit i: lane i) meet the impostor, and where: t, not before 0. What lies behind the
/// viewer is at the far end, as programs' depths are cut to what there is. `samples`: the rays that must meet
/// the billboard, which may be `rays` themselves.
uint32_t meet(const Impostor&, const ImpostorRays& rays, const ImpostorRays& samples, uint32_t lanes,
              float (&t)[kLanes]);

}  // namespace gluray::accel
