// A strict checker for binary glTF files, for tests: what the specification (Khronos, "glTF 2.0
// Specification", 2021, and the extensions KHR_lights_punctual and KHR_materials_unlit) demands of what
// GLuRay writes.
#pragma once
#include "saved/testing/glb_file.h"

#include <cmath>
#include <initializer_list>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace gluray::saved::test {

class GlbChecker {
 public:
  explicit GlbChecker(const GlbFile& file) : file_(file), gltf_(file.gltf) {
    expect(gltf_.at("asset").at("version") == "2.0", "asset.version");
    checkBuffer();
    for (const json& mesh : list("meshes")) {
      expect(!mesh.at("primitives").empty(), "a mesh without primitives");
      for (const json& primitive : mesh["primitives"]) checkPrimitive(primitive);
    }
    for (const json& material : list("materials")) checkMaterial(material);
    checkTextures();
    checkNodes();
    for (const json& camera : list("cameras")) checkCamera(camera);
    checkLights();
    expect(!gltf_.contains("extensionsRequired"), "extensions are required");
    expect(declared() == used_, "extensionsUsed is not what is used");
    checkUse();
  }
  const std::vector<std::string>& problems() const { return problems_; }

 private:
  void expect(bool holds, const std::string& what) {
    if (!holds) problems_.push_back(what);
  }
  const json& list(const char* name) const {
    static const json kNone = json::array();
    return gltf_.contains(name) ? gltf_[name] : kNone;
  }
  /// Whether the number is an index into a list; remembers that it is used.
  bool refer(const char* name, const json& index) {
    const bool holds = index.is_number_unsigned() && index.get<size_t>() < list(name).size();
    expect(holds, std::string("an index into ") + name);
    if (holds) uses_.emplace(name, index.get<size_t>());
    return holds;
  }
  std::set<std::string> declared() const {
    const json names = list("extensionsUsed");
    return {names.begin(), names.end()};
  }

  void checkBuffer() {
    const json buffers = list("buffers");
    expect(buffers.size() <= 1 && (buffers.size() == 1) == !file_.binary.empty(), "one buffer, in the file");
    if (buffers.empty()) return;
    const size_t size = buffers[0].at("byteLength");
    expect(size <= file_.binary.size() && file_.binary.size() < size + 4, "byteLength of the buffer");
    for (const json& view : list("bufferViews")) {
      const size_t offset = view.value("byteOffset", size_t{0}), length = view.at("byteLength");
      expect(view.at("buffer") == 0 && length >= 1 && offset + length <= size,
             "a bufferView beyond the buffer");
    }
    for (const json& accessor : list("accessors")) checkAccessor(accessor);
  }

  void checkAccessor(const json& a) {
    if (!refer("bufferViews", a.at("bufferView"))) return;
    const json& view = gltf_["bufferViews"][a["bufferView"].get<size_t>()];
    const int type = a.at("componentType");
    const size_t each = bytesOfComponent(type), parts = componentsOf(a.at("type")), count = a.at("count");
    expect(type >= 5120 && type <= 5126 && type != 5124 && parts > 0 && count >= 1, "an accessor's form");
    const size_t offset = a.value("byteOffset", size_t{0}),
                 start = view.value("byteOffset", size_t{0}) + offset;
    expect(start % each == 0 && offset % each == 0, "an accessor is not aligned to its components");
    expect(offset + count * each * parts <= view.at("byteLength"), "an accessor beyond its bufferView");
    expect(view.value("target", 0) == 34963 || each * parts % 4 == 0,
           "a vertex's bytes are no multiple of 4");
    expect(!a.value("normalized", false) || type != 5126, "floats are not normalised");
  }

  void checkPrimitive(const json& p) {
    const json& attributes = p.at("attributes");
    expect(attributes.contains("POSITION"), "no POSITION");
    size_t count = 0;
    for (const auto& [name, index] : attributes.items()) {
      if (!refer("accessors", index)) return;
      const size_t these = file_.accessor(index).at("count");
      expect(count == 0 || these == count, "attributes of several lengths");
      count = these;
      checkAttribute(name, index);
    }
    size_t elements = count;
    if (p.contains("indices") && refer("accessors", p["indices"])) {
      const json& a = file_.accessor(p["indices"]);
      expect(a.at("type") == "SCALAR" && a.at("componentType") == 5125, "the form of indices");
      const std::vector<uint32_t> indices = file_.indices(p["indices"]);
      for (const uint32_t i : indices)
        if (i >= count) return expect(false, "an index beyond the vertices");
      elements = indices.size();
    }
    const int mode = p.value("mode", 4);
    expect(mode == 4   ? elements % 3 == 0
           : mode == 1 ? elements % 2 == 0
                       : mode == 0,
           "a mode, or its elements");
    if (!p.contains("material") || !refer("materials", p["material"])) return;
    const json& m = gltf_["materials"][p["material"].get<size_t>()];
    for (const json* texture : texturesOf(m))
      expect(attributes.contains("TEXCOORD_" + std::to_string(texture->value("texCoord", 0))),
             "a texture without its coordinates");
  }

  void checkAttribute(const std::string& name, size_t index) {
    const json& a = file_.accessor(index);
    const std::string type = a.at("type");
    const bool floats = a.at("componentType") == 5126;
    const std::vector<glm::vec4> values = file_.vectors(index);
    bool finite = true, unit = true, inRange = true, signs = true;
    glm::vec4 lower(INFINITY), upper(-INFINITY);
    for (const glm::vec4& v : values) {
      finite &= std::isfinite(v.x + v.y + v.z + v.w);
      unit &= std::abs(glm::length(glm::vec3(v)) - 1) < 1e-5f;
      signs &= v.w == 1 || v.w == -1;
      for (int c = 0; c < 4; ++c) inRange &= v[c] >= 0 && v[c] <= 1;
      lower = glm::min(lower, v), upper = glm::max(upper, v);
    }
    expect(finite, name + " is not finite");
    if (name == "POSITION") {
      expect(floats && type == "VEC3", "the form of POSITION");
      for (size_t c = 0; c < 3; ++c) {
        const auto k = static_cast<glm::length_t>(c);
        expect(a.at("min").at(c).get<float>() == lower[k] && a.at("max").at(c).get<float>() == upper[k],
               "bounds of POSITION are not its data's");
      }
    } else if (name == "NORMAL") {
      expect(floats && type == "VEC3" && unit, "NORMAL is not of unit length");
    } else if (name == "TANGENT") {
      expect(floats && type == "VEC4" && unit && signs, "TANGENT");
    } else if (name == "COLOR_0") {
      expect((type == "VEC4" || type == "VEC3") && (floats || a.value("normalized", false)) && inRange,
             "COLOR_0");
    } else {
      expect(name.rfind("TEXCOORD_", 0) == 0 && floats && type == "VEC2", "attribute " + name);
    }
  }

  static std::vector<const json*> texturesOf(const json& m) {
    std::vector<const json*> all;
    const auto add = [&](const json& from, const char* name) {
      if (from.contains(name)) all.push_back(&from[name]);
    };
    const json& pbr = m.at("pbrMetallicRoughness");
    add(pbr, "baseColorTexture"), add(pbr, "metallicRoughnessTexture");
    add(m, "normalTexture"), add(m, "occlusionTexture"), add(m, "emissiveTexture");
    return all;
  }

  void checkMaterial(const json& m) {
    const json& pbr = m.at("pbrMetallicRoughness");
    const auto inRange = [&](const json& all) {
      for (const json& v : all)
        expect(v.get<double>() >= 0 && v.get<double>() <= 1, "a factor of a material");
    };
    inRange(pbr.at("baseColorFactor"));
    inRange(json::array({pbr.at("metallicFactor"), pbr.at("roughnessFactor")}));
    inRange(m.value("emissiveFactor", json::array()));
    expect(pbr["baseColorFactor"].size() == 4, "baseColorFactor");
    const std::string alpha = m.value("alphaMode", "OPAQUE");
    expect(alpha == "OPAQUE" || alpha == "BLEND" || alpha == "MASK", "alphaMode");
    expect(!m.contains("alphaCutoff") || (alpha == "MASK" && m["alphaCutoff"] >= 0), "alphaCutoff");
    for (const json* texture : texturesOf(m)) refer("textures", texture->at("index"));
    noteExtensions(m);
  }

  void noteExtensions(const json& of) {
    if (!of.contains("extensions")) return;
    for (const auto& [name, value] : of["extensions"].items()) used_.insert(name);
  }

  void checkTextures() {
    for (const json& t : list("textures")) {
      refer("samplers", t.at("sampler"));
      refer("images", t.at("source"));
    }
    for (const json& s : list("samplers")) {
      for (const char* name : {"wrapS", "wrapT"})
        expect(std::set<int>{10497, 33071, 33648}.count(s.at(name)) == 1, name);
      expect(s.at("magFilter") == 9728 || s.at("magFilter") == 9729, "magFilter");
      expect(std::set<int>{9728, 9729, 9984, 9985, 9986, 9987}.count(s.at("minFilter")) == 1, "minFilter");
    }
    for (const json& image : list("images")) {
      if (!refer("bufferViews", image.at("bufferView"))) continue;
      expect(image.at("mimeType") == "image/png", "mimeType");
      const json& view = gltf_["bufferViews"][image["bufferView"].get<size_t>()];
      expect(!view.contains("target"), "a target of an image");
      const size_t at = view.value("byteOffset", size_t{0});
      expect(file_.binary.compare(at, 8, "\x89PNG\r\n\x1a\n") == 0, "an image is no PNG file");
    }
  }

  void checkNodes() {
    std::set<size_t> children;
    for (const json& node : list("nodes")) {
      if (node.contains("mesh")) refer("meshes", node["mesh"]);
      if (node.contains("camera")) refer("cameras", node["camera"]);
      for (const json& child : node.value("children", json::array()))
        if (refer("nodes", child))
          expect(children.insert(child.get<size_t>()).second, "a node with two parents");
      if (node.contains("matrix")) checkMatrix(node["matrix"]);
      noteExtensions(node);
    }
    expect(!gltf_.contains("scene") || gltf_["scene"].get<size_t>() < list("scenes").size(), "scene");
    for (const json& scene : list("scenes")) {
      expect(!scene.contains("nodes") || !scene["nodes"].empty(), "an empty list of nodes");
      for (const json& root : scene.value("nodes", json::array()))
        if (refer("nodes", root)) expect(children.count(root.get<size_t>()) == 0, "a child at the root");
    }
  }

  void checkMatrix(const json& values) {
    expect(values.size() == 16, "a matrix of 16 numbers");
    if (values.size() != 16) return;
    glm::dmat4 m;
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = values[static_cast<size_t>(i)];
    expect(m[0].w == 0 && m[1].w == 0 && m[2].w == 0 && m[3].w == 1, "a matrix that is not affine");
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 a(m[i]), b(m[(i + 1) % 3]);
      expect(glm::length(a) > 0 && std::abs(glm::dot(a, b)) <= 1e-4 * glm::length(a) * glm::length(b),
             "a matrix that is no translation, rotation and scaling");
    }
  }

  void checkCamera(const json& camera) {
    const std::string type = camera.at("type");
    const json& c = camera.at(type);
    expect(c.at("zfar") > c.at("znear"), "zfar");
    if (type == "perspective")
      expect(c.at("yfov") > 0 && c["yfov"] < 3.1416 && c["znear"] > 0 && c.at("aspectRatio") > 0,
             "a perspective");
    else
      expect(type == "orthographic" && c.at("xmag") > 0 && c.at("ymag") > 0 && c["znear"] >= 0,
             "a parallel view");
  }

  void checkLights() {
    if (!gltf_.contains("extensions")) return;
    noteExtensions(gltf_);
    const json& lights = gltf_["extensions"].at("KHR_lights_punctual").at("lights");
    for (const json& light : lights) {
      const std::string type = light.at("type");
      expect(type == "directional" || type == "point" || type == "spot", "the type of a light");
      expect(light.at("intensity") > 0 && light.at("color").size() == 3, "a light");
      if (type != "spot") continue;
      const json& spot = light.at("spot");
      expect(spot.at("innerConeAngle") >= 0 && spot["innerConeAngle"] < spot.at("outerConeAngle") &&
                 spot["outerConeAngle"] <= 1.57079632679489662,
             "a spot's angles");
    }
    for (const json& node : list("nodes"))
      if (node.contains("extensions"))
        expect(node["extensions"].at("KHR_lights_punctual").at("light") < lights.size(),
               "an index into lights");
  }

  /// Nothing is written that nobody uses.
  void checkUse() {
    for (const char* name : {"accessors", "bufferViews", "meshes", "materials", "textures", "images",
                             "samplers", "cameras", "nodes"})
      for (size_t i = 0; i < list(name).size(); ++i)
        expect(uses_.count({name, i}) == 1, std::string(name) + ": one that nothing uses");
  }

  const GlbFile& file_;
  const json& gltf_;
  std::set<std::pair<std::string, size_t>> uses_;
  std::set<std::string> used_;
  std::vector<std::string> problems_;
};

}  // namespace gluray::saved::test
