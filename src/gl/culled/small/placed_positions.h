// Computes a program's vertex transform for many draws that differ in some uniforms: interprets the vertex
// shader once, with these uniforms as variables. A part of CulledProgram, GL thread, context current.
#pragma once
#include "gl/culled/clusters/box_visibility.h"
#include "gl/culled/shader_slice/position_slice.h"
#include "gl/culled/small/noted_uniforms.h"

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::gl {

/// A vertex transform for the current values of uniforms.
struct PlacedPosition {
  const LinearPosition* position = nullptr;  // its attribute; valid until the next call
  ClipMatrix matrix;
};

class PlacedPositions {
 public:
  /// `slice` must outlive it.
  explicit PlacedPositions(const PositionSlice& slice) : slice_(slice) {}

  /// Returns false if not linear in one vertex attribute, or too expensive to evaluate.
  bool find(const CurrentUniforms& uniforms, PlacedPosition& found);

 private:
  using Names = std::set<std::string, std::less<>>;
  struct Entry {
    std::vector<ReadUniform> read;                // the entry is valid while these values are equal
    std::vector<CurrentUniforms::Place> symbols;  // uniforms of the position's columns, in their order
    std::optional<LinearPosition> position;       // nullopt: not linear
  };

  Entry* known(const CurrentUniforms& uniforms);
  Entry& runAgain(const CurrentUniforms& uniforms);
  Entry run(const CurrentUniforms& uniforms, const Names& symbolic);
  static bool evaluate(const Entry& entry, const CurrentUniforms& uniforms, ClipMatrix& matrix);

  const PositionSlice& slice_;
  std::vector<Entry> entries_;
  Names symbolic_;  // uniforms that changed between draws, treated as variables
  Names constant_;  // uniforms on which positions do not depend polynomially
  uint64_t runs_ = 0, calls_ = 0;
};

}  // namespace gluray::gl
