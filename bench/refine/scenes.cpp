#include "bench/refine/scenes.h"

#include "bench/data/isosurface.h"
#include "bench/data/orbit.h"
#include "bench/data/tubes.h"
#include "bench/data/wavelet.h"
#include "bench/data/waves.h"
#include "bench/render/wavelet_snapshot.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gluray::bench {
namespace {

using Colors = std::vector<uint32_t>;  // RGBA8, red in the lowest byte

uint32_t packed(double red, double green, double blue) {
  const auto byte = [](double v) {
    return static_cast<uint32_t>(std::lround(std::clamp(v, 0.0, 1.0) * 255));
  };
  return byte(red) | byte(green) << 8 | byte(blue) << 16 | 255u << 24;
}

/// Blue, white, red for 0, 0.5, 1.
uint32_t blueToRed(double t) {
  return packed(std::min(2 * t, 1.0), 1 - std::abs(2 * t - 1), std::min(2 - 2 * t, 1.0));
}

struct ColoredMesh {
  TriangleMesh mesh;
  Colors colors;  // one a vertex
  uint32_t add(const Point& p, const Point& n, uint32_t color) {
    mesh.positions.push_back({float(p[0]), float(p[1]), float(p[2])});
    mesh.normals.push_back({float(n[0]), float(n[1]), float(n[2])});
    colors.push_back(color);
    return static_cast<uint32_t>(colors.size() - 1);
  }
  /// The two triangles between rows `a` and `a` + `row` of a grid.
  void addQuad(uint32_t a, uint32_t row) {
    for (const uint32_t corner : {a, a + 1, a + row + 1, a, a + row + 1, a + row})
      mesh.indices.push_back(corner);
  }
};

/// 400 balls of four sizes and colours in a ball.
ColoredMesh balls() {
  constexpr int kBalls = 400, kAround = 48, kUp = 24;
  const uint32_t colors[] = {packed(0.56, 0.56, 0.56), packed(0.19, 0.31, 0.97), packed(1, 0.05, 0.05),
                             packed(0.9, 0.9, 0.9)};
  ColoredMesh out;
  for (uint64_t i = 0; i < kBalls; ++i) {
    const Point way = directionOf(7, i);
    const double far = 120 * std::cbrt(evenly(8, i)), radius = 13 + 2.5 * double(i % 4);
    const auto first = static_cast<uint32_t>(out.colors.size());
    for (int up = 0; up <= kUp; ++up)
      for (int around = 0; around <= kAround; ++around) {
        const double a = 2 * M_PI * around / kAround, b = M_PI * (double(up) / kUp - 0.5);
        const Point n{std::cos(a) * std::cos(b), std::sin(b), -std::sin(a) * std::cos(b)};
        out.add({far * way[0] + radius * n[0], far * way[1] + radius * n[1], far * way[2] + radius * n[2]}, n,
                colors[i % 4]);
      }
    for (uint32_t up = 0; up < kUp; ++up)
      for (uint32_t around = 0; around < kAround; ++around)
        out.addQuad(first + up * (kAround + 1) + around, kAround + 1);
  }
  return out;
}

/// 220 tubes of about five pixels' width that wind about each other.
ColoredMesh windingTubes() {
  constexpr int kLines = 220, kPieces = 160, kSides = 10;
  std::vector<Line> lines;
  for (int i = 0; i < kLines; ++i) {
    Line line;
    for (int k = 0; k <= kPieces; ++k) {
      const double t = double(k) / kPieces, a = 2.4 * i + 9 * t;
      const double r = 12 + 9 * (i % 11) + 18 * t * std::sin(3 * t + i);
      line.push_back({r * std::cos(a), 200 * (t - 0.5) + 8 * std::sin(i), r * std::sin(a)});
    }
    lines.push_back(line);
  }
  ColoredMesh out{tubes(lines, 0.9, kSides), {}};
  for (size_t i = 0; i < out.mesh.normals.size(); ++i)
    out.colors.push_back(blueToRed(double(i / kSides % (kPieces + 1)) / kPieces));
  return out;
}

/// Hills over a square; colours by height in 24 bands.
ColoredMesh landscape() {
  constexpr int kSide = 600;
  const std::vector<Wave> hills = waves(24, 0.02, 0.5, 1.6, 3);
  const auto height = [&](double x, double z) {
    double sum = 0;
    for (const Wave& wave : hills) sum += wave.at({x, 0, z});
    return 14 * sum;
  };
  ColoredMesh out;
  for (int i = 0; i <= kSide; ++i)
    for (int k = 0; k <= kSide; ++k) {
      const double x = 240 * (double(k) / kSide - 0.5), z = 240 * (0.5 - double(i) / kSide), step = 0.2;
      const double y = height(x, z), dx = (height(x + step, z) - y) / step,
                   dz = (height(x, z + step) - y) / step, length = std::sqrt(dx * dx + dz * dz + 1);
      const double band = std::floor((y + 45) / 90 * 24);
      out.add({x, y, z}, {-dx / length, 1 / length, -dz / length},
              std::fmod(band, 2) == 0 ? blueToRed(band / 24) : packed(0.27 + band / 40, 0.75, 0.35));
    }
  for (uint32_t i = 0; i < kSide; ++i)
    for (uint32_t k = 0; k < kSide; ++k) out.addQuad(i * (kSide + 1) + k, kSide + 1);
  return out;
}

RefineScene colored(ColoredMesh&& made, uint64_t number) {
  RefineScene out;
  made.mesh.positions.reserve(made.mesh.positions.size() + 2);  // 16 bytes can be read at the last one
  auto colors = std::make_shared<const Colors>(std::move(made.colors));
  out.mesh = std::make_unique<const TriangleMesh>(std::move(made.mesh));
  out.snapshot = waveletSnapshot(*out.mesh);
  auto mesh = std::make_shared<scene::Mesh>(*out.snapshot.instances[0].mesh);
  mesh->geometryId = {3, number};
  mesh->colors = {colors, reinterpret_cast<const std::byte*>(colors->data()), 4, scene::Format::unorm8x4};
  out.snapshot.instances[0].mesh = mesh;
  out.snapshot.shadings[0].colorMaterial = {scene::ColorMaterial::ambientAndDiffuse,
                                            scene::ColorMaterial::ambientAndDiffuse};
  return out;
}

RefineScene isosurfaceScene(double millionTriangles) {
  const Volume volume = wavelet();
  const auto [low, high] = volume.range();
  RefineScene out;
  out.mesh = std::make_unique<const TriangleMesh>(
      isosurfaces(volume, evenIsovalues(low, high, waveletSurfaces(millionTriangles))));
  out.snapshot = waveletSnapshot(*out.mesh);
  return out;
}

}  // namespace

const std::vector<std::string>& refineSceneNames() {
  static const std::vector<std::string> names{"wavelet", "balls", "tubes", "landscape"};
  return names;
}

RefineScene refineScene(const std::string& name, double millionTriangles, int size) {
  RefineScene out;
  if (name == "wavelet")
    out = isosurfaceScene(millionTriangles);
  else if (name == "balls")
    out = colored(balls(), 1);
  else if (name == "tubes")
    out = colored(windingTubes(), 2);
  else if (name == "landscape")
    out = colored(landscape(), 3);
  else
    throw std::runtime_error("no scene is called " + name);
  out.snapshot.camera.viewport = {0, 0, kImageSize, kImageSize};
  const int corner = (kImageSize - size) / 2;
  out.snapshot.region = {corner, corner, size, size};
  lookFrom(out.snapshot, orbitPose(0, 360));
  return out;
}

}  // namespace gluray::bench
