// GL_COMBINE, row by row of GL 2.1, tables 3.24 to 3.26.
#include "render/local/combine.h"

#include <gtest/gtest.h>

namespace gluray {
namespace {

using scene::Combine;

const glm::vec4 kTexel(0.2f, 0.4f, 0.8f, 0.25f), kPrevious(0.5f, 0.25f, 0.75f, 0.5f),
    kPrimary(0.9f, 0.8f, 0.7f, 0.6f), kConstant(0.1f, 0.3f, 0.5f, 0.7f), kOther(0.6f, 0.1f, 0.3f, 0.9f);

glm::vec4 combined(const Combine& combine) {
  scene::Texture t;
  t.image = std::make_shared<scene::TextureImage>();
  t.unit = 1;
  t.env = scene::TexEnv::combine;
  t.combine = combine;
  t.envColor = kConstant;
  render::CombineInputs in;
  in.texels[1] = kTexel, in.texels[3] = kOther;
  in.primary = kPrimary;
  return render::applyEnvironment(t, in, kPrevious);
}

void expectNear(const glm::vec4& got, const glm::vec4& expected, const char* what) {
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(got[i], expected[i], 1e-6f) << what << ' ' << i;
}

Combine::Part part(Combine::Function function) {
  Combine::Part p;
  p.function = function;
  p.arguments = {{{Combine::texture, Combine::color},
                  {Combine::previous, Combine::color},
                  {Combine::constant, Combine::color}}};
  return p;
}

TEST(Combine, Functions) {
  const glm::vec4 a = kTexel, b = kPrevious, c = kConstant;
  const auto both = [](Combine::Function f) {
    Combine result;
    result.rgb = result.alphaPart = part(f);
    return combined(result);
  };
  expectNear(both(Combine::replace), a, "replace");
  expectNear(both(Combine::modulate), a * b, "modulate");
  expectNear(both(Combine::add), a + b, "add");
  expectNear(both(Combine::addSigned), a + b - 0.5f, "add signed");
  expectNear(both(Combine::interpolate), a * c + b * (1.0f - c), "interpolate");
  expectNear(both(Combine::subtract), a - b, "subtract");
}

TEST(Combine, ScalarProducts) {
  // 4 * ((0.2-0.5)*(0.5-0.5) + (0.4-0.5)*(0.25-0.5) + (0.8-0.5)*(0.75-0.5)) = 4 * (0 + 0.025 + 0.075)
  Combine c;
  c.rgb = part(Combine::dot3Rgb);
  c.alphaPart = part(Combine::replace);
  expectNear(combined(c), {0.4f, 0.4f, 0.4f, kTexel.a}, "rgb");
  c.rgb.function = Combine::dot3Rgba;
  expectNear(combined(c), glm::vec4(0.4f), "rgba");
  c.alphaPart.scale = 2;
  expectNear(combined(c), {0.4f, 0.4f, 0.4f, 0.8f}, "rgba, alpha scaled");
}

TEST(Combine, SourcesAndOperands) {
  const auto replaced = [](uint8_t source, Combine::Operand operand) {
    Combine c;
    c.rgb = c.alphaPart = part(Combine::replace);
    c.rgb.arguments[0] = c.alphaPart.arguments[0] = {source, operand};
    return combined(c);
  };
  expectNear(replaced(Combine::constant, Combine::color), kConstant, "constant");
  expectNear(replaced(Combine::primary, Combine::color), kPrimary, "primary");
  expectNear(replaced(Combine::previous, Combine::oneMinusColor), 1.0f - kPrevious, "one minus");
  expectNear(replaced(Combine::texture, Combine::alpha), glm::vec4(kTexel.a), "alpha");
  expectNear(replaced(Combine::texture, Combine::oneMinusAlpha), glm::vec4(1 - kTexel.a), "one minus alpha");
  expectNear(replaced(Combine::textureUnit + 3, Combine::color), kOther, "crossbar");
}

TEST(Combine, Scales) {
  Combine c;
  c.rgb = part(Combine::replace), c.rgb.scale = 2;
  c.alphaPart = part(Combine::replace), c.alphaPart.scale = 4;
  expectNear(combined(c), {glm::vec3(kTexel) * 2.0f, kTexel.a * 4}, "scales");
}

}  // namespace
}  // namespace gluray
