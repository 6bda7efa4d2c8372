// The checker finds mistakes of every kind in a file that is right otherwise.
#include "saved/testing/test_export.h"

#include <functional>

namespace gluray::saved {
namespace {

using test::GlbFile;
using test::json;

/// A lit and textured square under a matrix, with a camera.
GlbFile soundFile() {
  test::MeshData data = test::squareData();
  data.normals.assign(4, {0, 0, 1}), data.colors.assign(4, {0.5f, 1, 0, 1}),
      data.texcoords.assign(4, {0, 0, 0, 1});
  scene::Snapshot s = test::makeSnapshot({test::makeMesh(data)});
  auto image = std::make_shared<scene::TextureImage>();
  image->width = image->height = 1, image->texels = {~0u};
  s.shadings[0].textures.resize(1);
  s.shadings[0].textures[0].image = image;
  s.eyeFromWorld[3] = {1, 2, 3, 1};
  return test::exported(s);
}

TEST(GlbChecker, FindsMistakes) {
  const std::vector<std::pair<const char*, std::function<void(GlbFile&)>>> mistakes = {
      {"bounds", [](GlbFile& f) { f.gltf["accessors"][0]["min"][0] = -0.99; }},
      {"beyond the vertices",
       [](GlbFile& f) {
         f.binary[f.gltf["bufferViews"][f.primitive(0)["indices"].get<size_t>()]["byteOffset"]
                      .get<size_t>()] = 4;
       }},
      {"unit length",
       [](GlbFile& f) { f.binary[f.gltf["bufferViews"][1]["byteOffset"].get<size_t>() + 11] = 0; }},
      {"beyond its bufferView", [](GlbFile& f) { f.gltf["accessors"][0]["count"] = 5; }},
      {"beyond the buffer", [](GlbFile& f) { f.gltf["bufferViews"][0]["byteLength"] = 1 << 20; }},
      {"aligned", [](GlbFile& f) { f.gltf["accessors"][0]["byteOffset"] = 2; }},
      {"byteLength", [](GlbFile& f) { f.gltf["buffers"][0]["byteLength"] = f.binary.size() - 8; }},
      {"extensionsUsed", [](GlbFile& f) { f.gltf["extensionsUsed"].push_back("KHR_none"); }},
      {"extensions are required", [](GlbFile& f) { f.gltf["extensionsRequired"] = {"KHR_none"}; }},
      {"factor", [](GlbFile& f) { f.gltf["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] = 1.5; }},
      {"alphaCutoff", [](GlbFile& f) { f.gltf["materials"][0]["alphaCutoff"] = 0.5; }},
      {"without its coordinates",
       [](GlbFile& f) { f.gltf["meshes"][0]["primitives"][0]["attributes"].erase("TEXCOORD_0"); }},
      {"wrapS", [](GlbFile& f) { f.gltf["samplers"][0]["wrapS"] = 10496; }},
      {"no PNG",
       [](GlbFile& f) {
         f.binary[f.gltf["bufferViews"][f.gltf["images"][0]["bufferView"].get<size_t>()]["byteOffset"]
                      .get<size_t>()] = 0;
       }},
      {"index into nodes", [](GlbFile& f) { f.gltf["scenes"][0]["nodes"][0] = 9; }},
      {"rotation",
       [](GlbFile& f) { f.gltf["nodes"][0]["matrix"] = {1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; }},
      {"zfar", [](GlbFile& f) { f.gltf["cameras"][0]["orthographic"]["zfar"] = -1; }},
      {"nothing uses", [](GlbFile& f) { f.gltf["materials"].push_back(f.gltf["materials"][0]); }},
      {"version", [](GlbFile& f) { f.gltf["asset"]["version"] = "1.0"; }},
  };
  for (const auto& [words, plant] : mistakes) {
    GlbFile file = soundFile();
    plant(file);
    const test::GlbChecker checker(file);
    std::string found;
    for (const std::string& problem : checker.problems()) found += problem + "; ";
    EXPECT_NE(found.find(words), std::string::npos) << "found: " << found;
  }
}

}  // namespace
}  // namespace gluray::saved
