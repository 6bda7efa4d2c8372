// Colours of a volume's samples in doubles: channels, transfer functions, gradients, light.
#pragma once
#include "accel/testing/test_grids.h"
#include "scene/volumes/volume.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace gluray::test {

class ReferenceColors {
 protected:
  ReferenceColors(const scene::VolumeCast& cast) : volume_(cast.volume), view_(cast.view) {}
  static constexpr double kNear = 1e-4;

  /// Marks a number that is near to a whole one.
  double whole(double v) {
    unsure_ |= std::abs(v - std::round(v)) < kNear;
    return std::floor(v);
  }
  double valueAt(const scene::VoxelGrid& grid, bool linear, const glm::dvec3& p, int channel) {
    for (int axis = 0; axis < 3 && !linear; ++axis) whole(p[axis] * grid.size[axis]);
    return linear ? linearAt(grid, p, channel) : nearestAt(grid, p, channel);
  }
  double scalarAt(const glm::dvec3& p, size_t channel = 0) {
    const scene::VolumeChannel& c = volume_.channels[channel];
    return valueAt(*volume_.grid, volume_.linear, p, static_cast<int>(channel)) * double{c.scale} +
           double{c.bias};
  }
  static glm::dvec3 entryOf(const scene::VolumeTable& table, int i) {
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
  glm::dvec4 lookUp(const scene::VolumeTable2D& table, const glm::dvec2& at) {
    const glm::dvec2 u = at * glm::dvec2(table.size);
    const auto entry = [&](const glm::ivec2& e) {
      const glm::ivec2 inside = glm::clamp(e, glm::ivec2(0), table.size - 1);
      return glm::dvec4(table.values[static_cast<size_t>(inside.y * table.size.x + inside.x)]);
    };
    if (!table.linear) {
      const glm::dvec2 place = glm::clamp(u, -1.0, 1e6);
      return entry({whole(place.x), whole(place.y)});
    }
    const glm::dvec2 v = glm::clamp(u - 0.5, glm::dvec2(0), glm::dvec2(table.size) - 1.0);
    const glm::ivec2 low(v);
    const glm::dvec2 share = v - glm::dvec2(low);
    const auto row = [&](int y) { return glm::mix(entry({low.x, y}), entry({low.x + 1, y}), share.x); };
    return glm::mix(row(low.y), row(low.y + 1), share.y);
  }
  double opacityOf(double scalar, size_t channel = 0) {
    return lookUp(volume_.channels[channel].opacity, scalar).x;
  }

  /// Whether the sample is left out.
  bool isSkipped(const glm::dvec3& p) {
    if (volume_.mask && !(valueAt(*volume_.mask, volume_.maskLinear, p, 0) > 0)) return true;
    if (!volume_.cropping) return false;
    int box = 0, size = 1;
    for (int axis = 0; axis < 3; ++axis, size *= 3)
      for (int side = 0; side < 2; ++side) {
        const double past = p[axis] - double{volume_.cropping->planes[static_cast<size_t>(2 * axis + side)]};
        unsure_ |= std::abs(past) < 1e-6;
        box += past >= 0 ? size : 0;
      }
    return !volume_.cropping->kept[static_cast<size_t>(box)];
  }

  /// The colour of a sample that is not skipped, premultiplied.
  glm::dvec4 colorAt(const glm::dvec3& p) {
    using Use = scene::VolumeChannels;
    switch (volume_.use) {
      case Use::one: return premultiplied(litColor(scalarAt(p), p));
      case Use::independent: return mixedColor(p);
      case Use::table: return tableColor(p);
      case Use::labels: return labelColor(p);
      case Use::colorAndOpacity: {
        const double opacity = opacityOf(scalarAt(p, 1), 1);
        if (!(opacity > 0)) return glm::dvec4(0);
        const glm::dvec3 color = lookUp(volume_.channels[0].color, scalarAt(p));
        return premultiplied(lit({color, opacity}, p, 0, volume_.gradientChannel));
      }
      case Use::colors: break;
    }
    const double opacity = opacityOf(scalarAt(p, 3), 3);
    if (!(opacity > 0)) return glm::dvec4(0);
    return premultiplied(
        lit({scalarAt(p, 0), scalarAt(p, 1), scalarAt(p, 2), opacity}, p, 0, volume_.gradientChannel));
  }

  /// The colour of a scalar of channel 0, lit as at `p`.
  glm::dvec4 litColor(double scalar, const glm::dvec3& p, size_t channel = 0) {
    const double opacity = opacityOf(scalar, channel);
    return lit({lookUp(volume_.channels[channel].color, scalar), opacity}, p, channel, channel);
  }
  static glm::dvec4 premultiplied(const glm::dvec4& c) { return {glm::dvec3(c) * c.a, c.a}; }

  const scene::Volume& volume_;
  const scene::VolumeView& view_;
  glm::dvec3 towards_{0};  // from the ray's entry to the viewer
  bool unsure_ = false;

 private:
  glm::dvec4 mixedColor(const glm::dvec3& p) {
    glm::dvec4 colors[4], sum(0);
    double total = 0;
    for (size_t i = 0; i < volume_.channels.size(); ++i) {
      colors[i] = litColor(scalarAt(p, i), p, i);
      total += colors[i].a * double{volume_.channels[i].weight};
    }
    unsure_ |= std::abs(total) < 1e-6;
    if (!(total > 0)) return sum;
    for (size_t i = 0; i < volume_.channels.size(); ++i) {
      const double weight = double{volume_.channels[i].weight};
      if (weight <= 0) continue;
      const glm::dvec4& c = colors[i];
      sum += glm::dvec4(glm::dvec3(c) * c.a * weight, c.a * c.a / total);
    }
    return sum;
  }

  glm::dvec3 differencesAt(const glm::dvec3& p, size_t channel) {
    glm::dvec3 differences;
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 h(0);
      h[axis] = double{volume_.cellStep[axis]};
      differences[axis] = scalarAt(p + h, channel) - scalarAt(p - h, channel);
    }
    return differences;
  }

  /// Lit with the look of a channel by the gradient of another one.
  glm::dvec4 lit(glm::dvec4 color, const glm::dvec3& p, size_t channel, size_t of) {
    const scene::VolumeChannel& look = volume_.channels[channel];
    const glm::dvec3 spacing(volume_.cellSpacing);
    if (!look.gradientOpacity && !volume_.shading.enabled()) return glm::clamp(color, 0.0, 1.0);
    glm::dvec3 gradient = differencesAt(p, of);
    if (look.gradientOpacity) {
      const auto [strength, rounding] = strengthOf(gradient, of);
      const auto weightAt = [&](double s) {
        if (volume_.use != scene::VolumeChannels::independent)
          return lookUp(*look.gradientOpacity, std::clamp(s, 0.0, 1.0)).x;
        double all = 1;
        for (const scene::VolumeChannel& c : volume_.channels)
          all *= lookUp(*c.gradientOpacity, std::clamp(s, 0.0, 1.0)).x * double{c.weight};
        return all;
      };
      unsure_ |= std::abs(weightAt(strength + rounding) - weightAt(strength - rounding)) > 2e-5;
      color.a *= weightAt(strength);
    } else {
      gradient /= spacing;
    }
    return glm::clamp(glm::dvec4(litBy(glm::dvec3(color), look.material, p, gradient), color.a), 0.0, 1.0);
  }

  glm::dvec3 litBy(const glm::dvec3& unlit, const scene::VolumeMaterial& material, const glm::dvec3& p,
                   const glm::dvec3& gradient) {
    if (volume_.shading.isFromViewer()) return fromViewer(unlit, material, gradient);
    return volume_.shading.enabled() ? byLights(unlit, material, p, gradient) : unlit;
  }

  struct Strength {
    double value;     // of a gradient
    double rounding;  // what the rounding of scalars to floats makes of it
  };
  /// Makes a gradient of differences.
  Strength strengthOf(glm::dvec3& gradient, size_t of) const {
    const glm::vec2& ends = volume_.channels[of].range;
    const double range = double{ends.y - ends.x};
    const glm::dvec3 spacing(volume_.cellSpacing);
    const glm::dvec3 aspect = spacing * 2.0 / ((spacing.x + spacing.y + spacing.z) / 3);
    gradient *= range / aspect;
    return {glm::length(gradient) / (0.25 * (range != 0 ? range : 1)),
            4e-7 / std::min({aspect.x, aspect.y, aspect.z}) / 0.25};
  }

  glm::dvec4 labelColor(const glm::dvec3& p) {
    const scene::VolumeLabels& labels = volume_.labels;
    const double scalar = scalarAt(p);
    const glm::dvec4 plain = opacityOf(scalar) > 0 ? litColor(scalar, p) : glm::dvec4(0);
    const auto byte = static_cast<size_t>(std::lround(valueAt(*labels.voxels, false, p, 0) * 255));
    if (labels.rows[byte] == 0) return premultiplied(plain);
    glm::dvec4 label = lookUp(*volume_.table, {scalar, double{labels.rows[byte]}});
    if (label.a > 0) {
      const scene::VolumeChannel& look = volume_.channels[0];
      const glm::dvec3 gradient = differencesAt(p, 0) / glm::dvec3(volume_.cellSpacing);
      label = {litBy(glm::dvec3(label), look.material, p, gradient), label.a};
    }
    const double share = double{labels.share};
    return premultiplied((1 - share) * plain + share * label);
  }

  /// Not limited to 0 .. 1.
  glm::dvec4 tableColor(const glm::dvec3& p) {
    glm::dvec3 gradient = differencesAt(p, 0);
    const Strength strength = strengthOf(gradient, 0);
    const double scalar = scalarAt(p);
    const auto at = [&](double s) { return lookUp(*volume_.table, {scalar, std::clamp(s, 0.0, 1.0)}); };
    const glm::dvec4 color = at(strength.value);
    const glm::dvec4 change = at(strength.value + strength.rounding) - at(strength.value - strength.rounding);
    for (int c = 0; c < 4; ++c) unsure_ |= std::abs(change[c]) > 2e-5;
    if (!(color.a > 0)) return glm::dvec4(0);
    const scene::VolumeMaterial& material = volume_.channels[0].material;
    return premultiplied({litBy(glm::dvec3(color), material, p, gradient), color.a});
  }

  glm::dvec3 directionOf(const glm::dvec3& gradient) {
    const double length = glm::length(gradient);
    unsure_ |= length > 0 && length < 0.02;
    return length > 0 ? gradient / length : glm::dvec3(0);
  }

  glm::dvec3 fromViewer(const glm::dvec3& color, const scene::VolumeMaterial& material,
                        const glm::dvec3& gradient) {
    const scene::VolumeLight& light = volume_.shading.lights[0];
    const glm::dvec3 normal = directionOf(gradient);
    const bool halfway = volume_.shading.isHalfway();
    const glm::dvec3 side = halfway ? towards_ : -towards_;
    double cosine = glm::dot(normal, side);
    const glm::dvec3 reflected = 2 * cosine * normal - side;
    double highlight = halfway ? cosine : std::max(glm::dot(reflected, side), 0.0);
    if (volume_.shading.twoSided) cosine = std::abs(cosine), highlight = std::abs(highlight);
    unsure_ |= std::abs(cosine) < 1e-4 && material.shininess < 1;
    glm::dvec3 sum = glm::dvec3(material.ambient) * color;
    if (cosine > 0) sum += cosine * glm::dvec3(material.diffuse * light.diffuse) * color;
    if (cosine > 0 || halfway)
      sum += std::pow(highlight, double{material.shininess}) * glm::dvec3(material.specular * light.specular);
    return sum;
  }

  glm::dvec3 byLights(const glm::dvec3& color, const scene::VolumeMaterial& material, const glm::dvec3& p,
                      const glm::dvec3& gradient) {
    const glm::dvec3 point(glm::dmat4(volume_.shading.eyeFromTexture) * glm::dvec4(p, 1));
    const glm::dvec3 normal = directionOf(glm::dmat3(volume_.shading.eyeFromGradient) * gradient);
    glm::dvec3 ambient(0), diffuse(0), specular(0);
    for (const scene::VolumeLight& light : volume_.shading.lights) {
      ambient += glm::dvec3(light.ambient);
      glm::dvec3 along(light.direction);
      double arrives = 1;
      if (light.positional) {
        const glm::dvec3 from = point - glm::dvec3(light.position), a(light.attenuation);
        const double distance = glm::length(from);
        along = from / distance, arrives = 1 / (a.x + a.y * distance + a.z * distance * distance);
        if (light.coneAngle <= 90) {
          const double cone = glm::dot(along, glm::dvec3(light.direction));
          const double least = std::cos(glm::radians(double{light.coneAngle}));
          unsure_ |= std::abs(cone - least) < 1e-5;
          arrives *= cone >= least ? std::pow(cone, double{light.exponent}) : 0;
        }
      }
      double cosine = glm::dot(normal, along);
      if (volume_.shading.twoSided) cosine = std::abs(cosine);
      unsure_ |= std::abs(cosine) < 1e-3;
      const bool halfway = volume_.shading.isHalfway();
      const glm::dvec3 view = glm::normalize(point);
      double highlight = halfway ? glm::dot(normal, glm::normalize(along - view))
                                 : glm::dot(view, glm::normalize(2 * cosine * normal - along));
      if (volume_.shading.twoSided && (halfway || light.positional)) highlight = std::abs(highlight);
      if (cosine > 0) diffuse += arrives * cosine * glm::dvec3(light.diffuse);
      if (highlight > 0 && (cosine > 0 || halfway))
        specular += arrives * std::pow(highlight, double{material.shininess}) * glm::dvec3(light.specular);
    }
    return glm::dvec3(material.ambient) * ambient + glm::dvec3(material.diffuse) * diffuse * color +
           glm::dvec3(material.specular) * specular;
  }
};

}  // namespace gluray::test
