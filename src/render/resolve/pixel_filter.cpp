#include "render/resolve/pixel_filter.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

/// pbrt-v4's default: a standard deviation of half a pixel, and 0 at the radius.
double gauss(double x) {
  constexpr double kSigma = 0.5, kRadius = 1.5;
  const auto bell = [](double at) { return std::exp(-at * at / (2 * kSigma * kSigma)); };
  return bell(x) - bell(kRadius);
}

/// F. Harris, "On the Use of Windows for Harmonic Analysis with the Discrete Fourier Transform", 1978: four
/// terms, -92 dB.
double blackmanHarris(double x) {
  constexpr double kRadius = 1.5;
  const double a = M_PI * (x / kRadius + 1);
  return 0.35875 - 0.48829 * std::cos(a) + 0.14128 * std::cos(2 * a) - 0.01168 * std::cos(3 * a);
}

/// D. Mitchell and A. Netravali, "Reconstruction Filters in Computer Graphics", 1988, with B = C = 1/3.
double mitchell(double x) {
  constexpr double b = 1.0 / 3, c = 1.0 / 3;
  x = std::abs(x);
  if (x < 1) return ((12 - 9 * b - 6 * c) * x * x * x + (-18 + 12 * b + 6 * c) * x * x + 6 - 2 * b) / 6;
  return ((-b - 6 * c) * x * x * x + (6 * b + 30 * c) * x * x + (-12 * b - 48 * c) * x + 8 * b + 24 * c) / 6;
}

/// Inverse of the cumulated magnitude of a curve.
class SamplePlacement {
 public:
  explicit SamplePlacement(const FilterCurve& curve) : radius_(curve.radius()) {
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      sums_.push_back(sum);
      sum += std::abs(curve(at(i + 0.5)));
    }
    sums_.push_back(sum);
  }
  /// For u in [0, 1).
  double operator()(double u) const {
    const double sum = u * sums_.back();
    const auto next = std::upper_bound(sums_.begin() + 1, sums_.end() - 1, sum);
    const double before = *(next - 1), step = *next - before;
    return at(static_cast<double>(next - 1 - sums_.begin()) + (step > 0 ? (sum - before) / step : 0));
  }

 private:
  static constexpr int kSteps = 4096;
  double at(double step) const { return (2 * step / kSteps - 1) * radius_; }
  double radius_;
  std::vector<double> sums_;
};

}  // namespace

double FilterCurve::operator()(double x) const {
  if (std::abs(x) > radius()) return 0;
  switch (filter_) {
    case PixelFilter::box: return 1;
    case PixelFilter::gauss: return gauss(x);
    case PixelFilter::blackmanHarris: return blackmanHarris(x);
    case PixelFilter::mitchell: return mitchell(x);
  }
  return 0;
}

double FilterCurve::radius() const {
  if (filter_ == PixelFilter::box) return 0.5;
  return filter_ == PixelFilter::mitchell ? 2 : 1.5;
}

std::vector<glm::dvec2> positionsInPixel(int count) {
  constexpr double kPlastic = 1.32471795724474602596;
  std::vector<glm::dvec2> positions;
  for (int i = 0; i < std::max(count, 1); ++i)
    positions.push_back(
        glm::fract(0.5 + static_cast<double>(i) * glm::dvec2(1 / kPlastic, 1 / (kPlastic * kPlastic))));
  return positions;
}

FilteredSamples filteredSamples(PixelFilter filter, std::vector<glm::dvec2> unitSquare) {
  if (filter == PixelFilter::box) return {std::move(unitSquare), {}};
  const FilterCurve curve(filter);
  const SamplePlacement placed(curve);
  FilteredSamples samples{std::move(unitSquare), {}};
  for (glm::dvec2& at : samples.positions) {
    const glm::dvec2 from(placed(at.x), placed(at.y));
    samples.weights.push_back(curve(from.x) * curve(from.y) < 0 ? -1.0f : 1.0f);
    at = from + 0.5;
  }
  return samples;
}

}  // namespace gluray::render
