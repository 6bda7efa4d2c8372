#include "render/lights/distribution2d.h"

#include <algorithm>

namespace gluray::render {
namespace {

/// Cumulative shares of `count` values; even ones where all are 0. Returns their sum.
template <class Value>
double accumulate(const Value* values, int count, float* sums) {
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += double(values[i]);
  double until = 0;
  for (int i = 0; i < count; ++i) {
    sums[i] = static_cast<float>(sum > 0 ? until / sum : double(i) / count);
    until += double(values[i]);
  }
  sums[count] = 1;
  return sum;
}

}  // namespace

Distribution2D::Distribution2D(const std::vector<float>& values, int width, int height)
    : width_(width), height_(height), values_(values) {
  const auto w = static_cast<size_t>(width), h = static_cast<size_t>(height);
  rows_.resize(h + 1), columns_.resize(h * (w + 1));
  std::vector<double> sums(h);
  for (size_t y = 0; y < h; ++y) sums[y] = accumulate(&values_[y * w], width, &columns_[y * (w + 1)]);
  total_ = accumulate(sums.data(), height, rows_.data()) / (double(width) * height);
  if (empty()) return;
  for (float& v : values_) v = static_cast<float>(double{v} / total_);
}

int Distribution2D::find(const float* sums, int count, float u, float& within) {
  const float* end = sums + count + 1;
  const float* after = std::upper_bound(sums, end, u);
  // Cells of no width are not drawn: after is the first sum above u.
  const int i = std::clamp(static_cast<int>(after - sums) - 1, 0, count - 1);
  const float width = sums[i + 1] - sums[i];
  within = width > 0 ? std::clamp((u - sums[i]) / width, 0.0f, 0x1.fffffep-1f) : 0;
  return i;
}

glm::vec2 Distribution2D::sample(const glm::vec2& u, float& pdf) const {
  pdf = 0;
  if (empty()) return glm::vec2(0);
  glm::vec2 within;
  const int y = find(rows_.data(), height_, u.y, within.y);
  const int x =
      find(&columns_[static_cast<size_t>(y) * static_cast<size_t>(width_ + 1)], width_, u.x, within.x);
  pdf = values_[static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x)];
  return {(static_cast<float>(x) + within.x) / static_cast<float>(width_),
          (static_cast<float>(y) + within.y) / static_cast<float>(height_)};
}

float Distribution2D::pdf(const glm::vec2& at) const {
  if (empty()) return 0;
  const auto cell = [](float t, int count) {
    return static_cast<size_t>(std::clamp(static_cast<int>(t * static_cast<float>(count)), 0, count - 1));
  };
  return values_[cell(at.y, height_) * static_cast<size_t>(width_) + cell(at.x, width_)];
}

}  // namespace gluray::render
