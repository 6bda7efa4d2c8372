#include "render/lights/studio.h"

#include "render/bsdf/local_frame.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gluray::render {
namespace {

using bsdf::kPi;

/// A rectangle of azimuths and elevations that shines. Angles in degrees.
struct SoftBox {
  float azimuth;    // of its middle, to the right of the viewer
  float elevation;  // of its middle
  float halfWidth, halfHeight;
  float radiance;
};

constexpr float kFade = 6;  // degrees over which the edges of boxes fade
constexpr std::array kBoxes = {
    SoftBox{-20, 62, 55, 18, 2.1f},   // above, towards the viewer
    SoftBox{-68, 12, 20, 34, 2.0f},   // left
    SoftBox{62, 8, 13, 38, 1.5f},     // right
    SoftBox{-142, 15, 12, 40, 1.2f},  // behind, left
    SoftBox{138, 15, 12, 40, 1.2f},   // behind, right
};

/// 1 within `half` of the middle, 0 beyond it, with a smooth edge.
float inside(float distance, float half) {
  const float t = std::clamp((half - std::abs(distance)) / kFade + 0.5f, 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

float wall(float elevation) {
  const float up = std::clamp((elevation + 60) / 120, 0.0f, 1.0f);
  return 0.25f + 0.45f * up;
}

/// `azimuth`: -180 .. 180.
float radianceOf(float azimuth, float elevation) {
  float light = wall(elevation);
  for (const SoftBox& box : kBoxes) {
    const float share = inside(std::remainder(azimuth - box.azimuth, 360.0f), box.halfWidth) *
                        inside(elevation - box.elevation, box.halfHeight);
    light += share * (box.radiance - light);
  }
  return light;
}

}  // namespace

SkyPixels studio() {
  constexpr int kWidth = 512, kHeight = 256;
  SkyPixels image{kWidth, kHeight, std::vector<glm::vec3>(size_t{kWidth} * kHeight)};
  double sum = 0, area = 0;
  for (int row = 0; row < kHeight; ++row) {
    const float polar = kPi * (static_cast<float>(row) + 0.5f) / kHeight;
    for (int column = 0; column < kWidth; ++column) {
      // Columns begin at +x and turn towards +z, where azimuth 0 is.
      const float azimuth = 90 - 360 * (static_cast<float>(column) + 0.5f) / kWidth;
      const float light = radianceOf(azimuth, 90 - polar * 180 / kPi);
      image.pixels[static_cast<size_t>(row) * kWidth + static_cast<size_t>(column)] = glm::vec3(light);
      sum += double{light} * std::sin(double{polar});
      area += std::sin(double{polar});
    }
  }
  const auto scale = static_cast<float>(area / sum);
  for (glm::vec3& pixel : image.pixels) pixel *= scale;
  return image;
}

}  // namespace gluray::render
