// The instances of a draw whose positions are a matrix of the instance times an attribute of the vertex:
// their matrices, from arrays with a divisor, and which of them may show in front of a depth picture. Loops
// run in the shared arena. A part of a plan of CulledDraws, GL thread.
#pragma once
#include "gl/arrays/arrays.h"
#include "gl/arrays/elements.h"
#include "gl/culled/clusters/clusters.h"
#include "gl/culled/shader_slice/position_slice.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace gluray::gl {

class Instances {
 public:
  /// A column of an attribute of the instance, and its array.
  struct Column {
    ArrayReader array;
    int firstNumber = 1, rows = 4;
  };
  /// Instances that have the same elements of all arrays, because these advance once in `divisor` instances.
  struct Range {
    uint32_t first = 0;      // element of the first instance
    uint32_t instances = 1;  // in all
    uint32_t divisor = 1;
    uint32_t units() const { return (instances - 1) / divisor + 1; }
  };

  /// The columns of `position` whose numbers its terms have, in any order.
  Instances(const LinearPosition& position, std::vector<Column> columns, const Range& range);

  /// Units of instances that are drawn together, as one bit of `visible`.
  uint32_t units() const { return range_.units(); }
  const Range& range() const { return range_; }
  /// Where unit `unit` is, and by how much rounding may move it; nothing where its numbers are too large for
  /// single precision. Elements must exist.
  std::optional<ClipMatrix> matrix(uint32_t unit) const;
  /// Sets bit i of `visible` where the mesh may show in unit i: never misses one (BoxVisibility).
  void mayShow(const Clusters& mesh, const WindowMapping& window, const DepthPyramid* pyramid,
               std::vector<uint64_t>& visible) const;
  /// Instances of the units in `visible`.
  uint64_t instancesIn(const std::vector<uint64_t>& visible) const;
  /// `elements` with only the units [first, end).
  Elements part(Elements elements, uint32_t first, uint32_t end) const;
  /// Calls each(first, end) for runs of units in `visible`, in their order.
  template <class Each>
  void forRuns(const std::vector<uint64_t>& visible, const Each& each) const {
    const uint32_t count = units();
    const auto isSet = [&](uint32_t i) { return (visible[i / 64] >> (i & 63) & 1) != 0; };
    for (uint32_t i = 0; i < count; ++i) {
      if (visible[i / 64] == 0) {
        i |= 63;
      } else if (isSet(i)) {
        const uint32_t first = i;
        while (i + 1 < count && isSet(i + 1)) ++i;
        each(first, i + 1);
      }
    }
  }

 private:
  LinearPosition position_;
  std::vector<Column> columns_;
  Range range_;
};

}  // namespace gluray::gl
