#include "bench/data/isosurface.h"

#include "bench/data/cube_cases.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace gluray::bench {
namespace {

constexpr uint32_t kNone = 0xffffffffu;

/// Places of the vertices and triangles of one layer of one surface. A layer is a plane of grid points and
/// the cells above it. Its vertices: first those on edges within the plane, by point, x before y; then those
/// on edges up to the next plane, by point.
struct Layer {
  size_t planeVertices = 0, upVertices = 0, triangles = 0;  // counts
  size_t firstVertex = 0, firstTriangle = 0;                // places in the mesh
};

/// Numbers of the vertices on the edges that start at the points of one plane, kNone where the edge is not
/// crossed.
struct PlaneNumbers {
  std::vector<uint32_t> alongX, alongY;
};

/// Marching cubes of one surface, layer by layer; layers are independent of one another.
class Surface {
 public:
  /// Planes beyond `last` serve gradients alone.
  Surface(const Volume& volume, float isovalue, int last)
      : volume_(volume), isovalue_(isovalue), last_(last) {}

  Layer count(int z) const;
  void emit(int z, const Layer& layer, const Layer* above, TriangleMesh& mesh) const;

 private:
  bool inside(float value) const { return value >= isovalue_; }
  bool crossed(float a, float b) const { return inside(a) != inside(b); }
  /// Calls visit(axis, x, y) for each crossed edge along x or y that starts in plane z, in vertex order.
  template <typename Visit>
  void forPlaneEdges(int z, const Visit& visit) const;
  /// Calls visit(x, y) for each crossed edge from plane z to the next, in vertex order.
  template <typename Visit>
  void forUpEdges(int z, const Visit& visit) const;
  /// Calls visit(x, y, case number) for each cell between plane z and the next that the surface cuts.
  template <typename Visit>
  void forCells(int z, const Visit& visit) const;
  Vertex gradient(int x, int y, int z) const;
  void emitVertex(int axis, int x, int y, int z, size_t at, TriangleMesh& mesh) const;
  size_t points() const { return size_t(volume_.size[0]) * size_t(volume_.size[1]); }
  size_t point(int x, int y) const { return size_t(x) + size_t(volume_.size[0]) * size_t(y); }

  const Volume& volume_;
  float isovalue_;
  int last_;
};

template <typename Visit>
void Surface::forPlaneEdges(int z, const Visit& visit) const {
  const int width = volume_.size[0], height = volume_.size[1];
  for (int y = 0; y < height; ++y) {
    const float* row = volume_.values.data() + volume_.rowIndex(y, z);
    const float* next = y + 1 < height ? row + width : row;
    for (int x = 0; x < width; ++x) {
      if (x + 1 < width && crossed(row[x], row[x + 1])) visit(0, x, y);
      if (crossed(row[x], next[x])) visit(1, x, y);
    }
  }
}

template <typename Visit>
void Surface::forUpEdges(int z, const Visit& visit) const {
  if (z >= last_) return;
  for (int y = 0; y < volume_.size[1]; ++y) {
    const float* row = volume_.values.data() + volume_.rowIndex(y, z);
    const float* up = volume_.values.data() + volume_.rowIndex(y, z + 1);
    for (int x = 0; x < volume_.size[0]; ++x)
      if (crossed(row[x], up[x])) visit(x, y);
  }
}

template <typename Visit>
void Surface::forCells(int z, const Visit& visit) const {
  if (z >= last_) return;
  for (int y = 0; y + 1 < volume_.size[1]; ++y) {
    const float* rows[4];
    for (int r = 0; r < 4; ++r) rows[r] = volume_.values.data() + volume_.rowIndex(y + (r & 1), z + (r >> 1));
    // The four corners at one x, as bits 0, 2, 4, 6 of a case number.
    const auto column = [&](int x) {
      return int(inside(rows[0][x])) | int(inside(rows[1][x])) << 2 | int(inside(rows[2][x])) << 4 |
             int(inside(rows[3][x])) << 6;
    };
    int left = column(0);
    for (int x = 0; x + 1 < volume_.size[0]; ++x) {
      const int right = column(x + 1);
      const int number = left | right << 1;
      if (number != 0 && number != 255) visit(x, y, number);
      left = right;
    }
  }
}

Layer Surface::count(int z) const {
  Layer out;
  forPlaneEdges(z, [&](int, int, int) { ++out.planeVertices; });
  forUpEdges(z, [&](int, int) { ++out.upVertices; });
  const auto& cases = cubeCases();
  forCells(z, [&](int, int, int number) { out.triangles += cases[size_t(number)].triangleCount; });
  return out;
}

Vertex Surface::gradient(int x, int y, int z) const {
  // Central differences, one-sided at the border.
  const auto slope = [](float low, float high, int from, int to, float spacing) {
    return to > from ? (high - low) / (float(to - from) * spacing) : 0.0f;
  };
  const auto& size = volume_.size;
  const int x0 = std::max(x - 1, 0), x1 = std::min(x + 1, size[0] - 1);
  const int y0 = std::max(y - 1, 0), y1 = std::min(y + 1, size[1] - 1);
  const int z0 = std::max(z - 1, 0), z1 = std::min(z + 1, size[2] - 1);
  return {slope(volume_.at(x0, y, z), volume_.at(x1, y, z), x0, x1, volume_.spacing[0]),
          slope(volume_.at(x, y0, z), volume_.at(x, y1, z), y0, y1, volume_.spacing[1]),
          slope(volume_.at(x, y, z0), volume_.at(x, y, z1), z0, z1, volume_.spacing[2])};
}

void Surface::emitVertex(int axis, int x, int y, int z, size_t at, TriangleMesh& mesh) const {
  const int x1 = x + (axis == 0), y1 = y + (axis == 1), z1 = z + (axis == 2);
  const float a = volume_.at(x, y, z), b = volume_.at(x1, y1, z1);
  const float t = (isovalue_ - a) / (b - a);
  const auto place = [&](int i, float offset) {
    return volume_.origin[size_t(i)] + volume_.spacing[size_t(i)] * offset;
  };
  mesh.positions[at] = {place(0, float(x) + (axis == 0 ? t : 0)), place(1, float(y) + (axis == 1 ? t : 0)),
                        place(2, float(z) + (axis == 2 ? t : 0))};
  const Vertex g = gradient(x, y, z), h = gradient(x1, y1, z1);
  const Vertex n{g.x + t * (h.x - g.x), g.y + t * (h.y - g.y), g.z + t * (h.z - g.z)};
  const float length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  mesh.normals[at] = length > 0 ? Vertex{-n.x / length, -n.y / length, -n.z / length} : Vertex{0, 0, 1};
}

void Surface::emit(int z, const Layer& layer, const Layer* above, TriangleMesh& mesh) const {
  PlaneNumbers planes[2];
  std::vector<uint32_t> upNumbers(points(), kNone);
  const auto numberPlane = [&](int plane, size_t first, PlaneNumbers& out) {
    out.alongX.assign(points(), kNone);
    out.alongY.assign(points(), kNone);
    forPlaneEdges(plane, [&](int axis, int x, int y) {
      (axis == 0 ? out.alongX : out.alongY)[point(x, y)] = uint32_t(first++);
    });
  };
  // This plane's vertices, then those on the way up; of the plane above only the numbers are needed.
  numberPlane(z, layer.firstVertex, planes[0]);
  forPlaneEdges(z, [&](int axis, int x, int y) {
    emitVertex(axis, x, y, z, (axis == 0 ? planes[0].alongX : planes[0].alongY)[point(x, y)], mesh);
  });
  if (!above) return;
  size_t next = layer.firstVertex + layer.planeVertices;
  forUpEdges(z, [&](int x, int y) {
    upNumbers[point(x, y)] = uint32_t(next);
    emitVertex(2, x, y, z, next++, mesh);
  });
  numberPlane(z + 1, above->firstVertex, planes[1]);

  const auto& cases = cubeCases();
  size_t at = 3 * layer.firstTriangle;
  forCells(z, [&](int x, int y, int number) {
    const CubeCase& cell = cases[size_t(number)];
    for (int i = 0; i < 3 * cell.triangleCount; ++i) {
      const int edge = cell.edges[size_t(i)];
      const int corner = kCubeEdges[size_t(edge)][0];
      const size_t from = point(x + (corner & 1), y + (corner >> 1 & 1));
      const PlaneNumbers& plane = planes[corner >> 2];
      mesh.indices[at++] = edge < 4 ? plane.alongX[from] : edge < 8 ? plane.alongY[from] : upNumbers[from];
    }
  });
}

/// Places every layer after the one before; returns the totals.
Layer placeLayers(std::vector<Layer>& layers) {
  Layer total;
  for (Layer& layer : layers) {
    layer.firstVertex = total.firstVertex;
    layer.firstTriangle = total.firstTriangle;
    total.firstVertex += layer.planeVertices + layer.upVertices;
    total.firstTriangle += layer.triangles;
  }
  return total;
}

/// The surfaces between two planes of the volume, those included.
TriangleMesh between(int first, int last, const Volume& volume, const std::vector<float>& isovalues,
                     const Progress& progress) {
  const int depth = last - first + 1;
  const size_t layerCount = size_t(depth) * isovalues.size();
  std::vector<Layer> layers(layerCount);
  std::atomic<size_t> done{0};
  const auto finished = [&] {
    if (progress) progress(double(++done) / double(2 * layerCount));
  };
  const auto surface = [&](size_t i) { return Surface(volume, isovalues[i / size_t(depth)], last); };
  tbb::parallel_for(size_t(0), layerCount, [&](size_t i) {
    layers[i] = surface(i).count(first + int(i % size_t(depth)));
    finished();
  });

  const Layer total = placeLayers(layers);
  if (total.firstVertex >= kNone) throw std::runtime_error("the isosurface needs more than 2^32 vertices");
  TriangleMesh mesh;
  mesh.positions.reserve(total.firstVertex + 1);
  mesh.positions.resize(total.firstVertex);
  mesh.normals.resize(total.firstVertex);
  mesh.indices.resize(3 * total.firstTriangle);

  tbb::parallel_for(size_t(0), layerCount, [&](size_t i) {
    const int z = first + int(i % size_t(depth));
    surface(i).emit(z, layers[i], z < last ? &layers[i + 1] : nullptr, mesh);
    finished();
  });
  return mesh;
}

}  // namespace

TriangleMesh isosurfaces(const Volume& volume, const std::vector<float>& isovalues,
                         const Progress& progress) {
  return between(0, volume.size[2] - 1, volume, isovalues, progress);
}

MeshSize sizeOfIsosurfaces(const Volume& volume, const std::vector<float>& isovalues) {
  const auto depth = size_t(volume.size[2]);
  std::atomic<size_t> vertices{0}, triangles{0};
  tbb::parallel_for(size_t(0), depth * isovalues.size(), [&](size_t i) {
    const Layer layer = Surface(volume, isovalues[i / depth], volume.size[2] - 1).count(int(i % depth));
    vertices += layer.planeVertices + layer.upVertices, triangles += layer.triangles;
  });
  return {vertices, triangles};
}

TriangleMesh isosurfaceInSlabs(const std::array<int, 3>& size, const FillPlane& fill, float isovalue,
                               int thickness) {
  std::vector<TriangleMesh> slabs;
  for (int first = 0; first + 1 < size[2]; first += thickness) {
    const int last = std::min(first + thickness, size[2] - 1);
    const int lowest = std::max(first - 1, 0), highest = std::min(last + 1, size[2] - 1);
    Volume slab;
    slab.size = {size[0], size[1], highest - lowest + 1};
    slab.origin = {0, 0, float(lowest)};
    slab.values.resize(slab.rowIndex(0, slab.size[2]));
    tbb::parallel_for(0, slab.size[2],
                      [&](int z) { fill(lowest + z, slab.values.data() + slab.rowIndex(0, z)); });
    slabs.push_back(between(first - lowest, last - lowest, slab, {isovalue}, {}));
  }
  return joined(std::move(slabs));
}

}  // namespace gluray::bench
