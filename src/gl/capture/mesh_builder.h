// Builds immutable meshes from captured vertices. Any thread; large soups are welded on all cores.
#pragma once
#include "gl/capture/captured_vertices.h"
#include "gl/capture/mesh_cache.h"

namespace gluray::gl {

/// Builds the mesh of all surfaces in `captured`. Many separate triangles without indices are welded: bitwise
/// equal corners share a vertex. Triangles keep their order, so that `indices` also replays the vertices as
/// sent. Points become balls, lines capsules. The mesh is null only if vertices are homogeneous (some w is
/// not 1) or primitives have adjacent vertices. Throws std::bad_alloc.
KnownMesh buildMesh(const CapturedVertices& captured);
/// Builds the same mesh, which takes over the arrays that it can use unchanged; `captured` then has none. If
/// this throws, `captured` is unchanged.
KnownMesh buildMesh(CapturedVertices&& captured);

/// Computes bounds, opacity of colours, and geometry id of `mesh`, whose arrays are set. `facts`, if not
/// null, describe its triangles.
void finishMesh(scene::Mesh& mesh, const SurfaceFacts* facts = nullptr);

/// The least square of a length among the mesh's normals that are not zero, in object space, as float has it;
/// infinite if there are none.
float leastSquareOfNormals(const scene::Mesh& mesh);
/// The same for one normal.
float squareOfNormal(const glm::vec3& normal);

/// Whether a coordinate is beyond 1e18. Embree rejects coordinates beyond 1.8e18.
bool isFarAway(const scene::Mesh& mesh);

/// Memory for `count` elements of T followed by 16 readable bytes, kept alive by the pointer.
template <class T>
std::shared_ptr<T[]> makePadded(size_t count);

}  // namespace gluray::gl
