#include "gl/culled/shader_slice/slice_matrices.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace gluray::gl::glsl {
namespace {

/// The inverse of a known matrix, with the rounding errors of elimination.
template <int N>
Value inverseOf(const Value& m) {
  glm::mat<N, N, double> matrix(0);
  double most = 0;
  for (int c = 0; c < N; ++c)
    for (int r = 0; r < N; ++r)
      matrix[c][r] = elementOf(m, c, r).value(), most = std::max(most, elementOf(m, c, r).magnitude());
  if (glm::determinant(matrix) == 0) return Value::unknown(m.shape);
  const glm::mat<N, N, double> inverse = glm::inverse(matrix);
  double mostInverse = 0;
  for (int c = 0; c < N; ++c)
    for (int r = 0; r < N; ++r) mostInverse = std::max(mostInverse, std::abs(inverse[c][r]));
  Value result = m;
  for (int c = 0; c < N; ++c)
    for (int r = 0; r < N; ++r) {
      Linear l = Linear::constant(inverse[c][r], false);
      // First-order error of an inverse: inverse times error times inverse.
      l.magnitudes[4] = 16 * N * N * mostInverse * most * mostInverse + std::abs(inverse[c][r]);
      result.components[static_cast<size_t>(c * N + r)] = l;
    }
  return result;
}

}  // namespace

Value multiplied(const Value& a, const Value& b) {
  const bool rowVector = !a.shape.isMatrix();
  const int inner = rowVector ? a.shape.rows : a.shape.columns;
  if (b.shape.rows != inner) return {};
  const int rows = rowVector ? 1 : a.shape.rows, columns = b.shape.columns;
  std::vector<Linear> all;
  for (int c = 0; c < columns; ++c)
    for (int r = 0; r < rows; ++r) {
      Linear total = Linear::constant(0);
      for (int k = 0; k < inner; ++k) {
        const Linear& left = rowVector ? a.components[static_cast<size_t>(k)] : elementOf(a, k, r);
        total = sum(total, product(left, elementOf(b, c, k)));
      }
      all.push_back(total);
    }
  const Shape shape =
      rowVector ? Shape{Shape::Base::floats, 1, columns} : Shape{Shape::Base::floats, columns, rows};
  return valueOf(shape, std::move(all));
}

Value transposed(const Value& m) {
  std::vector<Linear> all;
  for (int r = 0; r < m.shape.rows; ++r)
    for (int c = 0; c < m.shape.columns; ++c) all.push_back(elementOf(m, c, r));
  return valueOf({Shape::Base::floats, m.shape.rows, m.shape.columns}, std::move(all));
}

Value inverted(const Value& m) {
  if (!m.areConstants() || m.shape.columns != m.shape.rows) return Value::unknown(m.shape);
  return m.shape.rows == 2 ? inverseOf<2>(m) : m.shape.rows == 3 ? inverseOf<3>(m) : inverseOf<4>(m);
}

}  // namespace gluray::gl::glsl
