#include "gl/program_state/pulled_vertices.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

namespace gluray::gl {
namespace {

template <class T>
scene::Attribute attributeOf(const std::vector<T>& values, scene::Format format) {
  return {nullptr, reinterpret_cast<const std::byte*>(values.data()), sizeof(T), format};
}

TEST(PulledVertices, AreIndicesIntoTheBufferOfPoints) {
  PulledVertices pulled;
  pulled.idsOffset = 64, pulled.firstVertex = 6;
  const auto elements = elementsOf(pulled, {6, 300, 0, nullptr, 0, 1});
  ASSERT_TRUE(elements);
  EXPECT_EQ(elements->type, static_cast<GLenum>(GL_UNSIGNED_INT));
  EXPECT_EQ(reinterpret_cast<uintptr_t>(elements->indices), 64u + 24u);
  EXPECT_EQ(elements->count, 300);
  EXPECT_EQ(elements->first, 0);
  EXPECT_EQ(elements->instances, 1);
  EXPECT_FALSE(elementsOf(pulled, {3, 300, 0, nullptr, 0, 1}));                // begins elsewhere
  EXPECT_FALSE(elementsOf(pulled, {0, 300, GL_UNSIGNED_INT, nullptr, 0, 1}));  // indices of vertices
}

TEST(PulledVertices, AreThoseOfTheDrawIfItIsIndexed) {
  PulledVertices pulled;
  pulled.indexed = true;
  const auto elements =
      elementsOf(pulled, {0, 30, GL_UNSIGNED_SHORT, reinterpret_cast<const void*>(8), 5, -1});
  ASSERT_TRUE(elements);
  EXPECT_EQ(elements->type, static_cast<GLenum>(GL_UNSIGNED_SHORT));
  EXPECT_EQ(elements->base, 5);
}

TEST(PulledVertices, OfLinesAreTwoForSix) {
  PulledVertices pulled;
  pulled.idsOffset = 64, pulled.firstVertex = 6, pulled.lines = true;
  const auto elements = elementsOf(pulled, {6, 300, 0, nullptr, 0, 1});
  ASSERT_TRUE(elements);
  EXPECT_EQ(elements->count, 100);
  EXPECT_EQ(reinterpret_cast<uintptr_t>(elements->indices), 64u + 24u);
  EXPECT_FALSE(elementsOf(pulled, {6, 303, 0, nullptr, 0, 1}));  // half a line
  pulled.indexed = true;
  EXPECT_FALSE(elementsOf(pulled, {0, 300, GL_UNSIGNED_INT, nullptr, 0, 1}));
  EXPECT_EQ(modeOf(pulled, GL_TRIANGLES), std::optional<GLenum>(GL_LINES));
  EXPECT_FALSE(modeOf(pulled, GL_LINES));
  EXPECT_EQ(modeOf(PulledVertices{}, GL_POINTS), std::optional<GLenum>(GL_POINTS));
}

TEST(ValuesOfCells, MayBeOfSeveralPrimitives) {
  const std::vector<int32_t> cells{2, 0};
  const std::vector<uint32_t> colors{10, 11, 12};
  const scene::Attribute all = attributeOf(colors, scene::Format::unorm8x4);
  PulledVertices pulled;
  pulled.primitivesPerCell = 2;
  const auto valuesOf = [&](uint32_t primitives) {
    const auto taken = ValuesOfCells().take(pulled, all, 3, primitives);
    std::vector<uint32_t> got(taken ? primitives : 0);
    if (taken) std::memcpy(got.data(), taken->data, got.size() * sizeof(uint32_t));
    return got;
  };
  EXPECT_EQ(valuesOf(5), (std::vector<uint32_t>{10, 10, 11, 11, 12}));
  EXPECT_TRUE(valuesOf(7).empty());  // no fourth cell
  pulled.cells = attributeOf(cells, scene::Format::uint32), pulled.cellCount = 2;
  EXPECT_EQ(valuesOf(4), (std::vector<uint32_t>{12, 12, 10, 10}));
  EXPECT_TRUE(valuesOf(5).empty());
}

TEST(ValuesOfCells, AreInTheOrderOfTriangles) {
  const std::vector<int32_t> cells{2, 0, 0, 1, 2};
  const std::vector<uint32_t> colors{10, 11, 12};
  PulledVertices pulled;
  pulled.cells = attributeOf(cells, scene::Format::uint32), pulled.cellCount = 5;
  const scene::Attribute all = attributeOf(colors, scene::Format::unorm8x4);
  ValuesOfCells values;
  const auto taken = values.take(pulled, all, 3, 4);
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->format, scene::Format::unorm8x4);
  uint32_t got[4];
  std::memcpy(got, taken->data, sizeof got);
  EXPECT_EQ(std::vector<uint32_t>(got, got + 4), (std::vector<uint32_t>{12, 10, 10, 11}));
  EXPECT_EQ(values.take(pulled, all, 3, 4), taken);  // the same memory
  EXPECT_NE(values.take(pulled, all, 3, 3)->data, taken->data);
}

TEST(ValuesOfCells, MustExist) {
  const std::vector<int32_t> cells{0, 3, -1};
  const std::vector<glm::vec3> normals(4, glm::vec3(0, 0, 1));
  PulledVertices pulled;
  pulled.cells = attributeOf(cells, scene::Format::uint32), pulled.cellCount = 3;
  ValuesOfCells values;
  const scene::Attribute all = attributeOf(normals, scene::Format::float3);
  EXPECT_TRUE(values.take(pulled, all, 4, 2));
  EXPECT_FALSE(values.take(pulled, all, 3, 2));  // cell 3
  EXPECT_FALSE(values.take(pulled, all, 4, 3));  // cell -1
  EXPECT_FALSE(values.take(pulled, all, 4, 4));  // no fourth triangle
}

}  // namespace
}  // namespace gluray::gl
