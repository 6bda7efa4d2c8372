// Formats by name, OBJ and PLY, and what stays after failures.
#include "saved/testing/libpng_encoder.h"
#include "saved/testing/test_export.h"

#include <glm/gtc/matrix_transform.hpp>
#include <png.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <set>
#include <sstream>

namespace gluray::saved {
namespace {

using test::TemporaryFolderFiles;
using test::textOf;

scene::SnapshotPtr colouredSquare() {
  test::MeshData data = test::squareData();
  data.normals.assign(4, {0, 0, 1});
  data.colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}};
  scene::Snapshot s = test::makeSnapshot({test::makeMesh(data)});
  s.instances.push_back(s.instances[0]);
  s.instances[1].eyeFromObject = glm::translate(glm::dmat4(1), {0, 0, 2});
  s.instances[1].object = {7};
  return std::make_shared<const scene::Snapshot>(s);
}

TEST(ExportScene, KnowsFormatsByTheirNames) {
  EXPECT_EQ(sceneFormatOf("/a.b/c.glb"), SceneFormat::glb);
  EXPECT_EQ(sceneFormatOf("X.OBJ"), SceneFormat::obj);
  EXPECT_EQ(sceneFormatOf("x.ply"), SceneFormat::ply);
  for (const char* name : {"x", "glb", "x.gltf", "x.glb.png", "", "."})
    EXPECT_EQ(sceneFormatOf(name), std::nullopt);
}

TEST(ExportScene, WritesPly) {
  const TemporaryFolderFiles files;
  const ExportResult result =
      exportScene({colouredSquare()}, files.file("a.ply"), SceneFormat::ply, test::encodePng);
  ASSERT_TRUE(result.written) << result.why;
  const std::string text = textOf(files.file("a.ply"));
  const std::string end = "end_header\n";
  const size_t at = text.find(end) + end.size();
  EXPECT_NE(text.find("element vertex 8\n"), std::string::npos);
  EXPECT_NE(text.find("element face 4\n"), std::string::npos);
  ASSERT_EQ(text.size(), at + 8 * 28 + 4 * 13);
  float numbers[6];
  std::memcpy(numbers, text.data() + at + 6 * 28, sizeof numbers);
  EXPECT_EQ((std::vector<float>(numbers, numbers + 6)), (std::vector<float>{1, 1, 2, 0, 0, 1}))
      << "world space";
  EXPECT_EQ(text.substr(at + 6 * 28 + 24, 4), std::string("\0\0\xFF\xFF", 4)) << "displayed colours";
  uint32_t face[3];
  std::memcpy(face, text.data() + at + 8 * 28 + 3 * 13 + 1, sizeof face);
  EXPECT_EQ(std::vector<uint32_t>(face, face + 3), (std::vector<uint32_t>{4, 6, 7}));
}

TEST(ExportScene, WritesObjWithMaterials) {
  const TemporaryFolderFiles files;
  const ExportResult result =
      exportScene({colouredSquare()}, files.file("a.obj"), SceneFormat::obj, test::encodePng);
  ASSERT_TRUE(result.written) << result.why;
  std::istringstream lines(textOf(files.file("a.obj")));
  std::multiset<std::string> words;
  std::string line, lastFace, groups;
  std::vector<std::string> vertices;
  while (std::getline(lines, line)) {
    const std::string word = line.substr(0, line.find(' '));
    words.insert(word);
    if (word == "v") vertices.push_back(line);
    if (word == "f") lastFace = line;
    if (word == "g") groups += line + ";";
  }
  EXPECT_EQ(vertices.at(6), "v 1 1 2 0 0 1");
  EXPECT_EQ(words.count("vn"), 8u);
  EXPECT_EQ(words.count("f"), 4u);
  EXPECT_EQ(lastFace, "f 5//5 7//7 8//8");
  EXPECT_EQ(groups, "g instance_0;g object_7_instance_1;");
  EXPECT_NE(textOf(files.file("a.mtl")).find("newmtl material_0\n"), std::string::npos);
  EXPECT_EQ(files.names(), (std::set<std::string>{"a.obj", "a.mtl"}));
}

/// Two texels, the lower one red and the upper one green, on a square.
scene::SnapshotPtr twoTexelSquare() {
  test::MeshData data = test::squareData();
  data.texcoords = {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}, {0, 1, 0, 1}};
  scene::Snapshot s = test::makeSnapshot({test::makeMesh(data)});
  auto image = std::make_shared<scene::TextureImage>();
  image->width = 1, image->height = 2, image->texels = {0xFF0000FF, 0xFF00FF00};
  s.shadings[0].textures.resize(1);
  scene::Texture& t = s.shadings[0].textures[0];
  t.image = image;
  t.wrapS = t.wrapT = scene::Wrap::clampToEdge, t.magFilter = t.minFilter = scene::Filter::nearest;
  return std::make_shared<const scene::Snapshot>(s);
}

TEST(ExportScene, WritesTexturesBesideObj) {
  const TemporaryFolderFiles files;
  ASSERT_TRUE(
      exportScene({twoTexelSquare()}, files.file("a.obj"), SceneFormat::obj, test::encodePng).written);
  EXPECT_EQ(files.names(), (std::set<std::string>{"a.obj", "a.mtl", "a_0.png"}));
  EXPECT_NE(textOf(files.file("a.mtl")).find("map_Kd -clamp on a_0.png\n"), std::string::npos);
  EXPECT_NE(textOf(files.file("a.obj")).find("vt 1 1\n"), std::string::npos);
  EXPECT_NE(textOf(files.file("a.obj")).find("f 1/1 2/2 3/3\n"), std::string::npos);
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_TRUE(png_image_begin_read_from_file(&png, files.file("a_0.png").c_str())) << png.message;
  png.format = PNG_FORMAT_RGBA;
  uint32_t texels[2] = {};
  ASSERT_TRUE(png_image_finish_read(&png, nullptr, texels, 0, nullptr)) << png.message;
  EXPECT_EQ(texels[0], 0xFF00FF00) << "upright, since t = 0 is the lower edge in OBJ files";
  EXPECT_EQ(texels[1], 0xFF0000FF);
}

TEST(ExportScene, WritesTexturesAsColoursOfVerticesInPly) {
  const TemporaryFolderFiles files;
  const ExportResult result =
      exportScene({twoTexelSquare()}, files.file("a.ply"), SceneFormat::ply, test::encodePng);
  ASSERT_TRUE(result.written) << result.why;
  EXPECT_EQ(result.notes, std::vector<std::string>{"textures were written as colours of vertices"});
  const std::string text = textOf(files.file("a.ply")), end = "end_header\n";
  const size_t at = text.find(end) + end.size();
  for (const size_t vertex : {0, 1, 2, 3})
    EXPECT_EQ(text.substr(at + 16 * vertex + 12, 4),
              vertex < 2 ? std::string("\xFF\0\0\xFF", 4) : std::string("\0\xFF\0\xFF", 4));
}

TEST(ExportScene, RefusesAFrameWithoutSurfaces) {
  const TemporaryFolderFiles files;
  const ExportResult result = exportScene({}, files.file("a.glb"), SceneFormat::glb, test::encodePng);
  EXPECT_FALSE(result.written);
  EXPECT_NE(result.why.find("shows no surface"), std::string::npos);
  EXPECT_TRUE(files.names().empty());
}

TEST(ExportScene, KeepsTheLastFileWhenTheDiskIsFull) {
  for (const char* name : {"a.glb", "a.obj", "a.ply"}) {
    const TemporaryFolderFiles files;
    files.write(name, "the last good file");
    const auto before = files.names();
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    const rlimit small{100, limit.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    const ExportResult result =
        exportScene({colouredSquare()}, files.file(name), *sceneFormatOf(name), test::encodePng);
    setrlimit(RLIMIT_FSIZE, &limit);
    EXPECT_FALSE(result.written);
    EXPECT_NE(result.why.find("File too large; free some space, or choose another folder"), std::string::npos)
        << result.why;
    EXPECT_EQ(result.why.find('\n'), std::string::npos);
    EXPECT_EQ(textOf(files.file(name)), "the last good file");
    EXPECT_EQ(files.names(), before) << "nothing else is left";
  }
}

TEST(ExportScene, KeepsTheLastFileInAFolderThatMayOnlyBeRead) {
  const TemporaryFolderFiles files;
  files.write("a.glb", "the last good file");
  chmod(files.path().c_str(), 0555);
  const bool root = geteuid() == 0;
  ASSERT_EQ(root ? seteuid(65534) : 0, 0);
  const ExportResult result =
      exportScene({colouredSquare()}, files.file("a.glb"), SceneFormat::glb, test::encodePng);
  const ExportResult fresh =
      exportScene({colouredSquare()}, files.file("b.glb"), SceneFormat::glb, test::encodePng);
  ASSERT_EQ(root ? seteuid(0) : 0, 0);
  chmod(files.path().c_str(), 0755);
  for (const ExportResult& r : {result, fresh}) {
    EXPECT_FALSE(r.written);
    EXPECT_NE(r.why.find("Permission denied; choose a folder and a file that you may write"),
              std::string::npos)
        << r.why;
  }
  EXPECT_EQ(textOf(files.file("a.glb")), "the last good file");
  EXPECT_EQ(files.names(), std::set<std::string>{"a.glb"});
}

TEST(ExportScene, RefusesFilesThatTheFormatCannotHold) {
  // Every vertex is the same one in memory.
  auto mesh = std::const_pointer_cast<scene::Mesh>(test::makeMesh(test::squareData()));
  mesh->indices = {}, mesh->positions.stride = 0;
  mesh->vertexCount = 360'000'000, mesh->triangleCount = mesh->vertexCount / 3;
  const TemporaryFolderFiles files;
  const auto s = std::make_shared<const scene::Snapshot>(test::makeSnapshot({mesh}));
  const ExportResult result = exportScene({s}, files.file("a.glb"), SceneFormat::glb, test::encodePng);
  EXPECT_FALSE(result.written);
  EXPECT_NE(result.why.find("glTF files have at most 4 GiB"), std::string::npos) << result.why;
  EXPECT_TRUE(files.names().empty());
}

TEST(ExportScene, SaysWhatToDoAboutNames) {
  const TemporaryFolderFiles files;
  const auto why = [&](const std::string& file) {
    return exportScene({colouredSquare()}, file, SceneFormat::glb, test::encodePng).why;
  };
  EXPECT_EQ(why("/no such/a.glb"),
            "cannot write /no such/a.glb: No such file or directory; make the folder first");
  std::filesystem::create_directory(files.file("d.glb"));
  EXPECT_NE(why(files.file("d.glb")).find("Is a directory"), std::string::npos);
  EXPECT_NE(why("/dev/full").find("it is a device, not a regular file"), std::string::npos);
}

}  // namespace
}  // namespace gluray::saved
