// Groups the instances of a draw into units that can be drawn separately, by element numbers of their arrays.
// Calls no OpenGL. A part of a plan of CulledDraws, GL thread.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray::gl {

/// Consecutive instances of a draw; numbers begin with 0, whatever the base instance is.
struct InstancePart {
  uint32_t first = 0, count = 1;
};

class InstanceUnits {
 public:
  /// A draw of `instances`, at least one, whose arrays advance once in each of `divisors` instances. Array
  /// element `base` is that of the first instance.
  InstanceUnits(uint32_t base, uint32_t instances, std::vector<uint32_t> divisors);

  uint32_t base() const { return base_; }
  uint32_t instances() const { return instances_; }
  /// Instances of a unit, which have the same elements of all arrays; the last unit may have fewer.
  uint32_t size() const { return size_; }
  uint32_t units() const { return (instances_ - 1) / size_ + 1; }
  /// Whether arrays advance at different rates, so that no base instance fits all of them.
  bool areMixed() const { return divisors_.size() > 1; }
  /// The element that an array with a divisor has at unit `unit`.
  uint32_t element(uint32_t unit, uint32_t divisor) const { return base_ + unit * size_ / divisor; }
  /// One past the last element that the draw reads of it.
  uint64_t endElement(uint32_t divisor) const { return uint64_t{base_} + (instances_ - 1) / divisor + 1; }

  /// The units [first, end).
  InstancePart part(uint32_t first, uint32_t end) const {
    const uint32_t begin = first * size_;
    return {begin, static_cast<uint32_t>(std::min(uint64_t{end} * size_, uint64_t{instances_})) - begin};
  }
  /// Instances of the units in `visible`.
  uint64_t instancesIn(const std::vector<uint64_t>& visible) const;
  /// Maximum number of instances from `first` on that can be drawn together: limited by arrays whose current
  /// element does not begin with `first`.
  uint32_t most(uint32_t first) const;

  /// Calls each(part) for the units in `visible`, in their order, where instance i of each part has element
  /// part.first / divisor + i / divisor of all arrays.
  template <class Each>
  void forParts(const std::vector<uint64_t>& visible, const Each& each) const {
    const uint32_t count = units();
    const auto isSet = [&](uint32_t i) { return (visible[i / 64] >> (i & 63) & 1) != 0; };
    for (uint32_t i = 0; i < count; ++i) {
      if (visible[i / 64] == 0) {
        i |= 63;
      } else if (isSet(i)) {
        const uint32_t first = i;
        while (i + 1 < count && isSet(i + 1)) ++i;
        for (InstancePart run = part(first, i + 1); run.count > 0;) {
          const uint32_t now = std::min(run.count, most(run.first));
          each(InstancePart{run.first, now});
          run.first += now, run.count -= now;
        }
      }
    }
  }

 private:
  uint32_t base_, instances_, size_ = 1;
  std::vector<uint32_t> divisors_;  // without duplicates
};

}  // namespace gluray::gl
