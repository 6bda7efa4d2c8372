// Builds meshes of impostors from the billboards that a draw sends.
#include "gl/arrays/array_indices.h"
#include "gl/capture/mesh_builder.h"
#include "gl/impostors/sent_billboards.h"
#include "gl/program_state/program_state.h"
#include "gl/real/state_queries.h"
#include "scene/box_corner.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace gluray::gl {
namespace {

constexpr size_t kMaxCorners = 36;  // maximum corners of a box: two triangles for each side

/// Attributes that all corners of a billboard share.
struct CornerValues {
  float position[4] = {0, 0, 0, 1}, radius[4] = {}, color[4] = {}, end[4] = {}, endColor[4] = {},
        caps[4] = {};
  bool operator==(const CornerValues& o) const { return std::memcmp(this, &o, sizeof o) == 0; }
};

/// Reads the arrays of a draw of billboards.
class Billboards {
 public:
  Billboards(const RealGl& real, const ArrayState& arrays)
      : radius_(arrays.impostorRadius),
        caps_(arrays.impostorCaps),
        inPosition_(arrays.radiusInPosition),
        inCorners_(arrays.radiusInCorners),
        readers_{ArrayReader(real, arrays.vertex),   ArrayReader(real, arrays.radius),
                 ArrayReader(real, arrays.color),    ArrayReader(real, arrays.end),
                 ArrayReader(real, arrays.endColor), ArrayReader(real, arrays.caps),
                 ArrayReader(real, arrays.corners)} {
    for (const ArrayReader& r : readers_)
      if (r.enabled()) available_ = std::min(available_, r.available());
  }
  uint32_t available() const { return available_; }
  bool has(int array) const { return readers_[static_cast<size_t>(array)].enabled(); }
  enum { kPosition, kRadius, kColor, kEnd, kEndColor, kCaps, kCorners };

  CornerValues at(uint32_t vertex) const {
    CornerValues v;
    float* const out[] = {v.position, v.radius, v.color, v.end, v.endColor, v.caps};
    v.radius[0] = radius_, v.caps[0] = caps_;
    for (size_t i = 0; i < std::size(out); ++i)
      if (readers_[i].enabled()) readers_[i].read(vertex, out[i]);
    if (inPosition_) v.radius[0] = v.position[3], v.position[3] = 1;
    if (inCorners_) v.radius[0] = radiusOfCorner(vertex);
    return v;
  }
  /// The corner of a vertex; above 7: invalid.
  uint8_t cornerOf(uint32_t vertex) const {
    float v[4] = {};
    readers_[kCorners].read(vertex, v);
    if (inCorners_) return static_cast<uint8_t>((v[0] > 0 ? 1 : 0) | (v[1] > 0 ? 2 : 0));
    return v[0] >= 0 && v[0] <= 7 && v[0] == std::floor(v[0]) ? static_cast<uint8_t>(v[0]) : uint8_t{255};
  }

 private:
  /// The corner's distance from the centre in each direction; not a number if the two differ.
  float radiusOfCorner(uint32_t vertex) const {
    float v[4] = {};
    readers_[kCorners].read(vertex, v);
    const float radius = std::abs(v[0]);
    return radius > 0 && std::abs(v[1]) == radius ? radius : std::numeric_limits<float>::quiet_NaN();
  }

  float radius_, caps_;
  bool inPosition_, inCorners_;
  uint32_t available_ = std::numeric_limits<uint32_t>::max();
  std::array<ArrayReader, 7> readers_;
};

/// All vertex numbers of the draw; empty if one of the vertices does not exist.
std::vector<uint32_t> allNumbersOf(const RealGl& real, const ArrayState& arrays, const Elements& e,
                                   uint32_t available) {
  std::vector<uint32_t> numbers = vertexNumbers(real, arrays, e);
  const bool whole = numbers.size() == static_cast<size_t>(std::max(e.count, 0)) &&
                     std::ranges::all_of(numbers, [&](uint32_t n) { return n < available; });
  return whole ? numbers : std::vector<uint32_t>();
}

/// The corners of a billboard, in the order in which the draw sends them.
using CornerPattern = std::array<uint8_t, kMaxCorners>;

/// Reads one billboard. Returns false unless all its vertices agree and follow `pattern`.
bool readBillboard(const Billboards& from, std::span<const uint32_t> numbers, const CornerPattern& pattern,
                   CornerValues& values) {
  values = from.at(numbers[0]);
  std::array<uint32_t, kMaxCorners> known;
  size_t count = 0;
  for (size_t k = 0; k < numbers.size(); ++k) {
    if (from.cornerOf(numbers[k]) != pattern[k]) return false;
    const auto end = known.begin() + static_cast<ptrdiff_t>(count);
    if (std::find(known.begin(), end, numbers[k]) != end) continue;
    if (!(from.at(numbers[k]) == values)) return false;
    known[count++] = numbers[k];
  }
  return true;
}

bool isSphere(const CornerValues& v) {
  const float sum = v.position[0] + v.position[1] + v.position[2] + v.radius[0];
  return std::isfinite(sum) && v.radius[0] >= 0 && v.position[3] == 1;
}

bool isStick(const CornerValues& v) {
  const glm::vec3 a(v.position[0], v.position[1], v.position[2]), b(v.end[0], v.end[1], v.end[2]);
  const float length = glm::distance(a, b), caps = v.caps[0];
  return isSphere(v) && std::isfinite(length) && length > 0 && caps >= 0 && caps < 32 &&
         caps == std::floor(caps);
}

/// Converts the attribute's bits to bits of scene::StickEnd for the first and the second end.
void readCaps(const CornerValues& v, uint32_t (&ends)[2]) {
  const auto bits = static_cast<uint32_t>(v.caps[0]);
  for (uint32_t k = 0; k < 2; ++k)
    ends[k] = (bits >> k & 1 ? scene::kClosedEnd : 0u) | (bits >> (k + 2) & 1 ? scene::kRoundEnd : 0u);
  if (!(bits >> 4 & 1)) ends[0] |= scene::kTwoHalves;
}

/// Arrays of a mesh under construction.
struct MeshArrays {
  uint32_t perImpostor;
  std::shared_ptr<float[]> positions, radii, colors;
  std::shared_ptr<uint32_t[]> ends;

  MeshArrays(uint32_t vertices, uint32_t each, bool colored, bool sticks) : perImpostor(each) {
    positions = makePadded<float>(size_t{vertices} * 3), radii = makePadded<float>(vertices);
    if (colored) colors = makePadded<float>(size_t{vertices} * 4);
    if (sticks) ends = makePadded<uint32_t>(vertices);
  }
  void put(uint32_t impostor, const CornerValues& v) {
    uint32_t caps[2] = {};
    if (ends) readCaps(v, caps);
    for (uint32_t k = 0; k < perImpostor; ++k) {
      const size_t at = size_t{impostor} * perImpostor + k;
      std::memcpy(&positions[3 * at], k == 0 ? v.position : v.end, 3 * sizeof(float));
      radii[at] = v.radius[0];
      if (colors) std::memcpy(&colors[4 * at], k == 0 ? v.color : v.endColor, 4 * sizeof(float));
      if (ends) ends[at] = caps[k];
    }
  }
  template <class T>
  static scene::Attribute attribute(const std::shared_ptr<T[]>& data, uint32_t components,
                                    scene::Format format) {
    if (!data) return {};
    return {data, reinterpret_cast<const std::byte*>(data.get()), components * 4, format};
  }
  void giveTo(scene::Mesh& mesh) const {
    mesh.positions = attribute(positions, 3, scene::Format::float3);
    mesh.radii = attribute(radii, 1, scene::Format::float1);
    mesh.colors = attribute(colors, 4, scene::Format::float4);
    mesh.ends = attribute(ends, 1, scene::Format::uint32);
    const size_t perVertex = 16 + (colors ? 16 : 0) + (ends ? 4 : 0);
    mesh.sizeBytes += mesh.vertexCount * perVertex;
  }
};

}  // namespace

KnownMesh buildSentImpostors(const RealGl& real, const ArrayState& arrays, GLenum mode,
                             const Elements& elements) {
  const Billboards from(real, arrays);
  const bool sticks = arrays.shape == scene::Shape::sticks;
  const size_t corners = (sticks ? 6u : 1u) * (mode == GL_QUADS ? 4u : 6u);
  const bool complete = from.has(Billboards::kCorners) &&
                        (!sticks || (from.has(Billboards::kEnd) &&
                                     from.has(Billboards::kColor) == from.has(Billboards::kEndColor)));
  if (!complete || (mode != GL_QUADS && mode != GL_TRIANGLES)) return {};
  const std::vector<uint32_t> numbers = allNumbersOf(real, arrays, elements, from.available());
  if (numbers.empty() || numbers.size() % corners != 0) return {};
  CornerPattern pattern{};
  for (size_t k = 0; k < corners; ++k) pattern[k] = from.cornerOf(numbers[k]);
  if (!coversBillboard(std::span(pattern).first(corners), mode, sticks ? 3 : 2)) return {};

  auto mesh = std::make_shared<scene::Mesh>();
  mesh->shape = arrays.shape;
  mesh->triangleCount = static_cast<uint32_t>(numbers.size() / corners);
  mesh->vertexCount = mesh->triangleCount * scene::cornersOf(mesh->shape);
  MeshArrays filled(mesh->vertexCount, scene::cornersOf(mesh->shape), from.has(Billboards::kColor), sticks);
  mesh->radius = 0;
  for (uint32_t i = 0; i < mesh->triangleCount; ++i) {
    CornerValues v;
    if (!readBillboard(from, std::span(numbers).subspan(i * corners, corners), pattern, v)) return {};
    if (!(sticks ? isStick(v) : isSphere(v))) return {};
    filled.put(i, v);
    mesh->radius = std::max(mesh->radius, v.radius[0]);
  }
  filled.giveTo(*mesh);
  finishMesh(*mesh);
  const uint32_t form[] = {static_cast<uint32_t>(mesh->shape), 1};
  Hash128 identity = hashBytes(form, sizeof form, mesh->geometryId);
  identity = hashBytes(mesh->radii.data, size_t{mesh->vertexCount} * 4, identity);
  if (mesh->ends) identity = hashBytes(mesh->ends.data, size_t{mesh->vertexCount} * 4, identity);
  mesh->geometryId = identity;
  KnownMesh known;
  known.mesh = std::move(mesh);
  return known;
}

namespace {

/// Extent along z of the boxes around sticks, in eye space.
struct ZRange {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double z, double reach) { low = std::min(low, z - reach), high = std::max(high, z + reach); }
};

}  // namespace

bool showsSticks(const RealGl& real, const ProgramState& program, const scene::Mesh& mesh) {
  if (!program.eyeFromObject) return false;
  const glm::dmat4& eye = *program.eyeFromObject;
  const glm::dmat4 rows = glm::transpose(eye);
  const auto z = [&](const glm::vec3& p) { return glm::dot(rows[2], glm::dvec4(p, 1)); };
  const double scale = 1.74 / double{program.impostors.radiusDivisor};  // corners are sqrt(3) radii away
  ZRange all;
  for (int corner = 0; corner < 8; ++corner)
    all.add(z(scene::boxCorner(mesh.lower, mesh.upper, corner)), scale * double{mesh.radius});
  // Beyond the far plane, the program clamps depths instead of discarding fragments; a GL_LESS test then
  // fails.
  const glm::dmat4 clipFromEye = program.clipFromObject * glm::inverse(eye);
  const double farthest =
      (clipFromEye[2].z * all.low + clipFromEye[3].z) / (clipFromEye[2].w * all.low + clipFromEye[3].w);
  if (integer(real, GL_DEPTH_FUNC) != GL_LESS && !(farthest < 1)) return false;
  if (!program.impostors.parallelView && all.high < 0) return true;
  const glm::dmat3 turn(eye);
  for (uint32_t i = 0; i < mesh.triangleCount; ++i) {
    const glm::vec3 a = mesh.position(2 * i), b = mesh.position(2 * i + 1);
    if (program.impostors.parallelView) {
      // Seen along its axis, a cylinder has no equation that the program could solve.
      const glm::dvec3 axis = glm::normalize(turn * (glm::dvec3(b) - glm::dvec3(a)));
      constexpr double kMin = 1e-4;
      if (glm::length(glm::dvec2(axis)) < kMin) return false;
      continue;
    }
    ZRange own;
    const double reach = scale * double{scene::fetch(mesh.radii, 2 * i).x};
    own.add(z(a), reach), own.add(z(b), reach);
    if (own.high >= 0 && own.low < 0) return false;
  }
  return true;
}

}  // namespace gluray::gl
