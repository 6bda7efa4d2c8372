// Samples points of the unit square in proportion to a function that is constant in each cell of a grid. Made
// once, called on all tracing threads.
#pragma once
#include <glm/glm.hpp>

#include <vector>

namespace gluray::render {

class Distribution2D {
 public:
  Distribution2D() = default;
  /// `values`: not negative, row by row from y = 0; width * height of them.
  Distribution2D(const std::vector<float>& values, int width, int height);
  /// Whether all values are 0.
  bool empty() const { return !(total_ > 0); }
  /// Samples a point of [0, 1)^2, and sets its density; density 0 if empty().
  glm::vec2 sample(const glm::vec2& u, float& pdf) const;
  float pdf(const glm::vec2& at) const;

 private:
  /// Finds the cell whose interval of the cumulative sums contains u, and the position of u within the
  /// interval.
  static int find(const float* sums, int count, float u, float& within);

  int width_ = 0, height_ = 0;
  double total_ = 0;            // mean of the values
  std::vector<float> values_;   // relative to the mean
  std::vector<float> rows_;     // cumulative shares of rows, height + 1
  std::vector<float> columns_;  // of columns in each row, width + 1 each
};

}  // namespace gluray::render
