#include "bench/data/image_error.h"

#include <cmath>
#include <cstddef>

namespace gluray::bench {

double psnr(const std::vector<uint32_t>& image, const std::vector<uint32_t>& reference,
            const std::vector<uint8_t>& hit) {
  double squares = 0, count = 0;
  for (size_t i = 0; i < hit.size(); ++i) {
    if (!hit[i]) continue;
    for (unsigned shift = 0; shift < 24; shift += 8) {
      const double d = double((image[i] >> shift) & 255u) - double((reference[i] >> shift) & 255u);
      squares += d * d, count += 1;
    }
  }
  if (squares == 0) return 99;
  return 10 * std::log10(255.0 * 255.0 * count / squares);
}

}  // namespace gluray::bench
