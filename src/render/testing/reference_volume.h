// A volume's picture by a plain loop over every sample, in doubles: what render::VolumeTracer is compared
// with.
#pragma once
#include "render/testing/reference_rays.h"
#include "render/testing/reference_volume_colors.h"
#include "scene/volumes/volume.h"

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

class ReferenceVolume : ReferenceColors {
 public:
  ReferenceVolume(const scene::VolumeCast& cast, const VolumeBox& box) : ReferenceColors(cast), box_(box) {}

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
      case scene::VolumeBlend::isosurface: isosurfaces(pixel); break;
      default: break;  // those of reference_levels.h
    }
    pixel.unsure = unsure_;
    if (!pixel.shown) pixel.color = glm::dvec4(0), pixel.depth = 2;
    return pixel;
  }

 private:
  glm::dvec3 sampleAt(int i) const { return ray_.first + ray_.step * static_cast<double>(i); }
  void finish(ReferencePixel& pixel, const glm::dvec4& premultiplied) const {
    const glm::dvec3 color(premultiplied);
    const double opacity = premultiplied.a;
    pixel.color = {color * double{volume_.colorScale} + double{volume_.colorBias} * opacity, opacity};
  }
  /// Whether the ray goes on.
  bool addBehind(glm::dvec4& sum, const glm::dvec4& c) {
    sum += (1 - sum.a) * c;
    unsure_ |= std::abs(sum.a - double{volume_.least}) < kNear;
    return sum.a <= double{volume_.least};
  }

  void composite(ReferencePixel& pixel) {
    glm::dvec4 sum(0);
    for (int i = 0; i < ray_.samples; ++i)
      if (!isSkipped(sampleAt(i)) && !addBehind(sum, colorAt(sampleAt(i)))) break;
    pixel.shown = sum.a > 0;
    finish(pixel, sum);
  }

  void extreme(ReferencePixel& pixel, double sign) {
    glm::dvec4 sum(0);
    for (size_t c = 0; c < volume_.channels.size(); ++c) {
      double found = sign > 0 ? 0 : 1;
      bool first = true;
      for (int i = 0; i < ray_.samples; ++i) {
        if (isSkipped(sampleAt(i))) continue;
        const double scalar = scalarAt(sampleAt(i), c);
        found = first ? scalar : sign * std::max(sign * found, sign * scalar);
        first = false;
      }
      // Lit where the shader's loop has left the position: one step after the last sample.
      sum += premultiplied(litColor(found, sampleAt(ray_.samples), c)) * double{volume_.channels[c].weight};
    }
    finish(pixel, sum);
  }

  void average(ReferencePixel& pixel) {
    double sum = 0, all = 0;
    for (size_t c = 0; c < volume_.channels.size(); ++c) {
      double total = 0, count = 0;
      const glm::dvec2 range(volume_.channels[c].range);
      for (int i = 0; i < ray_.samples; ++i) {
        if (isSkipped(sampleAt(i))) continue;
        const double scalar = scalarAt(sampleAt(i), c), value = range.x + (range.y - range.x) * scalar;
        for (const double end : {double{volume_.averaged.x}, double{volume_.averaged.y}})
          unsure_ |= std::abs(value - end) < kNear * std::max(1.0, std::abs(range.y - range.x));
        if (value < double{volume_.averaged.x} || value > double{volume_.averaged.y}) continue;
        total += opacityOf(scalar, c) * scalar, count += 1;
      }
      all += count, sum += total / std::max(count, 1.0) * double{volume_.channels[c].weight};
    }
    pixel.shown = all > 0 || volume_.channels.size() > 1;
    finish(pixel, {glm::dvec3(std::clamp(sum, 0.0, 1.0)), 1});
  }

  void sum(ReferencePixel& pixel) {
    double total = 0;
    for (int i = 0; i < ray_.samples; ++i) {
      if (isSkipped(sampleAt(i))) continue;
      for (size_t c = 0; c < volume_.channels.size(); ++c) {
        const double scalar = scalarAt(sampleAt(i), c);
        total += opacityOf(scalar, c) * scalar * double{volume_.channels[c].weight};
      }
    }
    finish(pixel, {glm::dvec3(std::clamp(total, 0.0, 1.0)), 1});
  }

  /// As the loop of VTK's shader, with an array that begins and ends far outside.
  void isosurfaces(ReferencePixel& pixel) {
    std::vector<double> ends{-1e20};
    ends.insert(ends.end(), volume_.contours.begin(), volume_.contours.end());
    ends.push_back(1e20);
    size_t interval = 0;
    glm::dvec4 sum(0);
    for (int i = 0; i < ray_.samples; ++i) {
      if (isSkipped(sampleAt(i))) continue;
      const double scalar = scalarAt(sampleAt(i));
      for (const double end : ends) unsure_ |= std::abs(scalar - end) < 1e-5;
      if (i == 0) {
        interval = volume_.contours.size() / 2;
        while (scalar > ends[interval]) ++interval;
        while (scalar < ends[interval]) --interval;
        continue;
      }
      const bool below = scalar<ends[interval], above = scalar> ends[interval + 1];
      if (!below && !above) continue;
      const double contour = below ? ends[interval] : ends[interval + 1];
      interval = below ? interval - 1 : interval + 1;
      if (!addBehind(sum, premultiplied(litColor(contour, sampleAt(i))))) break;
    }
    pixel.shown = sum.a > 0;
    finish(pixel, sum);
  }

  const VolumeBox box_;
  ReferenceRay ray_;
};

}  // namespace gluray::test
