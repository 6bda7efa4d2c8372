// Which billboards are complete, and which meshes are built from them.
#include "gl/impostors/sent_billboards.h"

#include "gl/testing/test_match.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace gluray::gl {
namespace {

using Corners = std::vector<uint8_t>;

const Corners kSquare = {0, 1, 3, 0, 3, 2};

Corners box() {
  Corners all;
  const auto side = [&](int zero, int a, int b) {
    for (const int k : {0, a, a | b, 0, a | b, b}) all.push_back(static_cast<uint8_t>(zero | k));
  };
  for (int d = 0; d < 3; ++d) {
    const int a = 1 << (d + 1) % 3, b = 1 << (d + 2) % 3;
    side(1 << d, a, b), side(0, b, a);
  }
  return all;
}

TEST(SentBillboards, SquaresAreTwoTrianglesOrAQuad) {
  EXPECT_TRUE(coversBillboard(kSquare, GL_TRIANGLES, 2));
  EXPECT_TRUE(coversBillboard(Corners{0, 3, 1, 0, 2, 3}, GL_TRIANGLES, 2));
  EXPECT_TRUE(coversBillboard(Corners{0, 1, 3, 2}, GL_QUADS, 2));
  EXPECT_TRUE(coversBillboard(Corners{3, 1, 0, 2}, GL_QUADS, 2));
  EXPECT_FALSE(coversBillboard(Corners{0, 3, 1, 2}, GL_QUADS, 2)) << "crosses itself";
  EXPECT_FALSE(coversBillboard(Corners{0, 1, 3, 0, 2, 3}, GL_TRIANGLES, 2)) << "halves turned differently";
  EXPECT_FALSE(coversBillboard(Corners{0, 1, 3, 0, 1, 2}, GL_TRIANGLES, 2)) << "halves overlap";
  EXPECT_FALSE(coversBillboard(Corners{0, 1, 3, 0, 1, 3}, GL_TRIANGLES, 2)) << "one half twice";
  EXPECT_FALSE(coversBillboard(Corners{0, 1, 3}, GL_TRIANGLES, 2));
  EXPECT_FALSE(coversBillboard(Corners{0, 1, 1, 0, 3, 2}, GL_TRIANGLES, 2));
  EXPECT_FALSE(coversBillboard(Corners{0, 1, 7, 0, 7, 2}, GL_TRIANGLES, 2));
  EXPECT_FALSE(coversBillboard({}, GL_TRIANGLES, 2));
}

TEST(SentBillboards, BoxesHaveSixSides) {
  EXPECT_TRUE(coversBillboard(box(), GL_TRIANGLES, 3));
  Corners inwards = box();
  std::reverse(inwards.begin(), inwards.end());
  EXPECT_TRUE(coversBillboard(inwards, GL_TRIANGLES, 3));
  for (size_t i = 0; i < 36; i += 3) {
    Corners turned = box();
    std::swap(turned[i], turned[i + 1]);
    EXPECT_FALSE(coversBillboard(turned, GL_TRIANGLES, 3)) << "triangle " << i / 3 << " the other way round";
    Corners lacking = box();
    lacking.erase(lacking.begin() + static_cast<ptrdiff_t>(i),
                  lacking.begin() + static_cast<ptrdiff_t>(i) + 3);
    EXPECT_FALSE(coversBillboard(lacking, GL_TRIANGLES, 3));
  }
  for (size_t i = 0; i < 36; ++i) {
    Corners moved = box();
    moved[i] ^= 7;
    EXPECT_FALSE(coversBillboard(moved, GL_TRIANGLES, 3)) << "corner " << i;
  }
  EXPECT_FALSE(coversBillboard(kSquare, GL_TRIANGLES, 3));
}

/// A draw of two impostors, whose arrays are in the program's memory.
struct SentDraw {
  bool sticks;
  std::vector<std::array<float, 4>> places;
  std::vector<std::array<float, 3>> tips;
  std::vector<std::array<float, 4>> colors, tipColors;
  std::vector<float> caps, corners;
  std::vector<uint32_t> numbers;
  const std::vector<std::array<float, 2>>* inCorners = nullptr;  // corners that have the radius
  ArrayState arrays;

  explicit SentDraw(bool ofSticks) : sticks(ofSticks) {
    const uint32_t each = sticks ? 8 : 4;
    for (uint32_t i = 0; i < 2 * each; ++i) {
      const auto n = static_cast<float>(i / each);
      places.push_back({n, 2, 3, 0.5f + n}), tips.push_back({n, 2, 4});
      colors.push_back({1, n, 0, 1}), tipColors.push_back({0, n, 1, 1});
      caps.push_back(n == 0 ? 15.0f : 1.0f + 8 + 16), corners.push_back(static_cast<float>(i % each));
    }
    for (uint32_t n = 0; n < 2; ++n)
      for (const uint8_t corner : sticks ? box() : kSquare) numbers.push_back(n * each + corner);
  }
  KnownMesh build(GLenum mode = GL_TRIANGLES) {
    arrays.sentBillboards = true;
    arrays.radiusInPosition = !inCorners, arrays.radiusInCorners = inCorners;
    arrays.shape = sticks ? scene::Shape::sticks : scene::Shape::spheres;
    const auto set = [](ArraySource& to, const auto& from) {
      to.enabled = true, to.size = static_cast<GLint>(sizeof(from[0]) / 4);
      to.stride = static_cast<GLsizei>(sizeof(from[0]));
      to.pointer = reinterpret_cast<const std::byte*>(from.data());
    };
    set(arrays.vertex, places), set(arrays.color, colors), set(arrays.corners, corners);
    if (inCorners) set(arrays.corners, *inCorners);
    if (sticks) set(arrays.end, tips), set(arrays.endColor, tipColors), set(arrays.caps, caps);
    Elements e;
    e.count = static_cast<GLsizei>(numbers.size()), e.type = GL_UNSIGNED_INT, e.indices = numbers.data();
    return buildSentImpostors(fakeGl(), arrays, mode, e);
  }
};

TEST(SentBillboards, BecomeSpheres) {
  SentDraw draw(false);
  const KnownMesh known = draw.build();
  ASSERT_TRUE(known.mesh);
  EXPECT_EQ(known.mesh->shape, scene::Shape::spheres);
  EXPECT_EQ(known.mesh->triangleCount, 2u);
  EXPECT_EQ(known.mesh->position(1), glm::vec3(1, 2, 3));
  EXPECT_EQ(scene::fetch(known.mesh->radii, 1).x, 1.5f);
  EXPECT_EQ(scene::fetch(known.mesh->colors, 1), glm::vec4(1, 1, 0, 1));
  EXPECT_TRUE(known.mesh->opaqueColors);
  for (auto& color : draw.colors) color[3] = 0.5f;
  EXPECT_FALSE(draw.build().mesh->opaqueColors);
}

TEST(SentBillboards, HaveRadiiInTheirCorners) {
  SentDraw draw(false);
  std::vector<std::array<float, 2>> corners;
  for (size_t i = 0; i < draw.corners.size(); ++i) {
    const auto corner = static_cast<int>(draw.corners[i]);
    const float radius = i < 4 ? 0.25f : 0.75f;
    corners.push_back({corner & 1 ? radius : -radius, corner & 2 ? radius : -radius});
  }
  for (auto& place : draw.places) place[3] = 1;
  draw.inCorners = &corners;
  const KnownMesh known = draw.build();
  ASSERT_TRUE(known.mesh);
  EXPECT_EQ(scene::fetch(known.mesh->radii, 0).x, 0.25f);
  EXPECT_EQ(scene::fetch(known.mesh->radii, 1).x, 0.75f);
  EXPECT_EQ(known.mesh->position(1), glm::vec3(1, 2, 3));
  const auto damaged = [&](size_t vertex, float x, float y) {
    auto other = corners;
    other[vertex] = {x, y};
    draw.inCorners = &other;
    return !draw.build().mesh;
  };
  EXPECT_FALSE(damaged(1, 0.25f, -0.25f));
  EXPECT_TRUE(damaged(1, 0.25f, -0.3f)) << "not a square";
  EXPECT_TRUE(damaged(1, 0.3f, -0.3f)) << "another radius";
  EXPECT_TRUE(damaged(1, -0.25f, -0.25f)) << "the same corner twice";
  EXPECT_TRUE(damaged(1, 0, 0)) << "no radius";
  EXPECT_TRUE(damaged(1, std::nanf(""), -0.25f));
}

TEST(SentBillboards, BecomeSticks) {
  SentDraw draw(true);
  const KnownMesh known = draw.build();
  ASSERT_TRUE(known.mesh);
  EXPECT_EQ(known.mesh->triangleCount, 2u);
  EXPECT_EQ(known.mesh->position(2), glm::vec3(1, 2, 3));
  EXPECT_EQ(known.mesh->position(3), glm::vec3(1, 2, 4));
  EXPECT_EQ(scene::fetch(known.mesh->colors, 3), glm::vec4(0, 1, 1, 1));
  using namespace scene;
  EXPECT_EQ(known.mesh->endAt(0), kClosedEnd | kRoundEnd | kTwoHalves);
  EXPECT_EQ(known.mesh->endAt(1), kClosedEnd | kRoundEnd);
  EXPECT_EQ(known.mesh->endAt(2), static_cast<uint32_t>(kClosedEnd));
  EXPECT_EQ(known.mesh->endAt(3), static_cast<uint32_t>(kRoundEnd));
  draw.caps.assign(draw.caps.size(), 0);
  EXPECT_NE(draw.build().mesh->geometryId, known.mesh->geometryId);
}

TEST(SentBillboards, ThatAreNotWholeBecomeNothing) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const std::pair<const char*, std::function<void(SentDraw&)>> damages[] = {
      {"another place", [](SentDraw& d) { d.places[2][1] += 1; }},
      {"another radius", [](SentDraw& d) { d.places[5][3] += 1; }},
      {"another colour", [](SentDraw& d) { d.colors[3][2] = 0.5f; }},
      {"no such corner", [](SentDraw& d) { d.corners[1] = 9; }},
      {"half a corner", [](SentDraw& d) { d.corners[1] = 0.5f; }},
      {"the same corner twice", [](SentDraw& d) { d.corners[1] = 0; }},
      {"a part", [](SentDraw& d) { d.numbers.resize(d.numbers.size() - 3); }},
      {"no vertices", [](SentDraw& d) { d.numbers.clear(); }},
      {"corners of two", [](SentDraw& d) { d.numbers[0] = d.sticks ? 8 : 4; }},
      {"not a number",
       [](SentDraw& d) {
         for (auto& p : d.places) p[0] = std::nanf("");
       }},
      {"far away",
       [=](SentDraw& d) {
         for (auto& p : d.places) p[2] = kInfinity;
       }},
      {"negative radii", [](SentDraw& d) {
         for (auto& p : d.places) p[3] = -1;
       }}};
  for (const bool sticks : {false, true})
    for (const auto& [name, damage] : damages) {
      SentDraw draw(sticks);
      damage(draw);
      EXPECT_FALSE(draw.build().mesh) << name;
    }
  EXPECT_FALSE(SentDraw(true).build(GL_QUADS).mesh);
  EXPECT_FALSE(SentDraw(false).build(GL_TRIANGLE_STRIP).mesh);
  const std::pair<const char*, std::function<void(SentDraw&)>> ofSticks[] = {
      {"another end", [](SentDraw& d) { d.tips[2][1] += 1; }},
      {"another colour of the end", [](SentDraw& d) { d.tipColors[9][0] = 0.5f; }},
      {"other caps", [](SentDraw& d) { d.caps[4] = 0; }},
      {"unknown caps", [](SentDraw& d) { d.caps.assign(16, 32); }},
      {"half a cap", [](SentDraw& d) { d.caps.assign(16, 1.5f); }},
      {"no length",
       [](SentDraw& d) {
         for (auto& t : d.tips) t = {0, 2, 3};
       }},
  };
  for (const auto& [name, damage] : ofSticks) {
    SentDraw draw(true);
    damage(draw);
    EXPECT_FALSE(draw.build().mesh) << name;
  }
}

}  // namespace
}  // namespace gluray::gl
