#include "bench/paper/paper_data.h"

#include <tbb/parallel_for.h>

namespace gluray::bench {

void place(TriangleMesh& mesh, const std::array<float, 3>& origin, float step, float scale) {
  tbb::parallel_for(size_t(0), mesh.positions.size(), [&](size_t i) {
    Vertex& v = mesh.positions[i];
    v = {scale * (origin[0] + step * v.x), scale * (origin[1] + step * v.y),
         scale * (origin[2] + step * v.z)};
  });
}

}  // namespace gluray::bench
