// An indexed triangle mesh, as the benchmarks make, draw and write it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gluray::bench {

/// Leaves new elements uninitialised, so that the threads that fill a large array are the first to touch its
/// pages.
template <typename T>
struct UntouchedAllocator : std::allocator<T> {
  template <typename U>
  struct rebind {
    using other = UntouchedAllocator<U>;
  };
  template <typename U>
  void construct(U* at) noexcept {
    ::new (static_cast<void*>(at)) U;
  }
  template <typename U, typename... Args>
  void construct(U* at, Args&&... args) {
    ::new (static_cast<void*>(at)) U(std::forward<Args>(args)...);
  }
};
template <typename T>
using LargeArray = std::vector<T, UntouchedAllocator<T>>;

struct Vertex {
  float x, y, z;
};

/// Triangles, counter-clockwise seen from outside, with one unit normal a vertex that points outwards.
struct TriangleMesh {
  LargeArray<Vertex> positions;  // with room for one more, so that 16 bytes can be read at the last one
  LargeArray<Vertex> normals;    // as many as positions
  LargeArray<uint32_t> indices;  // three a triangle
  size_t triangleCount() const { return indices.size() / 3; }
};

/// All of them in one mesh, in their order; each is freed once it is there. Throws std::runtime_error where
/// they have more than 2^32 vertices.
TriangleMesh joined(std::vector<TriangleMesh> meshes);

/// Writes a binary little-endian PLY: x y z nx ny nz as floats, triangles as vertex_indices. A file of that
/// name is replaced only once all is written. Throws std::runtime_error with one clear line when it cannot be
/// written.
void writePly(const TriangleMesh& mesh, const std::string& path);

}  // namespace gluray::bench
