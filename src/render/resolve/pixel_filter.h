// Filters over the samples in and around a pixel (setting pixel-filter). Made once a frame, any thread.
#pragma once
#include "settings/settings.h"

#include <glm/glm.hpp>

#include <vector>

namespace gluray::render {

/// A separable filter along one axis, up to a constant factor.
class FilterCurve {
 public:
  explicit FilterCurve(PixelFilter filter) : filter_(filter) {}
  /// At `x` pixels from the pixel's centre; 0 beyond radius().
  double operator()(double x) const;
  double radius() const;

 private:
  PixelFilter filter_;
};

/// Where samples of a pixel lie in the unit square: the R2 sequence (M. Roberts, "The Unreasonable
/// Effectiveness of Quasirandom Sequences", 2018), which starts at the centre; every prefix is evenly
/// distributed.
std::vector<glm::dvec2> positionsInPixel(int count);

struct FilteredSamples {
  std::vector<glm::dvec2> positions;  // from the pixel's lower left corner, in pixels
  std::vector<float> weights;         // empty: all 1
};

/// Filter importance sampling (M. Ernst and others, "Filter Importance Sampling", 2006): places points of the
/// unit square in proportion to the filter's magnitude, so that weights are 1, or -1 where it is negative.
/// The centre of the square maps to the centre of the pixel. The box filter does not move points.
FilteredSamples filteredSamples(PixelFilter, std::vector<glm::dvec2> unitSquare);

}  // namespace gluray::render
