// Names of what shader programs without attributes fetch their vertices from. A part of Family. Any thread.
#pragma once
#include <string>

namespace gluray::gl {

/// Vertices that the vertex shader fetches from buffer textures by gl_VertexID. The names of position,
/// normal, color and texcoord are then buffer samplers with an element for each point. Elements of positions
/// and normals are three components of one texel, or three texels of one component.
struct FamilyPulling {
  std::string pointIds;     // integer buffer sampler: the point of each vertex
  std::string pointOffset;  // uniform, added to the number of a point
  std::string firstVertex;  // uniform: gl_VertexID of the draw's first vertex
  std::string indexedIf;    // uniform; not 0: gl_VertexID is the point, without `pointIds`
  std::string cells;        // integer buffer sampler: the cell of each triangle, for colours and normals
  std::string cellsIf;      // uniform; 0: a triangle's cell is its number
  std::string cellsOffset;  // uniform, added to the number of a triangle before `cells` is read
  int verticesPerCell =
      0;               // of points: so many vertices are one of those triangles; 0: of separate triangles
  bool lines = false;  // each two triangles of a draw are a line, with two elements of `pointIds`
  std::string size;    // uniform: the width of lines or the size of points in pixels
  bool given() const { return !pointIds.empty(); }
};

}  // namespace gluray::gl
