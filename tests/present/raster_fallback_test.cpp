// A snapshot drawn by fixed function equals a program's own drawing, and changes no OpenGL state.
#include "intercept/present/raster/raster_fallback.h"

#include "intercept/present/tracing_presenter.h"
#include "tests/support/gl_state.h"
#include "tests/support/osmesa_context.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace gluray::present {
namespace {

constexpr int kFallbackSize = 64;

/// Two triangles with all attributes, and their owner.
struct Patch {
  std::array<float, 12> positions{-1, -1, 0, 1, -1, 0, 1, 1, 0.5f, -1, 1, 0.5f};
  std::array<float, 12> normals{0, 0, 1, 0.5f, 0, 1, 0, 0.5f, 1, -0.5f, 0, 1};
  std::array<float, 12> colors{1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0};
  std::array<float, 8> texcoords{0, 0, 2, 0, 2, 2, 0, 2};
  std::array<uint32_t, 6> indices{0, 1, 2, 0, 2, 3};
};

template <class Array>
scene::Attribute attribute(const Array& values, uint32_t components, scene::Format format) {
  return {nullptr, reinterpret_cast<const std::byte*>(values.data()), components * 4, format};
}

scene::MeshPtr meshOf(const Patch& patch) {
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->triangleCount = 2, mesh->vertexCount = 4;
  mesh->positions = attribute(patch.positions, 3, scene::Format::float3);
  mesh->normals = attribute(patch.normals, 3, scene::Format::float3);
  mesh->colors = attribute(patch.colors, 3, scene::Format::float3);
  mesh->texcoords = attribute(patch.texcoords, 2, scene::Format::float2);
  mesh->indices = attribute(patch.indices, 1, scene::Format::uint32);
  return mesh;
}

std::shared_ptr<scene::TextureImage> checkers() {
  auto image = std::make_shared<scene::TextureImage>();
  image->width = image->height = 2;
  image->baseFormat = scene::BaseFormat::luminance;
  image->texels = {0xffffffff, 0xff808080, 0xff808080, 0xffffffff};
  return image;
}

/// A lit, textured, clipped patch, seen in perspective through half of the window.
std::shared_ptr<scene::Snapshot> snapshotOf(const Patch& patch) {
  auto s = std::make_shared<scene::Snapshot>();
  s->camera.clipFromEye = glm::frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 10.0);
  s->camera.viewport = {4, 2, 48, 56};
  s->camera.depthNear = 0.25f, s->camera.depthFar = 0.75f;
  s->region = {6, 6, 40, 50};
  scene::Shading shading;
  shading.lighting = shading.normalize = shading.twoSided = true;
  shading.colorMaterial.front = shading.colorMaterial.back = scene::ColorMaterial::ambientAndDiffuse;
  scene::Light light;
  light.diffuse = {0.9f, 0.8f, 0.7f, 1}, light.position = {0.5f, 1, 2, 1}, light.attenuation = {1, 0.1f, 0};
  shading.lights = {light};
  scene::Texture texture;
  texture.image = checkers();
  texture.magFilter = texture.minFilter = scene::Filter::nearest;
  shading.textures = {texture};
  s->shadings = {shading, scene::Shading{}};
  scene::Instance lit;
  lit.mesh = meshOf(patch);
  lit.eyeFromObject = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -2));
  lit.materials = {scene::MaterialPair{}};
  lit.clipPlanes = {glm::dvec4(-1, 0, 0, 0.7)};
  scene::Instance plain = lit;
  plain.shading = 1;
  plain.clipPlanes.clear();
  plain.eyeFromObject =
      glm::rotate(glm::translate(glm::dmat4(1), glm::dvec3(0.5, 0, -2)), 0.6, glm::dvec3(0, 1, 0));
  plain.cull = scene::CullFace::back;
  s->instances = {lit, plain};
  return s;
}

/// The same image by direct OpenGL calls.
void drawByHand(const gl::RealGl& g, const Patch& patch) {
  const auto drawPatch = [&](bool textured) {
    g.Begin(GL_TRIANGLES);
    for (uint32_t i : patch.indices) {
      g.Normal3fv(&patch.normals[i * 3]);
      g.Color3fv(&patch.colors[i * 3]);
      if (textured) g.TexCoord2fv(&patch.texcoords[i * 2]);
      g.Vertex3fv(&patch.positions[i * 3]);
    }
    g.End();
  };
  g.Viewport(4, 2, 48, 56), g.DepthRange(0.25, 0.75);
  g.Enable(GL_SCISSOR_TEST), g.Scissor(6, 6, 40, 50);
  g.Enable(GL_DEPTH_TEST), g.DepthFunc(GL_LEQUAL);
  g.MatrixMode(GL_PROJECTION), g.LoadIdentity(), g.Frustum(-1, 1, -1, 1, 1, 10);
  g.MatrixMode(GL_MODELVIEW), g.LoadIdentity();
  const GLfloat diffuse[] = {0.9f, 0.8f, 0.7f, 1}, specular[] = {0, 0, 0, 1}, position[] = {0.5f, 1, 2, 1};
  g.Lightfv(GL_LIGHT0, GL_DIFFUSE, diffuse), g.Lightfv(GL_LIGHT0, GL_SPECULAR, specular);
  g.Lightfv(GL_LIGHT0, GL_POSITION, position), g.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.1f);
  g.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  for (GLenum cap : {GL_LIGHTING, GL_LIGHT0, GL_NORMALIZE, GL_TEXTURE_2D, GL_CLIP_PLANE0, GL_COLOR_MATERIAL})
    g.Enable(cap);
  const GLdouble plane[] = {-1, 0, 0, 0.7};
  g.ClipPlane(GL_CLIP_PLANE0, plane);
  const GLubyte texels[] = {255, 128, 0, 0, 128, 255, 0, 0};
  g.TexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE8, 2, 2, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels);
  g.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  g.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  g.Translatef(0, 0, -2);
  drawPatch(true);
  for (GLenum cap : {GL_LIGHTING, GL_TEXTURE_2D, GL_CLIP_PLANE0}) g.Disable(cap);
  g.Enable(GL_CULL_FACE);
  g.LoadIdentity(), g.Translatef(0.5f, 0, -2), g.Rotated(glm::degrees(0.6), 0, 1, 0);
  drawPatch(false);
}

TEST(RasterFallback, DrawsWhatTheProgramWouldHaveDrawn) {
  const Patch patch;
  const auto byHand = gluray::test::OsmesaContext::create({kFallbackSize, kFallbackSize});
  byHand->real().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  drawByHand(byHand->real(), patch);
  const auto colors = byHand->colors();
  const auto depths = byHand->depths();
  ASSERT_GT(std::count_if(depths.begin(), depths.end(), [](float d) { return d < 1; }),
            kFallbackSize * kFallbackSize / 5);

  const auto context = gluray::test::OsmesaContext::create({kFallbackSize, kFallbackSize});
  const auto& g = context->real();
  g.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  g.Enable(GL_FOG), g.Enable(GL_LIGHT3), g.Enable(GL_CLIP_PLANE1), g.Enable(GL_TEXTURE_GEN_S),
      g.ShadeModel(GL_FLAT);
  ASSERT_TRUE(drawByRealGl(g, readFeatures(g), *snapshotOf(patch), {GL_LEQUAL}));
  EXPECT_EQ(context->colors(), colors);
  EXPECT_EQ(context->depths(), depths);
}

TEST(RasterFallback, ChangesNoQueryableState) {
  const auto context = gluray::test::OsmesaContext::create({kFallbackSize, kFallbackSize});
  const auto& g = context->real();
  for (GLenum cap :
       {GL_FOG, GL_LIGHT3, GL_CLIP_PLANE1, GL_TEXTURE_GEN_S, GL_BLEND, GL_STENCIL_TEST, GL_SAMPLE_MASK})
    g.Enable(cap);
  g.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
  g.ActiveTexture(GL_TEXTURE2), g.Enable(GL_TEXTURE_1D);
  g.MatrixMode(GL_TEXTURE), g.Translatef(1, 2, 3), g.MatrixMode(GL_PROJECTION), g.Ortho(-2, 2, -2, 2, -2, 2);
  g.Color4f(0.1f, 0.2f, 0.3f, 0.4f), g.Normal3f(1, 2, 3), g.TexCoord2f(5, 6);
  g.ViewportIndexedf(3, 1, 2, 3, 4);
  const auto before = gluray::test::queryState(g);
  const Patch patch;
  ASSERT_TRUE(drawByRealGl(g, readFeatures(g), *snapshotOf(patch), {GL_LESS}));
  EXPECT_EQ(gluray::test::differences(before, gluray::test::queryState(g)), std::vector<std::string>{});
}

TEST(RasterFallback, StandsInWhenTracingFails) {
  const Patch patch;
  const auto context = gluray::test::OsmesaContext::create({kFallbackSize, kFallbackSize});
  const auto& g = context->real();
  g.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  TracingPresenter presenter({[](const scene::Snapshot&, Image&, scene::TraceCost&, std::string& error) {
    return error = "out of memory", false;
  }});
  g.Enable(0xdead);
  const auto result = presenter.present(g, snapshotOf(patch), {GL_LEQUAL, false});
  EXPECT_EQ(result.outcome, gl::PresentResult::rasterised);
  EXPECT_EQ(result.pendingError, static_cast<GLenum>(GL_INVALID_ENUM));
  const auto depths = context->depths();
  EXPECT_GT(std::count_if(depths.begin(), depths.end(), [](float d) { return d < 1; }),
            kFallbackSize * kFallbackSize / 5);
}

TEST(RasterFallback, TracedImagesAreWrittenBack) {
  const Patch patch;
  const auto context = gluray::test::OsmesaContext::create({kFallbackSize, kFallbackSize});
  const auto& g = context->real();
  g.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  TracingPresenter presenter(
      {[](const scene::Snapshot& s, Image& image, scene::TraceCost& cost, std::string&) {
        image.x = s.region.x, image.y = s.region.y;
        image.resize(s.region.width, s.region.height, 1);
        image.color.assign(image.color.size(), 0xff00ff00u);
        image.depth.assign(image.depth.size(), 0.5f);
        cost.blasBuilds = 3;
        return true;
      }});
  const auto result = presenter.present(g, snapshotOf(patch), {GL_LESS, false});
  EXPECT_EQ(result.outcome, gl::PresentResult::traced);
  EXPECT_EQ(result.cost.blasBuilds, 3u);
  const auto colors = context->colors();
  EXPECT_EQ(std::count(colors.begin(), colors.end(), 0xff00ff00u), 40 * 50);
}

TEST(TracingPresenter, UnchangedFramesAreTracedOnceMoreForABetterStructure) {
  const Patch patch;
  const auto context = gluray::test::OsmesaContext::create({kFallbackSize, kFallbackSize});
  int traced = 0;
  bool better = false;
  TracingPresenter presenter(
      {.trace =
           [&](const scene::Snapshot& s, Image& image, scene::TraceCost&, std::string&) {
             image.resize(s.region.width, s.region.height, 1);
             ++traced;
             better = false;  // it is in use now
             return true;
           },
       .improves = [&] { return better; }});
  const auto snapshot = snapshotOf(patch);
  const auto frame = [&] { return presenter.present(context->real(), snapshot, {GL_LESS, false}).repeated; };
  EXPECT_FALSE(frame());
  EXPECT_TRUE(frame());
  better = true;
  EXPECT_FALSE(frame());
  EXPECT_TRUE(frame());
  EXPECT_EQ(traced, 2);
}

}  // namespace
}  // namespace gluray::present
