// Fixed-function surfaces that are blended in the order of drawing, with and without depth writes.
#include "tests/reference/layers/drawn_layers_stage.h"

#include <algorithm>
#include <numeric>

namespace gluray::test::drawn_layers {
namespace {

TEST(DrawnLayers, AreBlendedInEveryOrder) {
  std::array<size_t, 3> order{};
  std::iota(order.begin(), order.end(), size_t{0});
  do {
    for (const bool writes : {true, false}) {
      const auto draw = [&](Gl gl) {
        blendOver(gl);
        gl.DepthMask(writes);
        for (const size_t i : order) ball(gl, kBalls[i]);
      };
      const std::string name = "order " + std::to_string(order[0]) + std::to_string(order[1]) +
                               std::to_string(order[2]) + (writes ? " writing" : "");
      expectTraced(name, draw, 3);
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(DrawnLayers, AreHiddenByOpaqueSurfaces) {
  for (const GLenum function : {GL_LESS, GL_LEQUAL}) {
    const auto draw = [&](Gl gl) {
      gl.DepthFunc(function);
      ball(gl, {0, 0, {0.7f, 0.7f, 0.2f, 1}});
      blendOver(gl);
      gl.DepthMask(GL_FALSE);
      for (const Ball& b : kBalls) ball(gl, {b.x, b.z * 1.5f, {b.color[0], b.color[1], b.color[2], 0.4f}});
    };
    expectTraced(function == GL_LESS ? "less" : "lequal", draw, 4);
  }
}

TEST(DrawnLayers, AndOpaqueOnesTakeTurns) {
  const auto draw = [](Gl gl) {
    blendOver(gl);
    for (int i = 0; i < 4; ++i) {
      const auto at = static_cast<float>(i);
      gl.DepthMask(i % 2 == 0);
      ball(gl, {-0.6f + 0.4f * at, 0.3f * at, {0.9f, 0.2f * at, 0.1f, i % 2 ? 0.5f : 1.0f}, 0.5f});
    }
  };
  expectTraced("turns", draw, 4);
}

TEST(DrawnLayers, AreBlendedByEveryFunction) {
  for (const Function& f : kFunctions) {
    const auto draw = [&](Gl gl) {
      blendBy(gl, f);
      for (const Ball& b : kBalls) ball(gl, {b.x, b.z, {b.color[0], b.color[1], b.color[2], 0.7f}});
    };
    expectTraced(f.name, draw, 3);
  }
}

TEST(DrawnLayers, OfUnlitColorsAndFlatOnes) {
  for (const GLenum model : {GL_SMOOTH, GL_FLAT}) {
    const auto draw = [&](Gl gl) {
      blendOver(gl);
      gl.Disable(GL_LIGHTING);
      gl.ShadeModel(model);
      for (const float z : {-0.4f, 0.4f, 0.0f}) {
        gl.Begin(GL_TRIANGLES);
        gl.Color4f(1, 0, 0, 0.2f), gl.Vertex3f(-1, -1, z - 0.3f);
        gl.Color4f(0, 1, 0, 0.9f), gl.Vertex3f(1, -1, z);
        gl.Color4f(0, 0, 1, 0.5f), gl.Vertex3f(0.3f, 1, z + 0.3f);
        gl.End();
        gl.Rotatef(40, 0, 0, 1);
      }
    };
    expectTraced(model == GL_FLAT ? "flat" : "smooth", draw, 3);
  }
}

TEST(DrawnLayers, OfFacesFarAndNear) {
  const auto draw = [](Gl gl) {
    blendOver(gl);
    gl.DepthMask(GL_FALSE);
    gl.Enable(GL_CULL_FACE);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    for (const GLenum culled : {GL_FRONT, GL_BACK}) {
      gl.CullFace(culled);
      ball(gl, {0, 0, {0.9f, 0.4f, 0.2f, 0.5f}});
    }
  };
  expectTraced("faces", draw, 2);
}

/// A surface whose triangles overlap themselves, unsorted: which ones hide others depends on their order.
TEST(DrawnLayers, OfOneDrawKeepTheOrderOfTheirTriangles) {
  for (const bool writes : {true, false}) {
    for (const bool backwards : {true, false}) {
      const auto draw = [&](Gl gl) {
        blendOver(gl);
        gl.DepthMask(writes);
        gl.Rotatef(35, 1, 0, 0);
        paint(gl, 0.8f, 0.5f, 0.2f);
        material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, {0.8f, 0.5f, 0.2f, 0.45f});
        Model model = torus(0.9f, 0.35f, 30, 16);
        if (backwards) std::reverse(model.indices.begin(), model.indices.end());
        send(gl, model);
      };
      expectTraced(std::string("triangles") + (writes ? " writing" : "") + (backwards ? " backwards" : ""),
                   draw, 1);
    }
  }
}

/// The order of triangles is kept whatever the acceleration structure.
TEST(DrawnLayers, AreTheSameInEveryStructure) {
  for (const BvhQuality bvh :
       {BvhQuality::automatic, BvhQuality::fast, BvhQuality::full, BvhQuality::compact, BvhQuality::least}) {
    for (const bool writes : {true, false}) {
      BothStage stage = theStage();
      stage.settings.bvh = bvh;
      const auto draw = [&](Gl gl) {
        blendOver(gl);
        gl.DepthMask(writes);
        gl.Rotatef(35, 1, 0, 0);
        paint(gl, 0.8f, 0.5f, 0.2f);
        material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, {0.8f, 0.5f, 0.2f, 0.45f});
        send(gl, torus(0.9f, 0.35f, 60, 32));
        gl.Rotatef(50, 0, 1, 0);
        send(gl, torus(0.9f, 0.35f, 60, 32));
      };
      const std::string name =
          "structure " + std::to_string(static_cast<int>(bvh)) + (writes ? " writing" : "");
      EXPECT_EQ(compareBoth(stage, name, draw).drawsTraced, 2u) << name;
    }
  }
}

/// More layers than rays gather in one step, at almost equal depths.
TEST(DrawnLayers, OfManyAreAllBlended) {
  for (const bool writes : {true, false}) {
    const auto draw = [&](Gl gl) {
      blendOver(gl);
      gl.DepthMask(writes);
      for (int i = 0; i < 40; ++i) {
        const auto at = static_cast<float>(i * 7 % 40);
        ball(gl, {0, 0, {at / 40, 0.5f, 1 - at / 40, 0.08f}, 0.5f + 0.01f * at});
      }
    };
    expectTraced(writes ? "many writing" : "many", draw, 40);
  }
}

TEST(DrawnLayers, OfListsAndArrays) {
  const Model model = torus(0.9f, 0.35f, 30, 16);
  for (const bool list : {true, false}) {
    const auto draw = [&](Gl gl) {
      blendOver(gl);
      material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, {0.8f, 0.5f, 0.2f, 0.45f});
      gl.EnableClientState(GL_VERTEX_ARRAY), gl.EnableClientState(GL_NORMAL_ARRAY);
      gl.VertexPointer(3, GL_FLOAT, 0, model.positions.data());
      gl.NormalPointer(GL_FLOAT, 0, model.normals.data());
      if (list) gl.NewList(1, GL_COMPILE);
      gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(model.indices.size()), GL_UNSIGNED_INT,
                      model.indices.data());
      if (list) gl.EndList(), gl.CallList(1);
    };
    expectTraced(list ? "list" : "array", draw, 1);
  }
}

TEST(DrawnLayers, OverTheSameSurface) {
  for (const GLenum function : {GL_LESS, GL_LEQUAL}) {
    for (const bool first : {true, false}) {
      const auto draw = [&](Gl gl) {
        gl.DepthFunc(function);
        if (first) blendOver(gl);
        ball(gl, {0, 0, {0.2f, 0.6f, 0.9f, 0.6f}});
        blendOver(gl);
        ball(gl, {0, 0, {0.9f, 0.2f, 0.1f, 0.5f}});
        gl.BlendFunc(GL_ONE, GL_ONE), gl.DepthMask(GL_FALSE);
        ball(gl, {0, 0, {0.1f, 0.2f, 0.1f, 1}});
      };
      compareBoth(theStage(), std::string("same") + (first ? " blended" : "") + std::to_string(function),
                  draw);
    }
  }
}

TEST(DrawnLayers, FadeIntoFogAndFailAlphaTests) {
  const auto draw = [](Gl gl) {
    blendOver(gl);
    gl.Enable(GL_FOG);
    gl.Fogi(GL_FOG_MODE, GL_LINEAR), gl.Fogf(GL_FOG_START, 3), gl.Fogf(GL_FOG_END, 5);
    ball(gl, kBalls[0]);
    gl.Enable(GL_ALPHA_TEST), gl.AlphaFunc(GL_GREATER, 0.5f);
    gl.Disable(GL_LIGHTING);
    gl.Begin(GL_QUADS);
    gl.Color4f(1, 1, 0, 0), gl.Vertex3f(-1, -0.3f, 0.3f), gl.Vertex3f(1, -0.3f, 0.4f);
    gl.Color4f(1, 0, 0, 1), gl.Vertex3f(1, 0.6f, 0.4f), gl.Vertex3f(-1, 0.6f, 0.3f);
    gl.End();
  };
  expectTraced("fog", draw, 2);
}

TEST(DrawnLayers, OfFewTrianglesAreLeftToTheRealOne) {
  BothStage stage = theStage();
  stage.settings.engine = Engine::automatic;
  const auto draw = [](Gl gl) {
    blendOver(gl);
    gl.DepthMask(GL_FALSE);
    ball(gl, kBalls[0]);
    material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, kBalls[1].color);
    send(gl, sphere(340, 340));  // 230,000 triangles
  };
  const gl::Statistics counted = compareBoth(stage, "few", draw);
  EXPECT_EQ(counted.drawsTraced, 1u);
  EXPECT_EQ(counted.rasterisedBecause[static_cast<size_t>(gl::Reason::smallScene)], 1u);
}

/// Many small draws that are pending together count as a large scene, after one such frame.
TEST(DrawnLayers, OfManyDrawsAreTracedTogether) {
  BothStage stage = theStage();
  stage.settings.engine = Engine::automatic;
  const auto draw = [&](Gl gl) {
    gl.NewList(1, GL_COMPILE), send(gl, sphere(160, 160)), gl.EndList();  // 50,000 triangles
    for (int frame = 0; frame < 2; ++frame) {
      stage.prepare(gl);
      blendOver(gl);
      gl.DepthMask(GL_FALSE);
      for (int i = 0; i < 5; ++i) {
        const auto at = 0.2f * static_cast<float>(i);
        gl.PushMatrix();
        gl.Translatef(at - 0.4f, 0, 0.4f - at);
        material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, {at, 0.7f, 0.3f, 0.4f});
        gl.CallList(1);
        gl.PopMatrix();
      }
      gl.DepthMask(GL_TRUE);
      gl.DepthMask(GL_TRUE);
      gl.Finish();  // ends the frame
    }
  };
  EXPECT_EQ(compareBoth(stage, "many", draw).drawsTraced, 5u);
}

}  // namespace
}  // namespace gluray::test::drawn_layers
