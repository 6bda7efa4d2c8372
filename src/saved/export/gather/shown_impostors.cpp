#include "saved/export/gather/shown_impostors.h"

#include "accel/impostors/capsule.h"
#include "accel/impostors/placed_impostors.h"
#include "accel/impostors/stick.h"

#include <cmath>

namespace gluray::saved {
namespace {

using accel::PlacedImpostors;
using scene::Shape;

class Shapes {
 public:
  Shapes(const PlacedImpostors& placed, Notes& notes) : placed_(placed), notes_(notes) {}
  std::vector<RoundShape> all;

  void add(uint32_t primitive, const glm::vec4& first, const glm::vec4& last) {
    switch (placed_.mesh->shape) {
      case Shape::sticks: return addStick(primitive, first, last);
      case Shape::balls:
      case Shape::capsules: return addCapsule(primitive, first, last);
      default: return addImpostor(primitive, first);
    }
  }

 private:
  void ball(const glm::vec3& center, float radius, const glm::vec4& color) {
    push({RoundForm::ball, {center, center}, {radius, radius}, {color, color}});
  }
  void push(const RoundShape& s) {
    const glm::vec3 sum = s.end[0] + s.end[1];
    if (std::isfinite(sum.x + sum.y + sum.z) && s.radius[0] > 0 && std::isfinite(s.radius[0] + s.radius[1]))
      all.push_back(s);
  }

  void addImpostor(uint32_t primitive, const glm::vec4& color) {
    accel::Impostor f;
    if (!accel::Impostor::make(placed_, primitive, f)) return;
    if (placed_.mesh->shape == Shape::spheres) {
      if (f.hemisphere) notes_.insert("half spheres that face the viewer were written as whole spheres");
      return ball(f.center, f.radius, color);
    }
    if (placed_.mesh->shape == Shape::discs) {
      notes_.insert("discs that turn with the viewer were written as they face the viewer of this frame");
      return push({RoundForm::disc, {f.center, f.center + f.toViewer}, {f.radius, f.radius}, {color, color}});
    }
    const glm::vec3 half = f.halfLength * f.axis;
    push({RoundForm::closedTube, {f.center - half, f.center + half}, {f.radius, f.radius}, {color, color}});
  }

  void addStick(uint32_t primitive, const glm::vec4& first, const glm::vec4& last) {
    accel::Stick s;
    if (!accel::Stick::make(placed_, primitive, s)) return;
    using End = accel::Stick::End;
    const bool closed[2] = {s.ends[0] == End::flat, s.ends[1] == End::flat};
    const auto tube = [&](const glm::vec3& a, const glm::vec3& b, bool atA, bool atB, const glm::vec4& colorA,
                          const glm::vec4& colorB) {
      const RoundForm form = atA ? (atB ? RoundForm::closedTube : RoundForm::closedAtFirst)
                                 : (atB ? RoundForm::closedAtSecond : RoundForm::openTube);
      push({form, {a, b}, {s.radius, s.radius}, {colorA, colorB}});
    };
    if (s.halves && first != last) {
      tube(s.end[0], s.middle(), closed[0], false, first, first);
      tube(s.middle(), s.end[1], false, closed[1], last, last);
    } else {
      tube(s.end[0], s.end[1], closed[0], closed[1], first, last);
    }
    for (int k = 0; k < 2; ++k)
      if (s.ends[k] == End::round) ball(s.end[k], s.radius, k == 0 ? first : last);
  }

  void addCapsule(uint32_t primitive, const glm::vec4& first, const glm::vec4& last) {
    accel::Capsule c;
    if (!accel::Capsule::make(placed_, primitive, c)) return;
    const glm::vec4 color[2] = {glm::mix(first, last, c.share[0]), glm::mix(first, last, c.share[1])};
    ball(c.end[0], c.radius[0], color[0]);
    if (c.isBall()) return;
    ball(c.end[1], c.radius[1], color[1]);
    RoundShape side{RoundForm::openTube, {}, {}, {color[0], color[1]}};
    const float cosine = std::sqrt(std::max(0.0f, 1 - c.sine * c.sine));
    for (int k = 0; k < 2; ++k) {  // the circles where the cone touches the balls
      side.end[k] = c.end[k] + c.axis * (c.radius[k] * c.sine);
      side.radius[k] = c.radius[k] * cosine;
    }
    push(side);
  }

  const PlacedImpostors& placed_;
  Notes& notes_;
};

}  // namespace

std::vector<RoundShape> shapesOf(const scene::Instance& instance, const scene::Camera& camera,
                                 const ShownColors& colors, bool flat, Notes& notes) {
  const PlacedImpostors placed(instance, camera);
  const scene::Mesh& mesh = *instance.mesh;
  const scene::Impostors& look = instance.impostors;
  if (look.fades || look.gaussian) notes.insert("impostors that fade towards their rims were written whole");
  Shapes shapes(placed, notes);
  shapes.all.reserve(mesh.triangleCount);
  for (uint32_t p = 0; p < mesh.triangleCount; ++p) {
    const glm::vec4 last = colors.at(mesh.corner(p, 2));
    shapes.add(p, flat ? last : colors.at(mesh.corner(p, 0)), last);
  }
  return std::move(shapes.all);
}

}  // namespace gluray::saved
