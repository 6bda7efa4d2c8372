// Spheres, discs and cylinders of fragment programs (scene/impostors.h): bounding boxes for the BLAS and ray
// intersection. Any thread.
#pragma once
#include "accel/impostors/impostor_reach.h"
#include "accel/rays/ray_packet.h"
#include "base/hash.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::accel {

struct Box {
  glm::vec3 lower, upper;
};
/// The bounding box of impostor `primitive`, object space; lower > upper where it does not exist.
Box boundsOfImpostor(const scene::Mesh&, const ImpostorReach&, uint32_t primitive);

/// A vertex in the window, in the precision of shader programs.
struct WindowVertex {
  float x = 0, y = 0;  // pixels
  float ndc = 0;       // depth
  float w = -1;        // clip space; unless positive, x, y and ndc are undefined
};

/// The impostors of one instance, prepared for the rays of a snapshot.
struct PlacedImpostors {
  scene::MeshPtr mesh;  // null: triangles
  scene::Impostors look;
  glm::mat4 lightingFromObject{1}, lightingFromEye{1};
  // For impostors with a size in pixels: the mapping to the window.
  glm::dmat4 clipFromObject{1};
  glm::dvec4 clipZ{0}, clipW{0};              // rows of clipFromEye
  glm::dvec2 windowCenter{0}, windowHalf{1};  // of the viewport, pixels
  double depthScale = 0.5, depthOffset = 0.5;
  double halfWidthPerW = 0;  // of sizes in pixels: half their width in lighting space, by clip-space w
  glm::vec4 objectW{0}, objectNear{0};  // of object space: clip-space w, and the distance from the near plane
  glm::vec4 viewer{0};                  // homogeneous, lighting space
  glm::vec4 lightingNear{0};  // of hemispheres: the near plane in lighting space, positive where it shows
  // Of balls and capsules: bounds in object space. Radius: dot(objectRadius, (position, 1)), what rounding
  // adds to it, and for each unit of coordinates.
  glm::vec4 objectRadius{0};
  float objectError = 0, objectRounding = 0;
  std::vector<WindowVertex> window;  // per vertex
  PlacedImpostors() = default;
  PlacedImpostors(const scene::Instance&, const scene::Camera&);

 private:
  void boundRadius();
};

/// The ball of a sphere, in lighting space.
struct Ball {
  glm::vec3 center;
  float radius;
  /// False if the sphere does not exist.
  static bool make(const PlacedImpostors&, uint32_t primitive, Ball&);
};

/// One impostor, in lighting space.
struct Impostor {
  scene::Shape shape;
  scene::Impostors::Billboards billboards;
  bool parallelView, inside, hemisphere, gaussian;
  glm::vec3 center;
  float radius, cardRadius;
  glm::vec2 square{0};      // Billboards::square: half of its width and height
  glm::vec3 toViewer;       // unit: the billboard's normal
  glm::vec3 right, up;      // unit: the billboard's axes; of cylinders: across, and towards the box's back
  glm::vec3 axis{0, 0, 1};  // unit
  float halfLength = 0;
  /// False if the impostor does not exist.
  static bool make(const PlacedImpostors&, uint32_t primitive, Impostor&);
};

/// A packet's pixel rays in one instance's lighting space.
struct alignas(64) ImpostorRays {
  float org[3][kLanes], dir[3][kLanes];
  float inverseLength[kLanes];  // of dir
  float eye[kLanes];            // t at the viewer
  float tFar[kLanes];
};
void toLighting(const PlacedImpostors&, const PixelRays&, ImpostorRays&);

/// Returns which of `lanes` (bit i: lane i) hit the impostor, and sets their t >= 0. Hits behind the viewer
/// get the ray's far end, because programs' depths are clamped. `samples`: the rays that must hit the
/// billboard; may be `rays` itself.
uint32_t meet(const Impostor&, const ImpostorRays& rays, const ImpostorRays& samples, uint32_t lanes,
              float (&t)[kLanes]);

}  // namespace gluray::accel
