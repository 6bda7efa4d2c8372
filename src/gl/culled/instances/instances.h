// The instances of a draw whose positions are an instance matrix times a vertex attribute. Reads their
// matrices from arrays with a divisor, and finds the instances that may be visible in front of a depth
// image. Loops run in the shared arena. A part of a plan of CulledDraws, GL thread.
#pragma once
#include "gl/arrays/arrays.h"
#include "gl/culled/clusters/clusters.h"
#include "gl/culled/instances/instance_units.h"
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
    bool fractions = false;  // converted signed integers: the lowest may be -1 or less
  };

  /// `columns`: in any order, with all numbers that the terms of `position` use. Each array has all elements.
  Instances(const LinearPosition& position, std::vector<Column> columns, const InstanceUnits& units);

  /// Matrix of unit `unit` with bounds for rounding; none if its values are unknown or too large for single
  /// precision.
  std::optional<ClipMatrix> matrix(uint32_t unit) const;
  /// Sets bit i of `visible` if the mesh may be visible in unit i; conservative (BoxVisibility).
  void mayShow(const Clusters& mesh, const WindowMapping& window, const DepthPyramid* pyramid,
               std::vector<uint64_t>& visible) const;

 private:
  LinearPosition position_;
  std::vector<Column> columns_;
  InstanceUnits units_;
};

}  // namespace gluray::gl
