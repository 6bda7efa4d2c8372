// Pictures of volumes with one map for colours and opacities (scene::VolumeLevels) by a plain loop in
// doubles.
#pragma once
#include "render/testing/reference_volume.h"
#include "scene/volumes/volume.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace gluray::test {

class ReferenceLevels : ReferenceColors {
 public:
  explicit ReferenceLevels(const scene::VolumeCast& cast)
      : ReferenceColors(cast), levels_(volume_.levels), span_(*view_.span) {}

  ReferencePixel at(int x, int y) {
    ReferencePixel pixel;
    unsure_ = false, first_ = step_ = glm::dvec3(0), samples_ = 0;
    findRay(x, y);
    pixel.shown = samples_ > 0;
    place_ = 0;
    if (pixel.shown) pixel.color = blended(pixel.shown);
    pixel.color.a *= double{levels_.opacity};
    if (pixel.shown) pixel.depth = depth();
    if (!pixel.shown) pixel.color = glm::dvec4(0), pixel.depth = 2;
    pixel.unsure = unsure_;
    return pixel;
  }

 private:
  using Blend = scene::VolumeBlend;
  static constexpr double kClose = 1e-5;

  glm::dvec3 windowPoint(const glm::dvec2& pixel, double depth) const {
    const glm::dvec4 p = glm::inverse(view_.windowFromData) * glm::dvec4(pixel, depth, 1);
    return glm::dvec3(p) / p.w;
  }

  void findRay(int x, int y) {
    const glm::dvec2 pixel(view_.region.x + x + 0.5, view_.region.y + y + 0.5);
    if (pixel.x < span_.window.x || pixel.x > span_.window.y || pixel.y < span_.window.z ||
        pixel.y > span_.window.w)
      return;
    const glm::dvec3 near = windowPoint(pixel, 0), far = windowPoint(pixel, 1);
    along_ = glm::normalize(far - near);
    double enters = 0, leaves = glm::length(far - near);
    const double farthest = leaves, edge = 0.01 * glm::length(span_.size);
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (-0.5 - near[axis]) / along_[axis],
                   b = (span_.size[axis] - 0.5 - near[axis]) / along_[axis];
      // Between two faces, whose corners are rounded to a grid, either may be the last one.
      unsure_ |= std::abs(leaves - std::max(a, b)) < edge;
      enters = std::max(enters, std::min(a, b)), leaves = std::min(leaves, std::max(a, b));
    }
    const double steps = (leaves - enters) / span_.step + 0.5;
    unsure_ |= std::abs(leaves - enters) < 5 * edge || std::abs(steps - std::round(steps)) < kNear;
    if (steps < 1 || leaves >= farthest) return;
    unsure_ |= farthest - leaves < kNear;
    samples_ = static_cast<int>(steps);
    first_ = (near + along_ * enters + span_.shift) / span_.size;
    step_ = along_ * (leaves - enters) / span_.size / double(samples_);
    end_ = near + along_ * leaves;
  }

  double depth() const {
    glm::dvec4 at = view_.windowFromData * glm::dvec4(end_, 1);
    if (!span_.showsDepth) return at.z / at.w;
    const Blend b = volume_.blend;
    const bool front = b == Blend::over || b == Blend::screened || b == Blend::mean;
    const glm::dvec3 data = (first_ + step_ * place_) * span_.size - (front ? span_.shift : 0);
    at = span_.depthFromData * glm::dvec4(data, 1);
    return std::clamp((at.z / at.w + 1) / 2, 0.0, 1.0);
  }

  double sample(double number) { return scalarAt(first_ + step_ * number); }
  bool isCut(int i) {
    for (const glm::vec4& plane : levels_.planes) {
      const double side = glm::dot(glm::dvec4(plane), glm::dvec4(first_ + step_ * double(i), 1));
      unsure_ |= std::abs(side) < kClose;
      if (side < 0) return true;
    }
    return false;
  }
  void near(double a, double b) { unsure_ |= std::abs(a - b) < kClose && a != b; }

  glm::dvec4 mapEntry(int i) const {
    const auto& values = volume_.channels[0].color.values;
    glm::dvec4 entry;
    for (int c = 0; c < 4; ++c)
      entry[c] = double{values[static_cast<size_t>(4 * std::clamp(i, 0, int(values.size() / 4) - 1) + c)]};
    return entry;
  }
  glm::dvec4 mapped(double value) {
    const glm::dvec2 ends(levels_.limits);
    const double inside = std::clamp(value, std::min(ends.x, ends.y), std::max(ends.x, ends.y));
    const scene::VolumeTable& map = volume_.channels[0].color;
    const double level = (inside - ends.x) / (ends.y - ends.x), gamma = double{levels_.gamma};
    unsure_ |= level > 0 && gamma * std::pow(level, gamma - 1) > 3;  // a power that enlarges rounding
    const double u = std::pow(level, gamma) * (map.entries() - 1) + 0.5;
    if (!map.linear) return mapEntry(static_cast<int>(whole(u)));
    const double v = std::clamp(u - 0.5, 0.0, map.entries() - 1.0);
    return glm::mix(mapEntry(static_cast<int>(v)), mapEntry(static_cast<int>(v) + 1), v - std::floor(v));
  }

  glm::dvec4 blended(bool& shown) {
    switch (volume_.blend) {
      case Blend::refinedMaximum: return refined(shown, 1);
      case Blend::refinedMinimum: return refined(shown, -1);
      case Blend::attenuatedMaximum: return attenuated(shown);
      case Blend::over: return over(shown);
      case Blend::screened: return screened(shown);
      case Blend::mean: return mean(shown);
      default: return surface(shown);
    }
  }

  glm::dvec4 refined(bool& shown, double sign) {
    double found = sign * double{sign > 0 ? levels_.leastMaximum : levels_.mostMinimum};
    const double limit = sign * double{sign > 0 ? levels_.limits.y : levels_.limits.x};
    int at = -1;
    for (int i = 0; i < samples_; ++i) {
      if (isCut(i)) continue;
      const double value = sign * sample(i);
      near(value, found), near(value, limit);
      if (!(value > found)) continue;
      found = value, at = i;
      if (found >= limit) break;
    }
    shown = at >= 0;
    if (!shown) return {};
    place_ = at - 0.5;
    for (int i = 0; i < 10; ++i) {
      const double value = sign * sample(at - 0.5 + 0.1 * i);
      if (i != 5) near(value, found);
      if (i != 5 && value > found) found = value, place_ = at - 0.5 + 0.1 * i;
    }
    return mapped(sign * found);
  }

  glm::dvec4 attenuated(bool& shown) {
    const glm::dvec2 ends(levels_.limits);
    double found = double{levels_.leastMaximum}, sum = 0;
    int at = -1;
    for (int i = 0; i < samples_; ++i) {
      if (isCut(i)) continue;
      const double value = sample(i);
      sum += double{levels_.attenuationStep} * std::clamp((value - ends.x) / (ends.y - ends.x), 0.0, 1.0);
      const double scale = std::exp(-double{levels_.attenuation} * (sum - 1));
      near(found, scale * ends.y), near(value * scale, found);
      if (found > scale * ends.y) break;
      if (value * scale > found) found = value * scale, at = i;
    }
    shown = at >= 0, place_ = at;
    return shown ? mapped(found) : glm::dvec4(0);
  }

  glm::dvec4 over(bool& shown) {
    glm::dvec4 sum(0);
    shown = false;
    for (int i = 0; i < samples_; ++i) {
      if (isCut(i)) continue;
      shown = true;
      const glm::dvec4 c = mapped(sample(i));
      const double a1 = sum.a, a2 = c.a * (1 - a1), alpha = std::max(a1 + a2, 0.001);
      sum = sum * (a1 / alpha) + c * (a2 / alpha);
      sum.a = alpha;
      near(alpha, 0.99);
      if (alpha > 0.99) break;
    }
    return sum;
  }

  glm::dvec4 screened(bool& shown) {
    glm::dvec4 sum(0);
    shown = false;
    for (int i = 0; i < samples_; ++i)
      if (!isCut(i)) shown = true, sum = 1.0 - (1.0 - sum) * (1.0 - mapped(sample(i)));
    return sum;
  }

  glm::dvec4 mean(bool& shown) {
    double sum = 0, count = 0;
    for (int i = 0; i < samples_; ++i)
      if (!isCut(i)) sum += sample(i), count += 1;
    shown = count > 0;
    return shown ? mapped(sum / count) : glm::dvec4(0);
  }

  glm::dvec4 surface(bool& shown) {
    const double threshold = double{levels_.threshold};
    shown = false;
    for (int i = 0; i < samples_ && !shown; ++i) {
      if (isCut(i)) continue;
      const double value = sample(i);
      near(value, threshold - 0.2);
      if (!(value > threshold - 0.2)) continue;
      for (int part = 0; part < 10 && !shown; ++part) {
        place_ = i - 1 + 0.1 * part;
        near(sample(place_), threshold);
        shown = sample(place_) > threshold;
      }
    }
    return shown ? mapped(lit(first_ + step_ * place_)) : glm::dvec4(0);
  }
  double lit(const glm::dvec3& p) {
    double most = scalarAt(p);
    glm::dvec3 normal(0);
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 by(0);
      by[axis] = double{volume_.cellStep[axis]};
      const double before = scalarAt(p - by), after = scalarAt(p + by);
      normal[axis] = before - after, most = std::max({most, before, after});
    }
    unsure_ |= glm::length(normal) < 0.1;  // its direction has an error
    const double cosine = std::abs(glm::dot(glm::normalize(normal), along_));
    return most * (0.2 + cosine) + std::pow(cosine, 40.0);
  }

  const scene::VolumeLevels& levels_;
  const scene::VolumeSpan& span_;
  glm::dvec3 first_, step_, along_, end_;
  int samples_ = 0;
  double place_ = 0;  // number of the sample whose depth is shown
};

}  // namespace gluray::test
