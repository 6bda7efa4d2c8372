#include "render/lights/preetham.h"

#include "render/bsdf/local_frame.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

using bsdf::kPi;

/// Perez' formula with five coefficients, each a line in the turbidity (appendix A.2).
struct Perez {
  float a, b, c, d, e;
  float operator()(float cosTheta, float gamma) const {
    const float cosGamma = std::cos(gamma);
    return (1 + a * std::exp(b / cosTheta)) * (1 + c * std::exp(d * gamma) + e * cosGamma * cosGamma);
  }
};

/// Zenith chromaticity: powers of the sun's angle times powers of the turbidity.
float zenith(const float (&m)[3][4], float t, float angle) {
  const float powers[] = {angle * angle * angle, angle * angle, angle, 1};
  float result = 0;
  const float turbidities[] = {t * t, t, 1};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) result += turbidities[r] * m[r][c] * powers[c];
  return result;
}

constexpr float kZenithX[3][4] = {{0.00166f, -0.00375f, 0.00209f, 0},
                                  {-0.02903f, 0.06377f, -0.03202f, 0.00394f},
                                  {0.11693f, -0.21196f, 0.06052f, 0.25886f}};
constexpr float kZenithY[3][4] = {{0.00275f, -0.00610f, 0.00317f, 0},
                                  {-0.04214f, 0.08970f, -0.04153f, 0.00516f},
                                  {0.15346f, -0.26756f, 0.06670f, 0.26688f}};

/// Linear sRGB of a luminance and a chromaticity.
glm::vec3 colorOf(float luminance, float x, float y) {
  const float big = luminance / y;
  const glm::vec3 xyz(x * big, luminance, (1 - x - y) * big);
  return glm::max(glm::vec3(3.2406f * xyz.x - 1.5372f * xyz.y - 0.4986f * xyz.z,
                            -0.9689f * xyz.x + 1.8758f * xyz.y + 0.0415f * xyz.z,
                            0.0557f * xyz.x - 0.2040f * xyz.y + 1.0570f * xyz.z),
                  0.0f);
}

/// Adds the sun to the pixels near its direction, as if it were `kRadius` wide.
void addSun(SkyPixels& image, const glm::vec3& sun, const glm::vec3& irradiance) {
  constexpr float kRadius = 0.02f;  // radians; the true sun has 0.0047, less than a pixel of the image
  const float cosine = std::cos(kRadius);
  const glm::vec3 radiance = irradiance / (2 * kPi * (1 - cosine));
  for (int y = 0; y < image.height / 2; ++y)
    for (int x = 0; x < image.width; ++x) {
      // The share of the pixel that the disc covers, by 4 x 4 points.
      int covered = 0;
      for (int k = 0; k < 16; ++k) {
        const float polar = kPi * (static_cast<float>(y) + (static_cast<float>(k / 4) + 0.5f) / 4) /
                            static_cast<float>(image.height),
                    azimuth = 2 * kPi * (static_cast<float>(x) + (static_cast<float>(k % 4) + 0.5f) / 4) /
                              static_cast<float>(image.width);
        const glm::vec3 d(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                          std::sin(polar) * std::sin(azimuth));
        covered += glm::dot(d, sun) > cosine;
      }
      image.pixels[static_cast<size_t>(y) * static_cast<size_t>(image.width) + static_cast<size_t>(x)] +=
          radiance * (static_cast<float>(covered) / 16);
    }
}

}  // namespace

SkyPixels preethamSky(const glm::vec3& towardsSun, float t, const glm::vec3& ground) {
  constexpr int kWidth = 512, kHeight = 256;
  const float length = glm::length(towardsSun);
  glm::vec3 sun = length > 0 ? towardsSun / length : glm::vec3(0, 1, 0);
  sun = glm::normalize(glm::vec3(sun.x, std::max(sun.y, 0.02f), sun.z));
  const float angle = std::acos(std::min(sun.y, 1.0f));
  const Perez luminance{0.1787f * t - 1.4630f, -0.3554f * t + 0.4275f, -0.0227f * t + 5.3251f,
                        0.1206f * t - 2.5771f, -0.0670f * t + 0.3703f};
  const Perez x{-0.0193f * t - 0.2592f, -0.0665f * t + 0.0008f, -0.0004f * t + 0.2125f,
                -0.0641f * t - 0.8989f, -0.0033f * t + 0.0452f};
  const Perez y{-0.0167f * t - 0.2608f, -0.0950f * t + 0.0092f, -0.0079f * t + 0.2102f,
                -0.0441f * t - 1.6537f, -0.0109f * t + 0.0529f};
  const float zenithX = zenith(kZenithX, t, angle), zenithY = zenith(kZenithY, t, angle);
  // The zenith's luminance is the unit.
  const float atZenith[] = {luminance(1, angle), x(1, angle), y(1, angle)};
  SkyPixels image{kWidth, kHeight, std::vector<glm::vec3>(size_t{kWidth} * kHeight, ground)};
  double light = 0;  // irradiance of a level surface
  for (int row = 0; row < kHeight / 2; ++row)
    for (int column = 0; column < kWidth; ++column) {
      const float polar = kPi * (static_cast<float>(row) + 0.5f) / kHeight,
                  azimuth = 2 * kPi * (static_cast<float>(column) + 0.5f) / kWidth;
      const glm::vec3 d(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                        std::sin(polar) * std::sin(azimuth));
      const float cosTheta = std::max(d.y, 0.01f),
                  gamma = std::acos(std::clamp(glm::dot(d, sun), -1.0f, 1.0f));
      const float bright = luminance(cosTheta, gamma) / atZenith[0];
      image.pixels[static_cast<size_t>(row) * kWidth + static_cast<size_t>(column)] = colorOf(
          bright, zenithX * x(cosTheta, gamma) / atZenith[1], zenithY * y(cosTheta, gamma) / atZenith[2]);
      light +=
          double{bright} * double{d.y} * std::sin(double{polar}) * (M_PI / kHeight) * (2 * M_PI / kWidth);
    }
  // A level white surface under the sky alone shows 1.
  const auto scale = static_cast<float>(M_PI / light);
  for (int i = 0; i < kWidth * kHeight / 2; ++i) image.pixels[static_cast<size_t>(i)] *= scale;
  // The sun gives what it faces 1.5 times that; lower, it is redder.
  const float low = 1 - sun.y;
  addSun(image, sun, 1.5f * kPi * glm::vec3(1, 0.95f - 0.35f * low * low, 0.88f - 0.7f * low * low));
  return image;
}

}  // namespace gluray::render
