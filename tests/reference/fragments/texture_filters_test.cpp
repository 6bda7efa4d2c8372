// Linear filters of textures, as the real OpenGL computes them: llvmpipe rounds those of eight bits to eight
// bits.
#include "tests/reference/both.h"

#include <gtest/gtest.h>

#include <string>
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
  gl.Enable(c.target);
}

constexpr GLenum kWraps[] = {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R};

/// Filters and wrap modes of the texture.
void filterByTexture(Gl gl, const FilterCase& c) {
  gl.TexParameteri(c.target, GL_TEXTURE_MIN_FILTER, c.smallest);
  gl.TexParameteri(c.target, GL_TEXTURE_MAG_FILTER, c.largest);
  for (const GLenum axis : kWraps) gl.TexParameteri(c.target, axis, c.wrap);
}

/// The same of a sampler object, with others of the texture.
void filterBySampler(Gl gl, const FilterCase& c) {
  filterByTexture(
      gl, {.target = c.target, .wrap = GL_CLAMP_TO_EDGE, .smallest = GL_NEAREST, .largest = GL_NEAREST});
  GLuint sampler = 0;
  gl.GenSamplers(1, &sampler), gl.BindSampler(0, sampler);
  gl.SamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, c.smallest);
  gl.SamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, c.largest);
  for (const GLenum axis : kWraps) gl.SamplerParameteri(sampler, axis, c.wrap);
}

/// A tilted card.
void drawFilterCase(Gl gl, const FilterCase& c, void (*filter)(Gl gl, const FilterCase& c)) {
  textureFor(gl, c);
  filter(gl, c);
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

BothStage stageOf(const FilterCase& c) {
  return {.folder = "texture_filters",
          .prepare =
              [](Gl gl) {
                gl.Enable(GL_DEPTH_TEST);
                gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
              },
          .tolerance = {c.color, 0.01, 1e-5f,
                        "the last bits of coordinates decide how a few weights are rounded"}};
}

TEST_P(TextureFilters, RoundAsTheRealOpenGl) {
  const FilterCase& c = GetParam();
  const auto counts = compareBoth(stageOf(c), c.name, [&](Gl gl) { drawFilterCase(gl, c, filterByTexture); });
  EXPECT_EQ(counts.drawsTraced, 1u);
}

TEST_P(TextureFilters, AreTheSameBySamplerObjects) {
  const FilterCase& c = GetParam();
  const auto counts = compareBoth(stageOf(c), std::string("sampler_") + c.name,
                                  [&](Gl gl) { drawFilterCase(gl, c, filterBySampler); });
  const bool refused = c.target == GL_TEXTURE_CUBE_MAP || c.target == GL_TEXTURE_RECTANGLE;
  EXPECT_EQ(counts.drawsTraced, refused ? 0u : 1u);
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

/// The sampler object of each card is another one, or has changed.
void drawChangingSamplers(Gl gl) {
  const FilterCase usual{"usual"};
  textureFor(gl, usual), filterByTexture(gl, usual);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  GLuint samplers[2] = {};
  gl.GenSamplers(2, samplers);
  for (const GLuint sampler : samplers) gl.SamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  float x = -0.9f;
  const auto card = [&] {
    gl.Begin(GL_QUADS);
    gl.TexCoord2f(-0.5f, 0), gl.Vertex3f(x, -0.5f, 0), gl.TexCoord2f(1.5f, 0),
        gl.Vertex3f(x + 0.3f, -0.5f, 0);
    gl.TexCoord2f(1.5f, 2), gl.Vertex3f(x + 0.3f, 0.5f, 0.2f), gl.TexCoord2f(-0.5f, 2),
        gl.Vertex3f(x, 0.5f, 0.2f);
    gl.End();
    x += 0.36f;
  };
  card();
  gl.BindSampler(0, samplers[0]), card();
  gl.SamplerParameteri(samplers[0], GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE), card();
  gl.SamplerParameteri(samplers[1], GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.BindSamplers(0, 1, &samplers[1]), card();
  gl.DeleteSamplers(1, &samplers[1]), card();  // unbinds it
}

TEST(SamplerObjects, AreThoseOfEachDraw) {
  const auto counts = compareBoth(stageOf({"changing"}), "sampler_changing", drawChangingSamplers);
  EXPECT_EQ(counts.drawsTraced, 5u);
}

}  // namespace
}  // namespace gluray::test
