// Reads binary glTF files again, for tests: the chunks, and the arrays of accessors.
#pragma once
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace gluray::saved::test {

using nlohmann::json;

inline size_t bytesOfComponent(int type) { return type == 5126 || type == 5125 ? 4 : type == 5123 ? 2 : 1; }
inline size_t componentsOf(const std::string& type) {
  return type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 0;
}

struct GlbFile {
  json gltf;
  std::string binary;

  /// Throws std::runtime_error where the container is not as the specification has it.
  static GlbFile parse(const std::string& bytes) {
    const auto must = [](bool holds, const char* what) {
      if (!holds) throw std::runtime_error(what);
    };
    const auto word = [&](size_t at) {
      must(at + 4 <= bytes.size(), "the file ends early");
      uint32_t value = 0;
      std::memcpy(&value, bytes.data() + at, 4);
      return value;
    };
    must(word(0) == 0x46546C67, "magic");
    must(word(4) == 2, "version");
    must(word(8) == bytes.size(), "length of the file");
    const size_t length = word(12);
    must(length % 4 == 0 && word(16) == 0x4E4F534A, "the first chunk");
    GlbFile file;
    const std::string text = bytes.substr(20, length);
    must(text.back() == '}' || text.back() == ' ', "padding by spaces");
    file.gltf = json::parse(text);
    const size_t at = 20 + length;
    if (at == bytes.size()) return file;
    must(word(at) % 4 == 0 && word(at + 4) == 0x004E4942, "the second chunk");
    must(at + 8 + word(at) == bytes.size(), "length of the second chunk");
    file.binary = bytes.substr(at + 8);
    return file;
  }

  const json& accessor(size_t i) const { return gltf.at("accessors").at(i); }
  const char* dataOf(const json& accessor) const {
    const json& view = gltf.at("bufferViews").at(accessor.at("bufferView").get<size_t>());
    return binary.data() + view.value("byteOffset", size_t{0}) + accessor.value("byteOffset", size_t{0});
  }
  /// The elements; integers that are normalised become 0 .. 1.
  std::vector<glm::vec4> vectors(size_t index) const {
    const json& a = accessor(index);
    const size_t parts = componentsOf(a.at("type"));
    const int type = a.at("componentType");
    const char* data = dataOf(a);
    std::vector<glm::vec4> out(a.at("count").get<size_t>(), glm::vec4(0, 0, 0, 1));
    for (glm::vec4& v : out)
      for (size_t c = 0; c < parts; ++c, data += bytesOfComponent(type)) {
        float value = 0;
        if (uint16_t number = 0; type == 5123) {
          std::memcpy(&number, data, 2);
          value = static_cast<float>(number) / 65535;
        } else {
          std::memcpy(&value, data, 4);
        }
        v[static_cast<glm::length_t>(c)] = value;
      }
    return out;
  }
  std::vector<uint32_t> indices(size_t index) const {
    const json& a = accessor(index);
    std::vector<uint32_t> out(a.at("count").get<size_t>());
    std::memcpy(out.data(), dataOf(a), out.size() * 4);
    return out;
  }
  /// The only primitive of a mesh.
  const json& primitive(size_t mesh) const { return gltf.at("meshes").at(mesh).at("primitives").at(0); }
  std::vector<glm::vec4> attribute(size_t mesh, const char* name) const {
    return vectors(primitive(mesh).at("attributes").at(name));
  }
  const json& materialOf(size_t mesh) const {
    return gltf.at("materials").at(primitive(mesh).at("material").get<size_t>());
  }
  /// Numbers of the nodes that show meshes.
  std::vector<size_t> meshNodes() const {
    std::vector<size_t> out;
    for (size_t i = 0; i < gltf.at("nodes").size(); ++i)
      if (gltf["nodes"][i].contains("mesh")) out.push_back(i);
    return out;
  }
  glm::dmat4 matrixOf(size_t node) const {
    glm::dmat4 m(1);
    const json& all = gltf.at("nodes").at(node);
    if (all.contains("matrix"))
      for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = all["matrix"].at(static_cast<size_t>(i));
    return m;
  }
};

}  // namespace gluray::saved::test
