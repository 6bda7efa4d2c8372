// Beads, tubes and splats (scene/impostors.h): points and lines with a width in pixels that a fragment
// program shades as round, and ellipses. Coverage, normals and depths equal the program's. accel/ intersects
// them, render/ shades them. Any thread.
#pragma once
#include "accel/impostors/placed_impostors.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace gluray::accel {

/// Twice the signed area of the triangle from the origin to `a` and `b`; positive where `b` is left of `a`.
inline double turn(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// Bounding rectangle of a packet's window positions.
struct WindowRectangle {
  float left = 0, right = 0, lower = 0, upper = 0;
  WindowRectangle() = default;
  explicit WindowRectangle(const PixelRays&);
};

/// A bead is a square about a point, cut to a disc. A tube is a parallelogram about a line: its long sides
/// are offset along the line's normal in normalised device coordinates; if the line is shorter than the tube
/// is wide, each end moves outwards by a quarter of the difference. Tubes `inPixels` are measured in the
/// window instead. Lines may reach behind the viewer.
class PixelImpostor {
 public:
  PixelImpostor(const PlacedImpostors&, uint32_t primitive);

  /// The program's results at one pixel.
  struct Shown {
    double depth = 0;     // window, [0, 1]
    double along = 0;     // of a tube: position on the line, 0 at its first end, 1 at its second
    glm::vec3 normal{0};  // unit, lighting space; splats: towards the viewer
    float fade = 1;       // of splats: factor of the colour
    float alpha = 1;      // of splats: factor of the opacity
  };
  /// Whether its billboard covers a window position. Corners snap to 1/256 pixel, as in rasterisers;
  /// positions exactly on the left or lower side are covered.
  bool covers(const glm::dvec2& at) const;
  /// Must be called before covers().
  void prepare() {
    const bool square = placed_.look.fillsBillboard() && placed_.mesh->shape == scene::Shape::splats;
    if (wholly_ && exists_ && (square || placed_.mesh->shape == scene::Shape::tubes)) makeSides();
  }
  /// The subset of `lanes` whose positions the billboard may cover; conservative and tight.
  uint32_t nearby(const PixelRays&, uint32_t lanes) const;
  /// Computes the program's results at a window position on or near the billboard; false if it discards.
  bool show(const glm::dvec2& at, Shown& shown) const;

 private:
  bool showSplat(const glm::dvec2& at, Shown& shown) const;

  void makeBead(uint32_t vertex);
  void makeSplat(uint32_t vertex);
  void makeSquare(const glm::vec3& center, float radius);
  void makeTube();
  void makeTubeInPixels(const glm::dvec2& first, const glm::dvec2& second);
  /// Sets across_ for a line that runs so in the window, and returns its direction.
  glm::dvec2 turnAcross(const glm::dvec2& pixels);
  void makeBehindViewer();
  void makeSides();
  bool coversBead(const glm::dvec2& at) const;
  /// A position on a tube's billboard.
  struct OnBillboard {
    double along, side, ndc;  // `side`: 1 on one long side, -1 on the other
    bool inside;
  };
  OnBillboard onBillboard(const glm::dvec2& at) const;
  OnBillboard onHalf(const glm::dvec2& at) const;
  double depthOf(double ndc, double round) const;
  bool isCutAway(double along) const;
  glm::vec3 outwards() const;

  const PlacedImpostors& placed_;
  bool exists_ = false, wholly_ = true;  // wholly_: entirely in front of the viewer
  uint32_t vertex_[2];
  WindowVertex end_[2];
  double pixels_ = 1;      // of beads
  glm::dmat2 inverse_{1};  // of splats: of C, in pixels
  // Tubes in front of the viewer, and splats that fill their billboards: parallelograms of corner_ +
  // along*along_ + aside*aside_.
  glm::dvec2 corner_{0}, along_{0}, aside_{0};
  struct Side {
    double x, y, dx, dy;  // 1/256 pixel
    bool owned;           // positions exactly on it are covered
  } side_[4];
  // Other tubes: two triangles in clip space, of corners 0 1 2 and 1 2 3; 0 and 1 are at the line's first
  // end.
  glm::dmat3 half_[2];  // from (window x, window y, 1) to corner weights, whose sum weighted by w is 1
  bool hasHalf_[2];
  double z_[4];                    // clip space, of the corners
  glm::dvec2 across_{0};           // the line's normal, NDC
  mutable glm::vec3 outwards_{0};  // towards the viewer, lighting space; computed on demand
  mutable bool hasOutwards_ = false;
};

/// Returns which of `lanes` hit the impostor and sets t of their pixels' rays. `around` bounds the samples.
uint32_t meet(const PlacedImpostors&, uint32_t primitive, const ImpostorQuery&, const WindowRectangle& around,
              uint32_t lanes, float (&t)[kLanes]);

/// Window positions of the vertices of beads, tubes or splats.
std::vector<WindowVertex> windowVertices(const PlacedImpostors&);

}  // namespace gluray::accel
