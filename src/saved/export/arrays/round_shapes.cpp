#include "saved/export/arrays/round_shapes.h"

#include <glm/gtc/constants.hpp>

#include <cmath>
#include <limits>
#include <utility>

namespace gluray::saved {
namespace {

/// Two unit vectors across `axis`, which has unit length: with it a right-handed system.
void across(const glm::dvec3& axis, glm::dvec3& x, glm::dvec3& y) {
  const glm::dvec3 aside = std::abs(axis.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  x = glm::normalize(glm::cross(aside, axis)), y = glm::cross(axis, x);
}

struct Axes {
  glm::dvec3 x{1, 0, 0}, y{0, 1, 0}, axis{0, 0, 1};
  double length = 0;
  explicit Axes(const RoundShape& s) {
    const glm::dvec3 line = glm::dvec3(s.end[1]) - glm::dvec3(s.end[0]);
    length = glm::length(line);
    if (s.form == RoundForm::ball || !(length > 0)) return;
    axis = line / length;
    across(axis, x, y);
  }
};

glm::vec3 onCircle(int step, int quarter, float z) {
  // Exact at the axes.
  const int quadrant = step / quarter, rest = step % quarter;
  const double angle = glm::half_pi<double>() * rest / quarter;
  double c = std::cos(angle), s = std::sin(angle);
  for (int q = 0; q < quadrant; ++q) c = -std::exchange(s, c);
  return {static_cast<float>(c), static_cast<float>(s), z};
}

struct Builder {
  UnitShape out;
  uint32_t add(const glm::vec3& position, const glm::vec3& normal) {
    out.positions.push_back(position), out.normals.push_back(normal);
    return static_cast<uint32_t>(out.positions.size() - 1);
  }
  void triangle(uint32_t a, uint32_t b, uint32_t c, bool reversed = false) {
    if (reversed) std::swap(b, c);
    out.indices.insert(out.indices.end(), {a, b, c});
  }
};

/// Rings of an octahedron's vertices, from the pole at +z to that at -z.
UnitShape ball(int quarter) {
  Builder b;
  std::vector<uint32_t> first;
  const auto sizeOf = [&](int ring) { return std::min(ring, 2 * quarter - ring); };
  for (int ring = 0; ring <= 2 * quarter; ++ring) {
    first.push_back(static_cast<uint32_t>(b.out.positions.size()));
    const int size = sizeOf(ring);
    const glm::vec3 height = onCircle(ring, quarter, 0);  // cosine and sine of the angle from the pole
    for (int k = 0; k < std::max(1, 4 * size); ++k) {
      const glm::vec3 at = size > 0 ? onCircle(k, size, 0) : glm::vec3(0);
      const glm::vec3 p(at.x * height.y, at.y * height.y, height.x);
      b.add(p, p);
    }
  }
  const auto vertex = [&](int ring, int k) {
    const int size = sizeOf(ring);
    return first[static_cast<size_t>(ring)] + static_cast<uint32_t>(size > 0 ? k % (4 * size) : 0);
  };
  for (int ring = 0; ring < 2 * quarter; ++ring) {
    const bool lower = ring >= quarter;
    const int small = lower ? ring + 1 : ring, large = lower ? ring : ring + 1, size = sizeOf(small);
    for (int q = 0; q < 4; ++q)
      for (int j = 0; j <= size; ++j) {
        const int s = q * size + j, l = q * (size + 1) + j;
        b.triangle(vertex(small, s), vertex(large, l), vertex(large, l + 1), lower);
        if (j < size) b.triangle(vertex(small, s), vertex(large, l + 1), vertex(small, s + 1), lower);
      }
  }
  return std::move(b.out);
}

void addDisc(Builder& b, int quarter, float z, float facing) {
  const glm::vec3 normal(0, 0, facing);
  const uint32_t middle = b.add({0, 0, z}, normal);
  for (int k = 0; k < 4 * quarter; ++k) b.add(onCircle(k, quarter, z), normal);
  for (uint32_t k = 0, n = static_cast<uint32_t>(4 * quarter); k < n; ++k)
    b.triangle(middle, middle + 1 + k, middle + 1 + (k + 1) % n, facing < 0);
}

UnitShape tube(int quarter, bool first, bool second) {
  Builder b;
  const auto n = static_cast<uint32_t>(4 * quarter);
  for (const float z : {0.0f, 1.0f})
    for (uint32_t k = 0; k < n; ++k)
      b.add(onCircle(static_cast<int>(k), quarter, z), onCircle(static_cast<int>(k), quarter, 0));
  for (uint32_t k = 0; k < n; ++k) {
    const uint32_t next = (k + 1) % n;
    b.triangle(k, next, n + next), b.triangle(k, n + next, n + k);
  }
  if (first) addDisc(b, quarter, 0, -1);
  if (second) addDisc(b, quarter, 1, 1);
  return std::move(b.out);
}

/// What several arrays of merged shapes are made from.
struct Parts {
  UnitShape unit;
  std::vector<RoundShape> shapes;
};
using PartsPtr = std::shared_ptr<const Parts>;

/// One array of merged shapes: Each::at(unit, shape, axes, number of the vertex) for each vertex.
template <class Value, class Each>
class MergedArray final : public ArraySource {
 public:
  MergedArray(Element element, PartsPtr parts)
      : ArraySource(element, parts->unit.positions.size() * parts->shapes.size()), parts_(std::move(parts)) {}
  void read(size_t first, size_t count, std::byte* out) const override {
    const size_t each = parts_->unit.positions.size();
    auto* values = reinterpret_cast<Value*>(out);
    for (size_t i = first; i < first + count;) {
      const RoundShape& shape = parts_->shapes[i / each];
      const Axes axes(shape);
      for (const size_t end = std::min(first + count, (i / each + 1) * each); i < end; ++i)
        *values++ = Each::at(parts_->unit, shape, axes, i % each);
    }
  }

 private:
  PartsPtr parts_;
};

struct Position {
  static glm::vec3 at(const UnitShape& unit, const RoundShape& s, const Axes& axes, size_t i) {
    const glm::dvec3 p(unit.positions[i]);
    if (s.form == RoundForm::ball) return glm::vec3(glm::dvec3(s.end[0]) + double{s.radius[0]} * p);
    const double radius =
        s.form == RoundForm::disc ? s.radius[0] : glm::mix<double>(s.radius[0], s.radius[1], p.z);
    return glm::vec3(glm::dvec3(s.end[0]) + radius * (p.x * axes.x + p.y * axes.y) +
                     p.z * axes.length * axes.axis);
  }
};

struct Normal {
  static glm::vec3 at(const UnitShape& unit, const RoundShape& s, const Axes& axes, size_t i) {
    const glm::dvec3 n(unit.normals[i]);
    if (s.form == RoundForm::ball) return unit.normals[i];
    // The mantle of a cone leans by its change of radius.
    const double lean =
        n.z == 0 && s.form != RoundForm::disc ? (s.radius[0] - s.radius[1]) / axes.length : n.z;
    return glm::vec3(glm::normalize(n.x * axes.x + n.y * axes.y + lean * axes.axis));
  }
};

struct Color {
  static glm::vec4 at(const UnitShape& unit, const RoundShape& s, const Axes&, size_t i) {
    if (s.form == RoundForm::ball || s.form == RoundForm::disc) return s.color[0];
    return glm::mix(s.color[0], s.color[1], unit.positions[i].z);
  }
};

class MergedIndices final : public ArraySource {
 public:
  explicit MergedIndices(PartsPtr parts)
      : ArraySource(Element::uint32, parts->unit.indices.size() * parts->shapes.size()),
        parts_(std::move(parts)) {}
  void read(size_t first, size_t count, std::byte* out) const override {
    const size_t each = parts_->unit.indices.size();
    const auto vertices = static_cast<uint32_t>(parts_->unit.positions.size());
    auto* values = reinterpret_cast<uint32_t*>(out);
    for (size_t i = first; i < first + count; ++i)
      *values++ = parts_->unit.indices[i % each] + static_cast<uint32_t>(i / each) * vertices;
  }

 private:
  PartsPtr parts_;
};

}  // namespace

glm::dmat4 RoundShape::placed() const {
  const Axes axes(*this);
  const double r = radius[0], along = form == RoundForm::ball || form == RoundForm::disc ? r : axes.length;
  return {glm::dvec4(r * axes.x, 0), glm::dvec4(r * axes.y, 0), glm::dvec4(along * axes.axis, 0),
          glm::dvec4(end[0], 1)};
}

UnitShape unitShape(RoundForm form, int quarter) {
  if (form == RoundForm::ball) return ball(quarter);
  if (form != RoundForm::disc)
    return tube(quarter, form == RoundForm::closedAtFirst || form == RoundForm::closedTube,
                form == RoundForm::closedAtSecond || form == RoundForm::closedTube);
  Builder b;
  addDisc(b, quarter, 0, 1);
  return std::move(b.out);
}

MergedShapes merged(std::vector<RoundShape> ofOneForm, int quarter) {
  const RoundForm form = ofOneForm.front().form;
  const PartsPtr parts = std::make_shared<Parts>(Parts{unitShape(form, quarter), std::move(ofOneForm)});
  if (parts->unit.positions.size() * parts->shapes.size() >= std::numeric_limits<uint32_t>::max()) return {};
  return {std::make_shared<MergedArray<glm::vec3, Position>>(Element::float3, parts),
          std::make_shared<MergedArray<glm::vec3, Normal>>(Element::float3, parts),
          std::make_shared<MergedArray<glm::vec4, Color>>(Element::float4, parts),
          std::make_shared<MergedIndices>(parts)};
}

}  // namespace gluray::saved
