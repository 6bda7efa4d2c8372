#include "bench/data/cube_cases.h"

namespace gluray::bench {
namespace {

/// Corners of the six faces, counter-clockwise seen from outside the cell.
constexpr int kFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                              {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

int edgeBetween(int a, int b) {
  for (int e = 0; e < 12; ++e)
    if ((kCubeEdges[e][0] == a && kCubeEdges[e][1] == b) || (kCubeEdges[e][0] == b && kCubeEdges[e][1] == a))
      return e;
  return -1;
}

/// For each crossed edge the next one along the surface's border polygon, -1 for edges not crossed. Around
/// each face a run of inside corners begins at one crossed edge and ends at another: the surface cuts the
/// face between them. Each crossed edge begins a run on one of its two faces and ends one on the other, so
/// that the cuts close to polygons.
std::array<int, 12> nextAlongBorder(int inside) {
  std::array<int, 12> next;
  next.fill(-1);
  const auto isInside = [inside](int corner) { return (inside >> corner & 1) != 0; };
  for (const auto& face : kFaces)
    for (int start = 0; start < 4; ++start) {
      if (isInside(face[start]) || !isInside(face[(start + 1) % 4])) continue;
      int end = (start + 1) % 4;
      while (isInside(face[(end + 1) % 4])) end = (end + 1) % 4;
      next[edgeBetween(face[end], face[(end + 1) % 4])] = edgeBetween(face[start], face[(start + 1) % 4]);
    }
  return next;
}

CubeCase makeCase(int inside) {
  CubeCase out;
  std::array<int, 12> next = nextAlongBorder(inside);
  for (int first = 0; first < 12; ++first) {
    if (next[first] < 0) continue;
    // A fan around the polygon's first corner; visited edges are struck off.
    int b = next[first], c = next[b];
    next[first] = -1;
    while (c != first) {
      uint8_t* corner = out.edges.data() + 3 * out.triangleCount++;
      corner[0] = uint8_t(first);
      corner[1] = uint8_t(c);
      corner[2] = uint8_t(b);
      next[b] = -1;
      b = c;
      c = next[c];
    }
    next[b] = -1;
  }
  return out;
}

}  // namespace

const std::array<CubeCase, 256>& cubeCases() {
  static const std::array<CubeCase, 256> cases = [] {
    std::array<CubeCase, 256> out;
    for (int inside = 0; inside < 256; ++inside) out[size_t(inside)] = makeCase(inside);
    return out;
  }();
  return cases;
}

}  // namespace gluray::bench
