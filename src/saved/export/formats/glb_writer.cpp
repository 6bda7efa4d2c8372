#include "saved/export/formats/glb_writer.h"

#include "saved/export/arrays/linear_colors.h"
#include "saved/export/formats/glb_buffer.h"
#include "saved/export/formats/glb_lights.h"

#include <glm/gtc/constants.hpp>
#include <nlohmann/json.hpp>

#include <cstring>
#include <limits>
#include <set>
#include <utility>

namespace gluray::saved {
namespace {

using nlohmann::json;
using Alpha = ExportedMaterial::Alpha;

constexpr uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942, kMagic = 0x46546C67, kVersion = 2;

int wrapOf(scene::Wrap wrap) {
  return wrap == scene::Wrap::repeat ? 10497 : wrap == scene::Wrap::mirroredRepeat ? 33648 : 33071;
}

json samplerOf(const ExportedTexture& t) {
  constexpr int kNearest = 9728, kLinear = 9729,
                kMip = 9984;  // kMip: then linear, then linear between levels
  const int mag = t.magFilter == scene::Filter::linear ? kLinear : kNearest;
  int min = t.minFilter == scene::Filter::linear ? kLinear : kNearest;
  if (t.mipFilter != scene::MipFilter::none)
    min = kMip + (t.minFilter == scene::Filter::linear ? 1 : 0) +
          (t.mipFilter == scene::MipFilter::linear ? 2 : 0);
  return {{"magFilter", mag}, {"minFilter", min}, {"wrapS", wrapOf(t.wrapS)}, {"wrapT", wrapOf(t.wrapT)}};
}

json useOf(const TextureUse& use) {
  json out = {{"index", use.texture}};
  if (use.coordinates) out["texCoord"] = use.coordinates;
  return out;
}

/// The number that prints as the float does.
json numbersOf(const glm::vec3& v) { return {v.x, v.y, v.z}; }

json materialOf(const ExportedMaterial& m) {
  const glm::vec4 color = linearOf(m.color);
  json pbr = {{"baseColorFactor", {color.r, color.g, color.b, color.a}},
              {"metallicFactor", m.metallic},
              {"roughnessFactor", m.roughness}};
  if (m.base) pbr["baseColorTexture"] = useOf(m.base);
  if (m.metallicRoughness) pbr["metallicRoughnessTexture"] = useOf(m.metallicRoughness);
  json out = {{"pbrMetallicRoughness", std::move(pbr)}};
  if (m.normal) (out["normalTexture"] = useOf(m.normal))["scale"] = m.normalScale;
  if (m.occlusion) (out["occlusionTexture"] = useOf(m.occlusion))["strength"] = m.occlusionStrength;
  if (m.emissionMap) out["emissiveTexture"] = useOf(m.emissionMap);
  if (m.emission != glm::vec3(0)) out["emissiveFactor"] = numbersOf(linearOf(glm::vec4(m.emission, 1)));
  if (m.alpha == Alpha::blend) out["alphaMode"] = "BLEND";
  if (m.alpha == Alpha::mask) out["alphaMode"] = "MASK", out["alphaCutoff"] = m.cutoff;
  if (m.doubleSided) out["doubleSided"] = true;
  if (m.unlit) out["extensions"]["KHR_materials_unlit"] = json::object();
  return out;
}

json meshOf(const ExportedMesh& mesh, GlbBuffer& buffer) {
  json attributes = {{"POSITION", buffer.positions(mesh.positions, mesh.lower, mesh.upper)}};
  if (mesh.normals) attributes["NORMAL"] = buffer.vertices(mesh.normals);
  if (mesh.tangents && mesh.normals) attributes["TANGENT"] = buffer.vertices(mesh.tangents);
  if (mesh.colors) attributes["COLOR_0"] = buffer.colors(mesh.colors);
  if (mesh.texcoords[0]) attributes["TEXCOORD_0"] = buffer.vertices(mesh.texcoords[0]);
  if (mesh.texcoords[1]) attributes["TEXCOORD_1"] = buffer.vertices(mesh.texcoords[1]);
  json primitive = {{"attributes", std::move(attributes)}, {"material", mesh.material}};
  if (mesh.mode != MeshMode::triangles) primitive["mode"] = static_cast<int>(mesh.mode);
  if (mesh.indices) primitive["indices"] = buffer.indices(mesh.indices);
  return {{"primitives", json::array({std::move(primitive)})}};
}

json matrixOf(const glm::dmat4& m) {
  json out = json::array();
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) out.push_back(m[c][r]);
  return out;
}

/// Looks along -z, with y up.
glm::dmat4 placed(const glm::dvec3& position, const glm::dvec3& direction, const glm::dvec3& up) {
  const glm::dvec3 back = -glm::normalize(direction), right = glm::normalize(glm::cross(up, back));
  return {glm::dvec4(right, 0), glm::dvec4(glm::cross(back, right), 0), glm::dvec4(back, 0),
          glm::dvec4(position, 1)};
}

class Scenes {
 public:
  Scenes(const ExportedScene& scene, json& gltf) : scene_(scene), gltf_(gltf) {}

  void add(const ExportedView& view) {
    json roots = json::array();
    for (const ExportedNode& node : view.nodes) {
      json out = {{"mesh", node.mesh}};
      if (node.worldFromMesh != glm::dmat4(1)) out["matrix"] = matrixOf(node.worldFromMesh);
      if (node.object) out["name"] = "object " + std::to_string(node.object);
      roots.push_back(addNode(std::move(out)));
    }
    addCamera(view, roots);
    json out = json::object();
    if (!roots.empty()) out["nodes"] = std::move(roots);
    gltf_["scenes"].push_back(std::move(out));
  }

 private:
  size_t addNode(json node) {
    gltf_["nodes"].push_back(std::move(node));
    return gltf_["nodes"].size() - 1;
  }

  void addCamera(const ExportedView& view, json& roots) {
    json seen = json::array();  // lights that follow the viewer
    const WorldBox box(scene_, view);
    for (const ExportedLight& given : view.lights) {
      const ExportedLight light = fileLight(given, box);
      const std::optional<json> described = lightOf(light, box);
      if (!described || (light.followsViewer && !view.camera)) continue;
      json& lights = gltf_["extensions"]["KHR_lights_punctual"]["lights"];
      lights.push_back(*described);
      json node = {{"name", "light"}};
      node["extensions"]["KHR_lights_punctual"]["light"] = lights.size() - 1;
      if (!light.followsViewer) {
        const glm::dvec3 way(light.source.direction),
            aside = std::abs(way.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
        const bool distant = light.source.kind == scene::LightSource::Kind::distant;
        node["matrix"] =
            matrixOf(placed(distant ? glm::dvec3(0) : glm::dvec3(light.source.position), way, aside));
        roots.push_back(addNode(std::move(node)));
      } else {
        seen.push_back(addNode(std::move(node)));
      }
    }
    if (!view.camera) return;
    const frame::CameraDescription& c = *view.camera;
    json camera;
    if (c.perspective)
      camera = {{"type", "perspective"},
                {"perspective",
                 {{"yfov", glm::radians(c.angle)},
                  {"aspectRatio", view.aspect},
                  {"znear", c.near},
                  {"zfar", c.far}}}};
    else
      camera = {{"type", "orthographic"},
                {"orthographic",
                 {{"xmag", 0.5 * view.aspect * c.height},
                  {"ymag", 0.5 * c.height},
                  {"znear", c.near},
                  {"zfar", c.far}}}};
    gltf_["cameras"].push_back(std::move(camera));
    json node = {{"camera", gltf_["cameras"].size() - 1},
                 {"matrix", matrixOf(placed(c.position, c.direction, c.up))},
                 {"name", "camera"}};
    if (!seen.empty()) node["children"] = std::move(seen);
    roots.push_back(addNode(std::move(node)));
  }

  const ExportedScene& scene_;
  json& gltf_;
};

void addTextures(const ExportedScene& scene, GlbBuffer& buffer, json& gltf) {
  for (const ExportedTexture& t : scene.textures) {
    json& samplers = gltf["samplers"];
    const json sampler = samplerOf(t);
    size_t index = 0;
    while (index < samplers.size() && samplers[index] != sampler) ++index;
    if (index == samplers.size()) samplers.push_back(sampler);
    gltf["textures"].push_back({{"sampler", index}, {"source", buffer.image(t, scene.png)}});
  }
}

void addExtensions(json& gltf) {
  json used = json::array();
  if (gltf.contains("extensions")) used.push_back("KHR_lights_punctual");
  for (const json& material : gltf.value("materials", json::array()))
    if (material.contains("extensions")) {
      used.push_back("KHR_materials_unlit");
      break;
    }
  if (!used.empty()) gltf["extensionsUsed"] = std::move(used);
}

json describe(const ExportedScene& scene, GlbBuffer& buffer) {
  json gltf = {{"asset", {{"version", "2.0"}, {"generator", "GLuRay " GLURAY_VERSION}}}, {"scene", 0}};
  for (const ExportedMaterial& material : scene.materials) gltf["materials"].push_back(materialOf(material));
  for (const ExportedMesh& mesh : scene.meshes) gltf["meshes"].push_back(meshOf(mesh, buffer));
  addTextures(scene, buffer, gltf);
  Scenes scenes(scene, gltf);
  for (const ExportedView& view : scene.views) scenes.add(view);
  if (scene.views.empty()) gltf.erase("scene");
  addExtensions(gltf);
  buffer.describe(gltf);
  return gltf;
}

std::string words(std::initializer_list<uint32_t> values) {
  std::string out;
  for (const uint32_t value : values) out.append(reinterpret_cast<const char*>(&value), sizeof value);
  return out;
}

/// Gathers small parts, of which scenes of many meshes have many.
class Gathered {
 public:
  explicit Gathered(files::Draft& draft) : draft_(draft) {}
  bool write(std::string_view part) {
    constexpr size_t kSmall = size_t{1} << 16;
    if (part.size() >= kSmall) return flush() && draft_.write(part);
    waiting_ += part;
    return waiting_.size() < kSmall || flush();
  }
  bool flush() {
    const bool written = waiting_.empty() || draft_.write(waiting_);
    waiting_.clear();
    return written;
  }

 private:
  files::Draft& draft_;
  std::string waiting_;
};

}  // namespace

std::string writeGlb(const ExportedScene& scene, files::Draft& draft) {
  GlbBuffer buffer;
  std::string text = describe(scene, buffer).dump();
  text.append((4 - text.size() % 4) % 4, ' ');
  const uint64_t binary = buffer.bytes(), total = 12 + 8 + text.size() + (binary ? 8 + binary : 0);
  if (total > std::numeric_limits<uint32_t>::max())
    return "the scene takes " + std::to_string(total >> 20) +
           " MiB, and glTF files have at most 4 GiB: show less of it, or write it as PLY";
  const auto length = static_cast<uint32_t>(text.size());
  Gathered out(draft);
  out.write(words({kMagic, kVersion, static_cast<uint32_t>(total), length, kJsonChunk}));
  out.write(text);
  if (binary) out.write(words({static_cast<uint32_t>(binary), kBinaryChunk}));
  buffer.writeTo([&](const char* bytes, size_t size) { return out.write({bytes, size}); });
  out.flush();
  return "";
}

}  // namespace gluray::saved
