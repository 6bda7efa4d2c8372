// Geometry in glTF files: what is read again equals the snapshot's arrays.
#include "saved/testing/test_export.h"

#include <glm/gtc/matrix_transform.hpp>

namespace gluray::saved {
namespace {

using test::exported;
using test::GlbFile;

/// Triangles with colours, normals and indices.
test::MeshData colouredFan() {
  test::MeshData data;
  data.positions = {{0.1f, 0.2f, 0.3f}, {1, 0, -0.7f}, {0, 1, 0.5f}, {-1, 0.3f, 1e-3f}};
  data.indices = {0, 1, 2, 0, 2, 3};
  data.normals = {{0, 0, 2}, {1, 1, 1}, {0, 0, 1}, {0, 3, 4}};
  data.colors = {{1, 0, 0, 1}, {0.2f, 0.4f, 0.6f, 1}, {0, 0, 0, 1}, {1, 1, 1, 0.5f}};
  return data;
}

TEST(GlbGeometry, EqualsTheSnapshots) {
  const test::MeshData data = colouredFan();
  const GlbFile file = exported(test::makeSnapshot({test::makeMesh(data)}));
  const auto positions = file.attribute(0, "POSITION");
  ASSERT_EQ(positions.size(), data.positions.size());
  for (size_t i = 0; i < positions.size(); ++i) EXPECT_EQ(glm::vec3(positions[i]), data.positions[i]);
  EXPECT_EQ(file.indices(file.primitive(0).at("indices")), data.indices);
  EXPECT_EQ(glm::vec3(file.attribute(0, "NORMAL")[3]), glm::vec3(0, 0.6f, 0.8f)) << "of unit length";
  const auto colors = file.attribute(0, "COLOR_0");
  for (size_t i = 0; i < colors.size(); ++i) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(scene::encodedSrgb(colors[i][c]), data.colors[i][c], 1e-6f);
    EXPECT_EQ(colors[i].a, data.colors[i].a);
  }
  EXPECT_EQ(file.meshNodes().size(), 1u);
  EXPECT_FALSE(file.gltf["nodes"][0].contains("matrix")) << "the world is the first instance's space";
}

TEST(GlbGeometry, OfManyTrianglesAndStridesIsEqual) {
  // More than a piece, interleaved with a stride of 24 bytes; colours are bytes.
  constexpr uint32_t kCount = 300'000;
  struct Vertex {
    float x, y, z;
    uint8_t color[4];
    float s, t;
  };
  auto vertices = std::make_shared<std::vector<Vertex>>(kCount + 1);
  for (uint32_t i = 0; i < kCount; ++i) {
    const auto v = static_cast<float>(i);
    (*vertices)[i] = {v, std::sin(v), -v, {uint8_t(i), uint8_t(i >> 8), 7, uint8_t(255 - i % 2)}, v / 7, 1};
  }
  scene::Mesh mesh;
  mesh.triangleCount = kCount / 3, mesh.vertexCount = kCount;
  const auto at = [&](size_t offset, scene::Format format) {
    const auto* data = reinterpret_cast<const std::byte*>(vertices->data()) + offset;
    return scene::Attribute{vertices, data, sizeof(Vertex), format};
  };
  mesh.positions = at(0, scene::Format::float3), mesh.colors = at(12, scene::Format::unorm8x4);
  mesh.texcoords = at(16, scene::Format::float2);
  const GlbFile file = exported(test::makeSnapshot({std::make_shared<scene::Mesh>(mesh)}));
  const auto positions = file.attribute(0, "POSITION"), colors = file.attribute(0, "COLOR_0");
  ASSERT_EQ(positions.size(), size_t{kCount});
  size_t wrong = 0;
  for (uint32_t i = 0; i < kCount; ++i) {
    const Vertex& v = (*vertices)[i];
    wrong += glm::vec3(positions[i]) != glm::vec3(v.x, v.y, v.z);
    wrong += test::displayed(colors[i]) != glm::ivec3(v.color[0], v.color[1], v.color[2]);
    wrong += std::lround(255 * colors[i].a) != v.color[3];
  }
  EXPECT_EQ(wrong, 0u);
  EXPECT_FALSE(file.primitive(0).contains("indices"));
}

TEST(GlbGeometry, InstancesShareAMesh) {
  test::MeshData data = test::squareData();
  data.normals.assign(4, {0, 0, 1}), data.colors.assign(4, {0.5f, 1, 0, 1}),
      data.texcoords.assign(4, {0, 0, 0, 1});
  scene::Snapshot s = test::makeSnapshot({test::makeMesh(data)});
  auto image = std::make_shared<scene::TextureImage>();
  image->width = image->height = 1, image->texels = {~0u};
  s.shadings[0].textures.resize(1);
  s.shadings[0].textures[0].image = image;
  s.eyeFromWorld = glm::translate(glm::dmat4(1), {1, 2, -5});
  s.instances.push_back(s.instances[0]);
  s.instances[0].eyeFromObject = s.eyeFromWorld;
  s.instances[1].eyeFromObject = glm::translate(s.eyeFromWorld, {3, 0, 0});
  const GlbFile file = exported(s);
  EXPECT_EQ(file.gltf["meshes"].size(), 1u);
  EXPECT_EQ(file.gltf["accessors"].size(), 5u) << "positions, indices, normals, colours, texture coordinates";
  const auto nodes = file.meshNodes();
  ASSERT_EQ(nodes.size(), 2u);
  EXPECT_EQ(file.matrixOf(nodes[0]), glm::dmat4(1));
  EXPECT_EQ(file.matrixOf(nodes[1]), glm::translate(glm::dmat4(1), {3, 0, 0}));
  s.shadings.push_back(s.shadings[0]);
  s.shadings[1].lighting = true;
  s.shadings[1].colorMaterial.front = scene::ColorMaterial::diffuse;
  s.instances[1].shading = 1;
  const GlbFile two = exported(s);
  EXPECT_EQ(two.gltf["meshes"].size(), 2u) << "of two materials";
  EXPECT_EQ(two.gltf["accessors"].size(), 5u) << "but one geometry";
  // Colours that are computed are shared by equal draws.
  s.shadings[0].textures[0].env = s.shadings[1].textures[0].env = scene::TexEnv::blend;
  s.instances[1].shading = 0;
  EXPECT_EQ(exported(s).gltf["meshes"].size(), 1u);
}

TEST(GlbGeometry, IsWrittenOnceWhereItIsDrawnAgain) {
  scene::Snapshot s = test::makeSnapshot({test::makeMesh(test::squareData())});
  EXPECT_EQ(exported({s, s}).meshNodes().size(), 1u);
  scene::Snapshot depths = s;
  depths.instances[0].mesh = test::makeMesh(test::squareData(0.5f));
  EXPECT_EQ(exported({depths, s}).meshNodes().size(), 2u);
  depths.colorWrites = {false, false, false, false};
  EXPECT_EQ(exported({depths, s}).meshNodes().size(), 1u) << "depths alone show nothing";
}

TEST(GlbGeometry, OfLaterBatchesIsInTheWorldOfTheFirst) {
  scene::Snapshot first = test::makeSnapshot({test::makeMesh(test::squareData())});
  first.eyeFromWorld = glm::rotate(glm::dmat4(1), 0.3, {1, 2, 3});
  first.instances[0].eyeFromObject = first.eyeFromWorld;
  scene::Snapshot second = first;
  second.eyeFromWorld = glm::translate(first.eyeFromWorld, {0, 0, 4});
  second.instances[0].eyeFromObject = second.eyeFromWorld;
  const GlbFile file = exported({first, second});
  const glm::dmat4 m = file.matrixOf(file.meshNodes()[1]),
                   expected = glm::translate(glm::dmat4(1), {0, 0, 4});
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) EXPECT_NEAR(m[c][r], expected[c][r], 1e-12);
  second.view = 9;
  second.camera.viewport = {0, 0, 999, 999};
  std::vector<std::string> notes;
  const GlbFile views = exported({first, second}, &notes);
  EXPECT_EQ(views.gltf["scenes"].size(), 2u) << "another view is another scene";
  EXPECT_EQ(views.gltf["scene"], 0);
  EXPECT_EQ(notes.size(), 1u);
}

TEST(GlbGeometry, TheWorldKeepsAnglesAndStaysPut) {
  scene::Snapshot s = test::makeSnapshot({test::makeMesh(test::squareData())});
  const glm::dmat4 stretch = glm::scale(glm::dmat4(1), {8, 1, 1});
  glm::dmat4 before(0);
  for (const double turn : {0.0, 0.4}) {
    s.eyeFromWorld = glm::rotate(glm::translate(glm::dmat4(1), {0, 0, -5}), turn, {0, 1, 0}) * stretch;
    s.instances[0].eyeFromObject = s.eyeFromWorld;
    const GlbFile file = exported(s);
    const glm::dmat4 m = file.matrixOf(file.meshNodes()[0]);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(glm::length(m[c]), c == 0 ? 4 : 0.5, 1e-12) << "by the cube root of 8";
    for (int c = 0; c < 4 && before != glm::dmat4(0); ++c) EXPECT_LT(glm::length(m[c] - before[c]), 1e-12);
    before = m;
  }
}

TEST(GlbGeometry, AMirroredViewIsAMirroredWorld) {
  scene::Snapshot s = test::makeSnapshot({test::makeMesh(test::squareData())});
  s.camera.clipFromEye = glm::perspective(0.7, 1.0, 0.1, 10.0) * glm::scale(glm::dmat4(1), {-1, 1, 1});
  s.instances[0].eyeFromObject = s.eyeFromWorld = glm::translate(glm::dmat4(1), {0.5, 0, -5});
  s.instances[0].cull = scene::CullFace::front;
  const GlbFile file = exported(s);
  ASSERT_TRUE(file.gltf.contains("cameras"));
  const size_t node = file.meshNodes()[0];
  EXPECT_LT(glm::determinant(file.matrixOf(node)), 0);
  EXPECT_EQ(file.indices(file.primitive(0).at("indices"))[1], 1u)
      << "the window shows the side that is its front";
  // The square's middle is left of the middle of the window, so it is left of the camera's line of sight.
  const glm::dmat4 camera = file.matrixOf(node + 1);
  const glm::dvec3 middle(file.matrixOf(node)[3]);
  EXPECT_NEAR(glm::dot(middle - glm::dvec3(camera[3]), glm::dvec3(camera[0])), -0.5, 1e-9);
}

TEST(GlbGeometry, ViewsAreThoseOfCameras) {
  scene::Snapshot first = test::makeSnapshot({test::makeMesh(test::squareData())});
  first.camera.clipFromEye = glm::perspective(0.7, 1.0, 0.1, 10.0);
  first.view = 1;
  scene::Snapshot further = first, layers = first, overlay = first;
  further.camera.clipFromEye = glm::perspective(0.7, 1.0, 10.0, 100.0);
  layers.layers = std::make_shared<scene::Layers>();
  layers.view = 2;
  overlay.camera.clipFromEye = glm::ortho(0.0, 16.0, 0.0, 16.0);
  const auto scenes = [](const std::vector<scene::Snapshot>& batches) {
    return exported(batches).gltf["scenes"].size();
  };
  EXPECT_EQ(scenes({first, further}), 1u) << "a view in two parts of its depth";
  EXPECT_EQ(scenes({first, layers}), 1u) << "layers in a framebuffer of their own";
  EXPECT_EQ(scenes({first, overlay}), 2u);
  layers.camera.viewport = {0, 0, 8, 8};
  EXPECT_EQ(scenes({first, layers}), 2u);
}

TEST(GlbGeometry, ShearIsPutIntoVertices) {
  scene::Snapshot s = test::makeSnapshot({test::makeMesh(test::squareData())});
  s.instances.push_back(s.instances[0]);
  s.instances[1].eyeFromObject[1][0] = 1;  // x grows with y
  s.instances[1].eyeFromObject[2][2] = -1;
  const GlbFile file = exported(s);
  const size_t node = file.meshNodes()[1];
  EXPECT_EQ(file.matrixOf(node), glm::dmat4(1));
  const auto positions = file.attribute(1, "POSITION");
  EXPECT_EQ(glm::vec3(positions[2]), glm::vec3(2, 1, 0));
  EXPECT_EQ(file.indices(file.primitive(1).at("indices")), (std::vector<uint32_t>{0, 2, 1, 0, 3, 2}))
      << "a mirrored triangle turns";
}

TEST(GlbGeometry, ShowsTheSidesThatTheProgramShows) {
  const std::vector<uint32_t> given = {0, 1, 2, 0, 2, 3}, turned = {0, 2, 1, 0, 3, 2};
  const auto indices = [](const scene::Snapshot& s) {
    const GlbFile file = exported(s);
    return std::pair(file.indices(file.primitive(0).at("indices")),
                     file.materialOf(0).value("doubleSided", false));
  };
  scene::Snapshot s = test::makeSnapshot({test::makeMesh(test::squareData())});
  EXPECT_EQ(indices(s), std::pair(given, true));
  s.instances[0].cull = scene::CullFace::back;
  EXPECT_EQ(indices(s), std::pair(given, false));
  s.instances[0].cull = scene::CullFace::front;
  EXPECT_EQ(indices(s), std::pair(turned, false));
  s.instances[0].frontFaceCcw = false;
  EXPECT_EQ(indices(s), std::pair(given, false));
  s.instances[0].cull = scene::CullFace::none;
  test::MeshData data = test::squareData();
  data.normals.assign(4, {0, 0, -1});
  s.instances[0].mesh = test::makeMesh(data);
  EXPECT_EQ(indices(s), std::pair(turned, true)) << "normals say which side is outside";
}

TEST(GlbGeometry, LeavesOutPlacesThatAreNoNumbers) {
  test::MeshData data = test::squareData();
  data.positions.push_back({gluray::test::kInfinity, 0, 0});
  data.indices.insert(data.indices.end(), {0, 1, 4});
  std::vector<std::string> notes;
  const GlbFile file = exported(test::makeSnapshot({test::makeMesh(data)}), &notes);
  EXPECT_EQ(file.attribute(0, "POSITION").size(), 6u) << "the corners of two triangles";
  EXPECT_EQ(notes.size(), 1u);
}

TEST(GlbGeometry, ClipPlanesCutSurfaces) {
  test::MeshData data = test::squareData();
  data.colors = {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 0, 0, 1}, {0, 0, 0, 1}};
  scene::Snapshot s = test::makeSnapshot({test::makeMesh(data)});
  s.eyeFromWorld = glm::translate(glm::dmat4(1), {1, 0, -3});
  s.instances[0].eyeFromObject = s.eyeFromWorld;
  s.instances[0].clipPlanes = {{-2, 0, 0, 3}, {0, 1, 0, 9}};  // x <= 1.5 in eye space, 0.5 in object space
  const GlbFile file = exported(s);
  const auto positions = file.attribute(0, "POSITION"), colors = file.attribute(0, "COLOR_0");
  double area = 0;
  const auto indices = file.indices(file.primitive(0).at("indices"));
  for (size_t i = 0; i < indices.size(); i += 3) {
    const glm::vec3 a(positions[indices[i]]), b(positions[indices[i + 1]]), c(positions[indices[i + 2]]);
    area += 0.5 * glm::cross(b - a, c - a).z;
  }
  EXPECT_NEAR(area, 3, 1e-6) << "of 4, and no triangle turned";
  EXPECT_EQ(file.accessor(file.primitive(0)["attributes"]["POSITION"])["max"], test::json({0.5, 1, 0}));
  for (size_t i = 0; i < colors.size(); ++i)
    EXPECT_NEAR(scene::encodedSrgb(colors[i].r), (positions[i].x + 1) / 2, 1e-6f);
  s.instances.push_back(s.instances[0]);
  s.instances[1].clipPlanes = {{1, 0, 0, -9}};
  s.instances[1].color = {1, 0, 0, 1};
  s.shadings.push_back(s.shadings[0]);
  s.shadings[1].lighting = true, s.instances[1].shading = 1;
  EXPECT_EQ(exported(s).meshNodes().size(), 1u) << "nothing is left of the other";
}

TEST(GlbGeometry, PaintedEdgesAreLines) {
  scene::Snapshot s = test::makeSnapshot({test::makeMesh(test::squareData())});
  scene::FragmentShading& f = s.shadings[0].fragment;
  f.model = scene::FragmentShading::Model::phong, f.edges = true, f.edgeColor = {1, 0, 0};
  GlbFile file = exported(s);
  ASSERT_EQ(file.meshNodes().size(), 2u);
  EXPECT_EQ(file.primitive(0).at("mode"), 1);
  EXPECT_EQ(file.indices(file.primitive(0).at("indices")),
            (std::vector<uint32_t>{0, 1, 0, 2, 0, 3, 1, 2, 2, 3}));
  EXPECT_EQ(file.materialOf(0)["pbrMetallicRoughness"]["baseColorFactor"], test::json({1, 0, 0, 1}));
  EXPECT_EQ(file.accessor(file.primitive(0)["attributes"]["POSITION"]),
            file.accessor(file.primitive(1)["attributes"]["POSITION"]));
  // Without the diagonal: the last edge of the first triangle and the first of the second.
  s.instances[0].triangleEdges = gluray::test::makeAttribute<uint8_t>({9, 3, 6}, scene::Format::bits8);
  s.instances[0].triangleOffset = 1;
  EXPECT_EQ(exported(s).gltf["accessors"][1]["count"], 8);
  f.edgesAlone = true;
  file = exported(s);
  EXPECT_EQ(file.meshNodes().size(), 1u) << "lines alone";
  EXPECT_EQ(file.primitive(0).at("mode"), 1);
}

TEST(GlbGeometry, PointsAndLinesStayPointsAndLines) {
  test::MeshData data = test::squareData();
  data.indices = {0, 1, 1, 2, 2, 3};
  for (const auto shape : {scene::Shape::tubes, scene::Shape::beads}) {
    auto mesh = std::const_pointer_cast<scene::Mesh>(test::makeMesh(data));
    mesh->shape = shape, mesh->triangleCount = 6 / cornersOf(shape);
    const GlbFile file = exported(test::makeSnapshot({mesh}));
    EXPECT_EQ(file.primitive(0).at("mode"), shape == scene::Shape::tubes ? 1 : 0);
    EXPECT_EQ(file.indices(file.primitive(0).at("indices")), data.indices);
    EXPECT_TRUE(file.materialOf(0).contains("extensions")) << "unlit";
  }
}

}  // namespace
}  // namespace gluray::saved
