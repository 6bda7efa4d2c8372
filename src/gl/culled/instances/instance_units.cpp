#include "gl/culled/instances/instance_units.h"

#include <bit>
#include <limits>
#include <numeric>
#include <utility>

namespace gluray::gl {

InstanceUnits::InstanceUnits(uint32_t base, uint32_t instances, std::vector<uint32_t> divisors)
    : base_(base), instances_(instances), divisors_(std::move(divisors)) {
  std::ranges::sort(divisors_);
  divisors_.erase(std::unique(divisors_.begin(), divisors_.end()), divisors_.end());
  uint32_t common = 0;
  for (const uint32_t divisor : divisors_) common = std::gcd(common, divisor);
  size_ = std::max(common, 1u);
}

uint64_t InstanceUnits::instancesIn(const std::vector<uint64_t>& visible) const {
  uint64_t set = 0;
  for (const uint64_t word : visible) set += static_cast<uint64_t>(std::popcount(word));
  const uint32_t last = units() - 1;
  const bool hasLast = visible[last / 64] >> (last & 63) & 1;
  return set * size_ - (hasLast ? size_ - part(last, last + 1).count : 0);
}

uint32_t InstanceUnits::most(uint32_t first) const {
  uint32_t most = std::numeric_limits<uint32_t>::max();
  for (const uint32_t divisor : divisors_)
    if (first % divisor != 0) most = std::min(most, divisor - first % divisor);
  return most;
}

}  // namespace gluray::gl
