// Beads, tubes and splats (scene/impostors.h) in the window: points and lines so many pixels wide, of which a
// fragment program makes something round, and ellipses. What they cover, and what light and depth are
// computed from, are as the program has them. Any thread; used by accel/ to find them and by render/ to show
// them.
#pragma once
#include "accel/impostors/impostors.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace gluray::accel {

/// About a packet's positions in the window.
struct WindowRectangle {
  float left = 0, right = 0, lower = 0, upper = 0;
  WindowRectangle() = default;
  explicit WindowRectangle(const PixelRays&);
};

/// A bead is the square about a point, cut to a disc. A tube is the parallelogram about a line, whose long
/// sides are moved along the line's normal in normalised device coordinates, and whose ends, of lines shorter
/// than it is wide, are moved outwards by a quarter of what is missing. Lines may reach behind the viewer.
class PixelImpostor {
 public:
  PixelImpostor(const PlacedImpostors&, uint32_t primitive);

  /// What a pixel shows of it.
  struct Shown {
    double depth = 0;     // window, [0, 1]
    double along = 0;     // of a tube: the place on the line, 0 at its first end, 1 at its second
    glm::vec3 normal{0};  // unit, lighting space; of splats towards the viewer
    float fade = 1;       // of splats: see scene::Impostors::fades
  };
  /// Whether its billboard covers a window position. Corners are snapped to 1/256 pixel as rasterisers do,
  /// and what lies exactly on a side belongs to the left and the lower ones.
  bool covers(const glm::dvec2& at) const;
  /// Must be called before covers().
  void prepare() {
    if (wholly_ && placed_.mesh->shape == scene::Shape::tubes) makeSides();
  }
  /// Of `lanes`, those whose positions the billboard may cover: all that it does and few more.
  uint32_t nearby(const PixelRays&, uint32_t lanes) const;
  /// What the program computes at a window position on or near the billboard; false where it discards that.
  bool show(const glm::dvec2& at, Shown& shown) const;

 private:
  void makeBead(uint32_t vertex);
  void makeSplat(uint32_t vertex);
  void makeTube();
  void makeBehindViewer();
  void makeSides();
  bool coversBead(const glm::dvec2& at) const;
  /// A place on a tube's billboard.
  struct OnBillboard {
    double along, side, ndc;  // `side`: 1 on the one side, -1 on the other
    bool inside;
  };
  OnBillboard onBillboard(const glm::dvec2& at) const;
  OnBillboard onHalf(const glm::dvec2& at) const;
  double depthOf(double ndc, double round) const;
  bool isCutAway(double along) const;
  glm::vec3 outwards() const;

  const PlacedImpostors& placed_;
  bool exists_ = false, wholly_ = true;  // wholly_: before the viewer
  uint32_t vertex_[2];
  WindowVertex end_[2];
  double pixels_ = 1;      // of beads
  glm::dmat2 inverse_{1};  // of splats: of C, in pixels
  // Tubes before the viewer: parallelograms of corner_ + along*along_ + aside*aside_.
  glm::dvec2 corner_{0}, along_{0}, aside_{0};
  struct Side {
    double x, y, dx, dy;  // 1/256 pixel
    bool owned;           // what lies exactly on it
  } side_[4];
  // Others: two triangles in clip space, of corners 0 1 2 and 1 2 3; 0 and 1 are at the line's first end.
  glm::dmat3 half_[2];  // to weights of corners, whose sum with their w is 1, from (window x, window y, 1)
  bool hasHalf_[2];
  double z_[4];                    // clip space, of the corners
  glm::dvec2 across_{0};           // the line's normal, NDC
  mutable glm::vec3 outwards_{0};  // towards the viewer, lighting space; made when it is asked for
  mutable bool hasOutwards_ = false;
};

/// Which of `lanes` meet the impostor, and where: t of the pixels' rays. `around`: of the rays' samples.
uint32_t meet(const PlacedImpostors&, uint32_t primitive, const ImpostorQuery&, const WindowRectangle& around,
              uint32_t lanes, float (&t)[kLanes]);

/// Where the vertices of beads, tubes and splats are in the window, four numbers each.
std::vector<WindowVertex> windowVertices(const PlacedImpostors&);

/// How far the beads and tubes of an instance reach from their points and lines in object space, whatever the
/// camera does but come nearer.
ImpostorReach reachInPixels(const scene::Instance&, const scene::Camera&);

/// The same of splats, whose reach grows with their radius.
ImpostorReach reachOfSplats(const scene::Instance&, const scene::Camera&);

}  // namespace gluray::accel
