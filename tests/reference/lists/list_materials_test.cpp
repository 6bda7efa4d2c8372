// Materials in display lists while they follow the colour (GL_COLOR_MATERIAL): their values afterwards, and
// the image of the next draws, must be the same as without GLuRay.
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <vector>

namespace gluray::test {
namespace {

using Gl = const gl::RealGl&;

constexpr int kMaterialsSize = 32;
// Exactly representable in 255 steps.
constexpr GLfloat kOrange[4] = {0.8f, 0.4f, 0.2f, 1}, kBlue[4] = {0.2f, 0.4f, 0.8f, 1},
                  kWhite[4] = {1, 1, 1, 1};

void material(Gl gl, GLenum name, const GLfloat* value) { gl.Materialfv(GL_FRONT_AND_BACK, name, value); }

/// Triangles that lie one before the other; `between` is called before the last vertex.
struct Triangles {
  Gl gl;
  float depth = 0.8f;
  template <class Between>
  void draw(Between&& between) {
    gl.Begin(GL_TRIANGLES);
    gl.Vertex3f(-1, -1, depth), gl.Vertex3f(1, -1, depth + 0.1f);
    between();
    gl.Vertex3f(0, 1, depth);
    gl.End();
    depth -= 0.2f;
  }
  void draw() {
    draw([] {});
  }
};

struct MaterialCase {
  const char* name;
  void (*calls)(Gl gl, Triangles& triangles);
};
void PrintTo(const MaterialCase& c, std::ostream* out) { *out << c.name; }

const MaterialCase kMaterialCases[] = {
    {"before the primitive", [](Gl gl, Triangles& t) { material(gl, GL_AMBIENT, kOrange), t.draw(); }},
    {"between primitives",
     [](Gl gl, Triangles& t) { t.draw(), material(gl, GL_AMBIENT, kOrange), t.draw(); }},
    {"one that follows the colour and one that does not",
     [](Gl gl, Triangles& t) {
       t.draw(), material(gl, GL_AMBIENT, kOrange), material(gl, GL_EMISSION, kBlue), t.draw();
     }},
    {"outside, then another inside",
     [](Gl gl, Triangles& t) {
       material(gl, GL_AMBIENT, kOrange);
       t.draw([&] { material(gl, GL_EMISSION, kBlue); });
     }},
    {"behind the primitive, before the next",
     [](Gl gl, Triangles& t) {
       t.draw([&] { material(gl, GL_EMISSION, kBlue); });
       material(gl, GL_AMBIENT, kOrange), material(gl, GL_EMISSION, kOrange), t.draw();
     }},
    {"with a colour",
     [](Gl gl, Triangles& t) { gl.Color4fv(kBlue), material(gl, GL_AMBIENT, kOrange), t.draw(); }},
};

struct SeenMaterials {
  std::vector<GLfloat> materials;
  std::vector<uint32_t> middles;
  bool operator==(const SeenMaterials&) const = default;
};

/// The list is drawn with a stencil test, which is left to the real OpenGL, or traced.
SeenMaterials seen(Gl gl, const MaterialCase& c, GLenum mode, bool stencil) {
  SeenMaterials seen;
  Triangles triangles{gl};
  const auto look = [&] {
    seen.middles.push_back(0);
    gl.ReadPixels(kMaterialsSize / 2, kMaterialsSize / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                  &seen.middles.back());
  };
  gl.Enable(GL_LIGHTING), gl.Enable(GL_DEPTH_TEST), gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, kWhite);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.ColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT), gl.Enable(GL_COLOR_MATERIAL);
  if (stencil) gl.Enable(GL_STENCIL_TEST), gl.StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  gl.NewList(1, mode), c.calls(gl, triangles), gl.EndList();
  if (mode == GL_COMPILE) gl.CallList(1);
  gl.Disable(GL_STENCIL_TEST);
  look();
  for (const GLenum name : {GL_AMBIENT, GL_EMISSION}) {
    GLfloat values[4];
    gl.GetMaterialfv(GL_FRONT, name, values);
    seen.materials.insert(seen.materials.end(), values, values + 4);
  }
  triangles.draw(), look();
  return seen;
}

class ColorMaterialInLists : public testing::TestWithParam<MaterialCase> {};

TEST_P(ColorMaterialInLists, IsTheRealOne) {
  for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE})
    for (const bool stencil : {true, false}) {
      const auto real = OsmesaContext::create({kMaterialsSize, kMaterialsSize});
      const SeenMaterials expected = seen(real->real(), GetParam(), mode, stencil);
      const TracedContext ours({kMaterialsSize, kMaterialsSize});
      const SeenMaterials got = seen(ours.gl(), GetParam(), mode, stencil);
      EXPECT_EQ(got.materials, expected.materials) << mode << " " << stencil;
      EXPECT_EQ(got.middles, expected.middles) << mode << " " << stencil;
      EXPECT_EQ(
          ours.context().counts.statistics.rasterisedBecause[static_cast<size_t>(gl::Reason::stencil)] > 0,
          stencil);
    }
}

INSTANTIATE_TEST_SUITE_P(Cases, ColorMaterialInLists, testing::ValuesIn(kMaterialCases));

}  // namespace
}  // namespace gluray::test
