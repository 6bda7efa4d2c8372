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

/// How far the figures of an instance reach from their centres in object space. Rounded up so that it stays
/// the same while the camera moves, which changes the matrices by roundings.
struct FigureReach {
  glm::vec3 perRadius{0};  // along each axis, for a radius of 1
  glm::mat3 alongAxis{0};  // half a cylinder's axis in object space is this times half of Mesh::axes
  glm::vec3 perLength{0};  // what rounding may have taken from that, for a length of 1
  glm::vec3 further{0};    // whatever the radius
  bool operator==(const FigureReach&) const = default;
  static FigureReach of(const scene::Instance&, const scene::Camera&);
};

/// The next power of 2^(1/64), so that a few roundings more or less seldom make a difference.
float roundedUp(double length);

/// Lower and upper corner of figure `primitive`; lower > upper where it does not exist.
struct Box {
  glm::vec3 lower, upper;
};
Box boundsOfFigure(const scene::Mesh&, const FigureReach&, uint32_t primitive);

/// A vertex in the window, in the precision that programs have.
struct WindowVertex {
  float x = 0, y = 0;  // pixels
  float ndc = 0;       // depth
  float w = -1;        // clip space; where it is not positive the others mean nothing
};

/// The figures of one instance as rays of a snapshot meet them.
struct PlacedFigures {
  scene::MeshPtr mesh;  // null: triangles
  scene::Figures look;
  glm::mat4 lightingFromObject{1}, lightingFromEye{1};
  // Of figures whose size is in pixels: the window.
  glm::dmat4 clipFromObject{1};
  glm::dvec4 clipZ{0}, clipW{0};              // rows of clipFromEye
  glm::dvec2 windowCenter{0}, windowHalf{1};  // of the viewport, pixels
  double depthScale = 0.5, depthOffset = 0.5;
  std::vector<WindowVertex> window;  // by vertex
  PlacedFigures() = default;
  PlacedFigures(const scene::Instance&, const scene::Camera&);
};

/// One of them, in the lighting space.
struct Figure {
  scene::Shape shape;
  scene::Figures::Cards cards;
  bool parallelView, inside;
  glm::vec3 center;
  float radius, cardRadius;
  glm::vec3 toViewer;       // unit: the card's normal
  glm::vec3 right, up;      // unit: the card's axes; of cylinders across and towards the back of the box
  glm::vec3 axis{0, 0, 1};  // unit
  float halfLength = 0;
  /// False where the figure is not there.
  static bool make(const PlacedFigures&, uint32_t primitive, Figure&);
};

/// A packet's pixel rays in the lighting space of one instance.
struct alignas(64) FigureRays {
  float org[3][kLanes], dir[3][kLanes];
  float inverseLength[kLanes];  // of dir
  float eye[kLanes];            // t where the ray passes the viewer
  float tFar[kLanes];
};
void toLighting(const PlacedFigures&, const PixelRays&, FigureRays&);

/// Which of `lanes` (bit i: lane i) meet the figure, and where: t, not before 0. What lies behind the viewer
/// is at the far end, as programs' depths are cut to what there is. `samples`: the rays that must meet the
/// card, which may be `rays` themselves.
uint32_t meet(const Figure&, const FigureRays& rays, const FigureRays& samples, uint32_t lanes,
              float (&t)[kLanes]);

}  // namespace gluray::accel
