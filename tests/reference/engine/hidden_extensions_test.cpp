// The quirk hide-persistent-mapping: which extensions programs see, and how a program that picks the best way
// to write its vertices is then drawn.
#include "settings/quirks.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace gluray::test {
namespace {

using Gl = const gl::RealGl&;
constexpr int kHiddenExtensionsSize = 64;
using Names = std::vector<std::string>;

Settings settings(bool hide) {
  Settings s = TracedContext::vertexShading();
  EXPECT_TRUE(s.quirks.set("hide-persistent-mapping", hide));
  return s;
}

Names listed(Gl gl) {
  GLint count = 0;
  gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
  Names names;
  for (GLint i = 0; i < count; ++i)
    names.emplace_back(reinterpret_cast<const char*>(gl.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i))));
  return names;
}
Names inOneString(Gl gl) {
  std::istringstream text(reinterpret_cast<const char*>(gl.GetString(GL_EXTENSIONS)));
  Names names;
  for (std::string name; text >> name;) names.push_back(name);
  return names;
}
Names without(Names names) {
  std::erase(names, "GL_ARB_buffer_storage"), std::erase(names, "GL_EXT_buffer_storage");
  return names;
}

TEST(HiddenExtensions, AreOffUnlessSwitchedOn) {
  EXPECT_FALSE(Settings{}.quirks.has(Quirk::hidePersistentMapping));
  Names all, oneString;
  {
    const auto real = OsmesaContext::create({kHiddenExtensionsSize, kHiddenExtensionsSize});
    all = listed(real->real()), oneString = inOneString(real->real());
  }
  ASSERT_NE(without(all), all) << "the real OpenGL has what is to be hidden";
  TracedContext ours({kHiddenExtensionsSize, kHiddenExtensionsSize});
  EXPECT_EQ(listed(ours.gl()), all);
  EXPECT_EQ(inOneString(ours.gl()), oneString);
}

TEST(HiddenExtensions, AreMissingFromEveryList) {
  Names all, oneString;
  std::string version;
  {
    const auto real = OsmesaContext::create({kHiddenExtensionsSize, kHiddenExtensionsSize});
    all = listed(real->real()), oneString = inOneString(real->real());
    version = reinterpret_cast<const char*>(real->real().GetString(GL_VERSION));
  }
  const uint64_t before = useCount(Quirk::hidePersistentMapping);
  TracedContext ours({kHiddenExtensionsSize, kHiddenExtensionsSize}, settings(true));
  Gl gl = ours.gl();
  EXPECT_EQ(listed(gl), without(all));
  EXPECT_EQ(inOneString(gl), without(oneString));
  EXPECT_GT(useCount(Quirk::hidePersistentMapping), before);
  EXPECT_EQ(gl.GetString(GL_EXTENSIONS), gl.GetString(GL_EXTENSIONS)) << "programs keep the pointer";
  EXPECT_EQ(version, reinterpret_cast<const char*>(gl.GetString(GL_VERSION)))
      << "what a version promises is there";
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  const auto count = static_cast<GLuint>(without(all).size());
  EXPECT_EQ(gl.GetStringi(GL_EXTENSIONS, count), nullptr);
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_VALUE});
  GLfloat asFloat = 0;
  gl.GetFloatv(GL_NUM_EXTENSIONS, &asFloat);
  EXPECT_EQ(asFloat, static_cast<GLfloat>(count));
}

/// Draws two frames from a buffer that it writes through a persistent mapping, if it finds that, or else by
/// glBufferSubData.
DrawnImage drawAsFound(Gl gl) {
  constexpr GLbitfield kBits = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  using Vertices = std::array<GLfloat, 9>;
  const Names names = listed(gl);
  const bool persistent = std::find(names.begin(), names.end(), "GL_ARB_buffer_storage") != names.end();
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  void* memory = nullptr;
  if (persistent) {
    gl.BufferStorage(GL_ARRAY_BUFFER, sizeof(Vertices), nullptr, kBits);
    memory = gl.MapBufferRange(GL_ARRAY_BUFFER, 0, sizeof(Vertices), kBits);
  } else {
    gl.BufferData(GL_ARRAY_BUFFER, sizeof(Vertices), nullptr, GL_STREAM_DRAW);
  }
  gl.Enable(GL_DEPTH_TEST);
  gl.VertexPointer(3, GL_FLOAT, 0, nullptr), gl.EnableClientState(GL_VERTEX_ARRAY);
  for (const float x : {-0.9f, -0.3f}) {
    const Vertices vertices = {x, -0.8f, 0, x + 1, -0.8f, 0.2f, x + 0.5f, 0.7f, 0};
    if (memory)
      std::memcpy(memory, vertices.data(), sizeof vertices);
    else
      gl.BufferSubData(GL_ARRAY_BUFFER, 0, sizeof vertices, vertices.data());
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Color3f(0.3f, 0.9f, 0.5f);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.Finish();
  }
  return readImage(gl, kHiddenExtensionsSize, kHiddenExtensionsSize);
}

/// Colours of which no component differs by more than one, by rounding.
bool isClose(uint32_t a, uint32_t b) {
  for (int shift = 0; shift < 32; shift += 8)
    if (std::abs(static_cast<int>(a >> shift & 255) - static_cast<int>(b >> shift & 255)) > 1) return false;
  return true;
}

TEST(HiddenExtensions, TheProgramThatDoesNotFindThemIsTraced) {
  DrawnImage expected;
  {
    const auto real = OsmesaContext::create({kHiddenExtensionsSize, kHiddenExtensionsSize});
    expected = drawAsFound(real->real());
  }
  for (const bool hide : {false, true}) {
    TracedContext ours({kHiddenExtensionsSize, kHiddenExtensionsSize}, settings(hide));
    const DrawnImage got = drawAsFound(ours.gl());
    size_t differing = 0;
    for (size_t i = 0; i < got.colors.size(); ++i) differing += !isClose(got.colors[i], expected.colors[i]);
    EXPECT_LE(differing, hide ? 8u : 0u) << "pixels on the edges, where it is traced";
    const gl::Statistics& s = ours.context().counts.statistics;
    EXPECT_EQ(s.drawsTraced, hide ? 2u : 0u);
    EXPECT_EQ(s.rasterisedBecause[static_cast<size_t>(gl::Reason::persistentMapping)], hide ? 0u : 2u);
  }
}

}  // namespace
}  // namespace gluray::test
