// A volume's picture by a plain loop over every sample, in doubles: what render::VolumeTracer is compared
// with.
#pragma once
#include "accel/testing/test_grids.h"
#include "render/testing/reference_rays.h"
#include "scene/volume.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace gluray::test {

/// A pixel. `unsure`: a value lies so near to where a rule has a step (a sample at the end of the ray,
/// nearest voxels and entries, the opacity that ends rays, the range of averages, the direction of a gradient
/// that is almost 0) that the rounding of floats decides, and the pixel cannot be compared.
struct ReferencePixel {
  glm::dvec4 color{0};
  bool shown = false;
  double depth = 2;
  bool unsure = false;
};

class ReferenceVolume {
 public:
  ReferenceVolume(const scene::VolumeCast& cast, const VolumeBox& box)
      : volume_(cast.volume), view_(cast.view), box_(box) {}

  ReferencePixel at(int x, int y) {
    ReferencePixel pixel;
    ray_ = referenceRay(view_, box_, x, y);
    pixel.unsure = ray_.unsure;
    if (!ray_.hits) return pixel;
    towards_ = glm::normalize(view_.viewer - ray_.entry);
    pixel.depth = ray_.depth, pixel.shown = true, unsure_ = ray_.unsure;
    switch (volume_.blend) {
      case scene::VolumeBlend::composite: composite(pixel); break;
      case scene::VolumeBlend::maximum: extreme(pixel, 1); break;
      case scene::VolumeBlend::minimum: extreme(pixel, -1); break;
      case scene::VolumeBlend::average: average(pixel); break;
      case scene::VolumeBlend::additive: sum(pixel); break;
    }
    pixel.unsure = unsure_;
    if (!pixel.shown) pixel.color = glm::dvec4(0), pixel.depth = 2;
    return pixel;
  }

 private:
  static constexpr double kNear = 1e-4;

  glm::dvec3 sampleAt(int i) const { return ray_.first + ray_.step * static_cast<double>(i); }
  /// Marks a number that is near to a whole one.
  double whole(double v) {
    unsure_ |= std::abs(v - std::round(v)) < kNear;
    return std::floor(v);
  }
  double scalarAt(const glm::dvec3& p) {
    if (!volume_.linear)
      for (int axis = 0; axis < 3; ++axis) whole(p[axis] * volume_.grid->size[axis]);
    const double value = volume_.linear ? linearAt(*volume_.grid, p) : nearestAt(*volume_.grid, p);
    return value * double{volume_.scale} + double{volume_.bias};
  }
  glm::dvec3 entryOf(const scene::VolumeTable& table, int i) const {
    glm::dvec3 entry(0);
    for (int c = 0; c < table.channels; ++c)
      entry[c] = double{
          table.values[static_cast<size_t>(std::clamp(i, 0, table.entries() - 1) * table.channels + c)]};
    return entry;
  }
  glm::dvec3 lookUp(const scene::VolumeTable& table, double at) {
    const double u = at * table.entries();
    if (!table.linear) return entryOf(table, static_cast<int>(std::clamp(whole(u), -1.0, 1e6)));
    const double v = std::clamp(u - 0.5, 0.0, table.entries() - 1.0);
    const int low = static_cast<int>(v);
    return glm::mix(entryOf(table, low), entryOf(table, low + 1), v - low);
  }

  glm::dvec3 differencesAt(const glm::dvec3& p) {
    glm::dvec3 differences;
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 h(0);
      h[axis] = double{volume_.cellStep[axis]};
      differences[axis] = scalarAt(p + h) - scalarAt(p - h);
    }
    return differences;
  }

  glm::dvec4 litColor(double scalar, const glm::dvec3& p) {
    const glm::dvec3 color = lookUp(volume_.color, scalar);
    double opacity = lookUp(volume_.opacity, scalar).x;
    glm::dvec3 shown = color;
    const glm::dvec3 spacing(volume_.cellSpacing);
    if (volume_.gradientOpacity || volume_.light.enabled) {
      const glm::dvec3 differences = differencesAt(p);
      const double range = double{volume_.range.y - volume_.range.x};
      if (volume_.gradientOpacity) {
        const glm::dvec3 aspect = spacing * 2.0 / ((spacing.x + spacing.y + spacing.z) / 3);
        const double length = glm::length(differences * range / aspect);
        const double strength = length / (0.25 * (range != 0 ? range : 1));
        opacity *= lookUp(*volume_.gradientOpacity, std::clamp(strength, 0.0, 1.0)).x;
      }
      if (volume_.light.enabled) shown = lit(color, differences / spacing);
    }
    return glm::clamp(glm::dvec4(shown, opacity), 0.0, 1.0);
  }

  glm::dvec3 lit(const glm::dvec3& color, const glm::dvec3& gradient) {
    const scene::VolumeLight& light = volume_.light;
    const glm::dvec3 fromLight = -towards_;
    const double length = glm::length(gradient);
    unsure_ |= length > 0 && length < 0.02;
    const glm::dvec3 normal = length > 0 ? gradient / length : glm::dvec3(0);
    double cosine = glm::dot(normal, fromLight);
    const glm::dvec3 reflected = 2 * cosine * normal - fromLight;
    const double shine = std::max(glm::dot(reflected, fromLight), 0.0);
    if (light.twoSided) cosine = std::abs(cosine);
    unsure_ |= std::abs(cosine) < 1e-4 && light.shininess < 1;
    glm::dvec3 sum = glm::dvec3(light.ambient) * color;
    if (cosine > 0)
      sum += cosine * glm::dvec3(light.diffuse) * color +
             std::pow(shine, double{light.shininess}) * glm::dvec3(light.specular);
    return sum;
  }

  void finish(ReferencePixel& pixel, const glm::dvec3& premultiplied, double opacity) const {
    pixel.color = {premultiplied * double{volume_.colorScale} + double{volume_.colorBias} * opacity, opacity};
  }

  void composite(ReferencePixel& pixel) {
    glm::dvec3 color(0);
    double opacity = 0;
    for (int i = 0; i < ray_.samples; ++i) {
      const double scalar = scalarAt(sampleAt(i));
      if (!(lookUp(volume_.opacity, scalar).x > 0)) continue;
      const glm::dvec4 c = litColor(scalar, sampleAt(i));
      color += (1 - opacity) * c.a * glm::dvec3(c), opacity += (1 - opacity) * c.a;
      unsure_ |= std::abs(opacity - double{volume_.least}) < kNear;
      if (opacity > double{volume_.least}) break;
    }
    pixel.shown = opacity > 0;
    finish(pixel, color, opacity);
  }

  void extreme(ReferencePixel& pixel, double sign) {
    double found = scalarAt(ray_.first);
    for (int i = 1; i < ray_.samples; ++i)
      found = sign * std::max(sign * found, sign * scalarAt(sampleAt(i)));
    // Lit where the shader's loop has left the position: one step after the last sample.
    const glm::dvec4 c = litColor(found, sampleAt(ray_.samples));
    finish(pixel, glm::dvec3(c) * c.a, c.a);
  }

  void average(ReferencePixel& pixel) {
    double total = 0, count = 0;
    const double least = double{volume_.range.x}, most = double{volume_.range.y};
    for (int i = 0; i < ray_.samples; ++i) {
      const double scalar = scalarAt(sampleAt(i)), value = least + (most - least) * scalar;
      for (const double end : {double{volume_.averaged.x}, double{volume_.averaged.y}})
        unsure_ |= std::abs(value - end) < kNear * std::max(1.0, std::abs(most - least));
      if (value < double{volume_.averaged.x} || value > double{volume_.averaged.y}) continue;
      total += lookUp(volume_.opacity, scalar).x * scalar, count += 1;
    }
    pixel.shown = count > 0;
    finish(pixel, glm::dvec3(std::clamp(total / std::max(count, 1.0), 0.0, 1.0)), 1);
  }

  void sum(ReferencePixel& pixel) {
    double total = 0;
    for (int i = 0; i < ray_.samples; ++i) {
      const double scalar = scalarAt(sampleAt(i));
      total += lookUp(volume_.opacity, scalar).x * scalar;
    }
    finish(pixel, glm::dvec3(std::clamp(total, 0.0, 1.0)), 1);
  }

  const scene::Volume& volume_;
  const scene::VolumeView& view_;
  const VolumeBox box_;
  ReferenceRay ray_;
  glm::dvec3 towards_{0};
  bool unsure_ = false;
};

}  // namespace gluray::test
