// Makes immutable meshes from captured vertices. Any thread; large soups are welded on all cores.
#pragma once
#include "gl/capture/captured_vertices.h"
#include "gl/capture/mesh_cache.h"

namespace gluray::gl {

/// The mesh that the surfaces of `captured` fill. Separate triangles without indices are welded: corners that
/// agree in every bit of every slot share a vertex, and the order of triangles is kept, so that `indices`
/// also replays the vertices as sent. Never null, except for homogeneous vertices (some w is not 1). Throws
/// std::bad_alloc.
KnownMesh buildMesh(const CapturedVertices& captured);
/// The same, of a capture that nobody else needs: the mesh takes over its vertices and indices where it can
/// use them as they are; `captured` then has none. Where it throws `captured` is as it was.
KnownMesh buildMesh(CapturedVertices&& captured);

/// Finds bounds, alpha and identity of `mesh`, whose arrays are set.
void finishMesh(scene::Mesh& mesh);

/// Whether vertices lie where Embree does not find them: it takes coordinates beyond 1.8e18 for mistakes.
bool isFarAway(const scene::Mesh& mesh);

/// Memory for `count` elements of T followed by 16 readable bytes, kept alive by the pointer.
template <class T>
std::shared_ptr<T[]> makePadded(size_t count);

}  // namespace gluray::gl
