// Linear filters of textures, as the real OpenGL computes them: llvmpipe rounds those of eight bits to eight
// bits.
#include "tests/reference/both.h"

#include <gtest/gtest.h>

#include <vector>

namespace gluray::test {
namespace {

using scenes::Gl;

struct FilterCase {
  const char* name;
  GLint format = GL_RGBA8;
  GLenum target = GL_TEXTURE_2D;
  GLint wrap = GL_REPEAT;
  GLint smallest = GL_LINEAR, largest = GL_LINEAR;
  int width = 16, height = 16;
  float extent = 1.4f;  // of coordinates in repetitions
  int color = 0;        // tolerance; 1: filtered as floats, whose last bits round to other bytes
};
void PrintTo(const FilterCase& c, std::ostream* out) { *out << c.name; }

/// Texels that differ strongly from their neighbours.
std::vector<uint8_t> unevenTexels(int count) {
  std::vector<uint8_t> bytes;
  uint32_t state = 12345;
  for (int i = 0; i < count * 4; ++i)
    bytes.push_back(static_cast<uint8_t>((state = state * 1664525 + 1013904223) >> 24));
  return bytes;
}

void textureFor(Gl gl, const FilterCase& c) {
  constexpr int kDepth = 8;
  const std::vector<uint8_t> texels = unevenTexels(c.width * c.height * kDepth);
  if (c.target == GL_TEXTURE_1D)
    gl.TexImage1D(c.target, 0, c.format, c.width, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  else if (c.target == GL_TEXTURE_3D)
    gl.TexImage3D(c.target, 0, c.format, c.width, c.height, kDepth, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  texels.data());
  else if (c.target == GL_TEXTURE_CUBE_MAP)
    for (GLenum face = 0; face < 6; ++face)
      gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, c.format, c.width, c.height, 0, GL_RGBA,
                    GL_UNSIGNED_BYTE, texels.data() + face * 16);
  else
    gl.TexImage2D(c.target, 0, c.format, c.width, c.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  if (c.smallest != GL_LINEAR && c.smallest != GL_NEAREST) gl.GenerateMipmap(c.target);
  gl.TexParameteri(c.target, GL_TEXTURE_MIN_FILTER, c.smallest);
  gl.TexParameteri(c.target, GL_TEXTURE_MAG_FILTER, c.largest);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl.TexParameteri(c.target, axis, c.wrap);
  gl.Enable(c.target);
}

/// A tilted card.
void drawFilterCase(Gl gl, const FilterCase& c) {
  textureFor(gl, c);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  const float scale = c.target == GL_TEXTURE_RECTANGLE ? static_cast<float>(c.width) : 1;
  const bool cube = c.target == GL_TEXTURE_CUBE_MAP;
  const auto corner = [&](float x, float y) {
    const float s = c.extent * (0.5f * x + 0.4f) * scale, t = c.extent * (0.45f * y + 0.4f) * scale;
    if (cube)
      gl.TexCoord3f(x, 0.9f * y, 0.7f);
    else
      gl.TexCoord3f(s, t, 0.3f * x + 0.2f * y);
    gl.Vertex3f(0.9f * x, 0.8f * y, 0.3f * x - 0.2f * y);
  };
  gl.Begin(GL_QUADS);
  corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1);
  gl.End();
}

class TextureFilters : public testing::TestWithParam<FilterCase> {};

TEST_P(TextureFilters, RoundAsTheRealOpenGl) {
  const BothStage stage{.folder = "texture_filters",
                        .prepare =
                            [](Gl gl) {
                              gl.Enable(GL_DEPTH_TEST);
                              gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
                            },
                        .tolerance = {GetParam().color, 0.01, 1e-5f,
                                      "the last bits of coordinates decide how a few weights are rounded"}};
  const auto counts = compareBoth(stage, GetParam().name, [](Gl gl) { drawFilterCase(gl, GetParam()); });
  EXPECT_EQ(counts.drawsTraced, 1u);
}

const FilterCase kFilterCases[] = {
    {"rgba8"},
    {"rgba8_clamped", GL_RGBA8, GL_TEXTURE_2D, GL_CLAMP_TO_EDGE},
    {"rgba8_mirrored", GL_RGBA8, GL_TEXTURE_2D, GL_MIRRORED_REPEAT},
    {"rgba8_border", GL_RGBA8, GL_TEXTURE_2D, GL_CLAMP_TO_BORDER},
    {"rgba8_of_odd_sizes", GL_RGBA8, GL_TEXTURE_2D, GL_REPEAT, GL_LINEAR, GL_LINEAR, 13, 21},
    {"rgba8_of_odd_sizes_clamped", GL_RGBA8, GL_TEXTURE_2D, GL_CLAMP_TO_EDGE, GL_LINEAR, GL_LINEAR, 13, 21},
    {"rgba8_one_texel_wide", GL_RGBA8, GL_TEXTURE_2D, GL_REPEAT, GL_LINEAR, GL_LINEAR, 1, 5},
    {"rgb8", GL_RGB8},
    {"luminance8", GL_LUMINANCE8},
    {"luminance8_alpha8", GL_LUMINANCE8_ALPHA8},
    {"alpha8", GL_ALPHA8},
    {"intensity8", GL_INTENSITY8},
    {"rgb565", GL_RGB565},
    {"rgba4", GL_RGBA4},
    {"r8", GL_R8},
    {"rg8", GL_RG8},
    {"compressed", GL_COMPRESSED_RGBA_S3TC_DXT5_EXT},
    {"compressed_bptc", GL_COMPRESSED_RGBA_BPTC_UNORM},
    {"compressed_fxt1", GL_COMPRESSED_RGBA_FXT1_3DFX},
    {"srgb8", GL_SRGB8_ALPHA8, GL_TEXTURE_2D, GL_REPEAT, GL_LINEAR, GL_LINEAR, 16, 16, 1.4f, 1},
    {"rgba16", GL_RGBA16},
    {"rgb10_a2", GL_RGB10_A2},
    {"rgba16f", GL_RGBA16F},
    {"one_dimension", GL_RGBA8, GL_TEXTURE_1D},
    {"three_dimensions", GL_RGBA8, GL_TEXTURE_3D},
    {"three_dimensions_clamped", GL_RGBA8, GL_TEXTURE_3D, GL_CLAMP_TO_EDGE},
    {"cube", GL_RGBA8, GL_TEXTURE_CUBE_MAP, GL_CLAMP_TO_EDGE},
    {"cube_repeated", GL_RGBA8, GL_TEXTURE_CUBE_MAP, GL_REPEAT},
    {"rectangle", GL_RGBA8, GL_TEXTURE_RECTANGLE, GL_CLAMP_TO_EDGE},
    {"levels", GL_RGBA8, GL_TEXTURE_2D, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, 64, 64, 5},
    {"levels_nearest_level", GL_RGBA8, GL_TEXTURE_2D, GL_REPEAT, GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR, 64, 64,
     5},
    {"levels_nearest_texel", GL_RGBA8, GL_TEXTURE_2D, GL_REPEAT, GL_NEAREST_MIPMAP_LINEAR, GL_NEAREST, 64, 64,
     5},
    {"levels_magnified", GL_RGBA8, GL_TEXTURE_2D, GL_REPEAT, GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR},
    {"levels_mirrored", GL_RGBA8, GL_TEXTURE_2D, GL_MIRRORED_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, 64,
     64, 5, 1},
    {"magnified_alone", GL_RGBA8, GL_TEXTURE_2D, GL_REPEAT, GL_NEAREST, GL_LINEAR},
    {"minified_alone", GL_RGBA8, GL_TEXTURE_2D, GL_REPEAT, GL_LINEAR, GL_NEAREST, 128, 128},
};
INSTANTIATE_TEST_SUITE_P(Cases, TextureFilters, testing::ValuesIn(kFilterCases),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test
