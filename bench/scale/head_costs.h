// What an image costs the head of a job: its share of the work that no other rank can take over.
#pragma once
#include "base/image.h"

#include <vector>

namespace gluray::bench {

/// Seconds of CPU time.
struct HeadCosts {
  double take = 0;  // a traced tile: reading its message, putting its pixels in place
  double give = 0;  // after it: looking what each rank gets next
};

/// Measured by cluster::RequestedImage with `ranks` ranks of `threads` threads, whose tiles come back in
/// turn. `costs`: of the tiles.
HeadCosts headCosts(const Image& image, const std::vector<float>& costs, int ranks, int threads);

}  // namespace gluray::bench
