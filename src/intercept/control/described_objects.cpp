#include "intercept/control/described_objects.h"

#include "frame/questions/listed_lights.h"
#include "render/bsdf/material_rules.h"
#include "scene/box_corner.h"
#include "settings/object_rule.h"
#include "settings/rows.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace gluray::intercept {
namespace {

using nlohmann::json;
using scene::FragmentShading;

constexpr std::array<std::string_view, 9> kShapes = {"triangles", "spheres", "discs", "cylinders", "beads",
                                                     "tubes",     "splats",  "balls", "capsules"};

std::string hexOf(const glm::vec3& color) {
  char code[8];
  const auto byte = [](float c) {
    return static_cast<unsigned>(std::lround(glm::clamp(c, 0.0f, 1.0f) * 255));
  };
  std::snprintf(code, sizeof code, "#%02x%02x%02x", byte(color.r), byte(color.g), byte(color.b));
  return code;
}

bool hasVertexColors(const scene::Instance& instance, const scene::Shading& shading) {
  using Color = FragmentShading::Color;
  const Color color = shading.fragment.color;
  if (scene::isProgram(shading))
    return (color != Color::material && color != Color::map) || shading.fragment.normalColors ||
           shading.fragment.rim.on;
  return instance.mesh->colors && (!shading.lighting || shading.colorMaterial != scene::ColorMaterial{});
}

/// The colour of all of the surface; null if vertices or texels have their own colours.
json colorOf(const scene::Instance& instance, const scene::Shading& shading) {
  const bool mapped = scene::isProgram(shading) && shading.fragment.color == FragmentShading::Color::map;
  if (hasVertexColors(instance, shading) || mapped || !shading.textures.empty()) return {};
  const bool own =
      !scene::isProgram(shading) && (!shading.lighting || shading.colorMaterial != scene::ColorMaterial{});
  return hexOf(glm::vec3(own ? instance.color : instance.materials[0].front.diffuse));
}

/// Corners of the mesh's bounds after the transformation by the matrix.
std::pair<glm::dvec3, glm::dvec3> boundsOf(const scene::Mesh& mesh, const glm::dmat4& to) {
  glm::dvec3 lower(std::numeric_limits<double>::infinity()), upper = -lower;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 moved(to * glm::dvec4(scene::boxCorner(mesh.lower, mesh.upper, corner), 1));
    lower = glm::min(lower, moved), upper = glm::max(upper, moved);
  }
  return {lower, upper};
}

json raysOf(uint8_t bits) {
  json words = json::array();
  for (size_t i = 0; i < std::size(kRayWords); ++i)
    if (bits >> i & 1) words.push_back(kRayWords[i]);
  return words;
}

/// Describes the instances of one batch, including their settings.
class BatchObjects {
 public:
  BatchObjects(size_t view, const ShownView& of, const scene::Snapshot& s)
      : view_(view),
        snapshot_(s),
        viewFromWorld_(of.viewFromWorld(s)),
        models_(render::materialsOf(s, 1)),
        hidden_(render::hiddenByRules(s)) {}

  json describe(size_t i) const {
    const scene::Instance& instance = snapshot_.instances[i];
    const scene::Shading& shading = snapshot_.shadings[instance.shading];
    const auto [lower, upper] =
        boundsOf(*instance.mesh, viewFromWorld_ * glm::dmat4(instance.worldFromObject));
    const Row& material = *findSetting("material");
    return {{"object", instance.object.value},
            {"view", view_ + 1},
            {"shape", kShapes.at(static_cast<size_t>(instance.mesh->shape))},
            {"triangles", instance.mesh->triangleCount},
            {"color", colorOf(instance, shading)},
            {"vertexColors", hasVertexColors(instance, shading)},
            {"lit", scene::isLit(shading)},
            {"translucent", snapshot_.layers != nullptr},
            {"material", material.words[static_cast<size_t>(models_[i].kind)].word},
            {"hidden", raysOf(i < hidden_.size() ? hidden_[i] : uint8_t{0})},
            {"lower", arrayOf(lower)},
            {"upper", arrayOf(upper)}};
  }

 private:
  size_t view_;
  const scene::Snapshot& snapshot_;
  glm::dmat4 viewFromWorld_;
  std::vector<render::MaterialModel> models_;
  accel::HiddenFrom hidden_;
};

std::string_view kindOf(const frame::ListedLight& light) {
  static constexpr std::array<std::string_view, 6> kKinds = {"directional", "point", "spot",
                                                             "rectangle",   "disc",  "sphere"};
  if (light.dome) return "dome";
  return light.followsViewer ? "viewer" : kKinds.at(static_cast<size_t>(light.source.kind));
}

/// Angular or actual size of the light; null if it has none.
json sizeOf(const scene::LightSource& source) {
  using Kind = scene::LightSource::Kind;
  if (source.kind == Kind::rectangle)
    return 2 * std::max(glm::length(source.halfEdge[0]), glm::length(source.halfEdge[1]));
  const float size = source.kind == Kind::distant ? source.angle : 2 * source.radius;
  return size > 0 ? json(size) : json();
}

json describe(const frame::ListedLight& light) {
  using Kind = scene::LightSource::Kind;
  static constexpr std::array<std::string_view, 3> kFrom = {"program", "rig", "file"};
  const scene::LightSource& source = light.source;
  const bool placed = source.kind != Kind::distant && !light.dome;
  const bool directed = source.kind != Kind::point && source.kind != Kind::sphere && !light.dome;
  json described{{"name", light.name},
                 {"from", kFrom.at(static_cast<size_t>(light.from))},
                 {"kind", kindOf(light)},
                 {"direction", directed ? arrayOf(-glm::dvec3(source.direction)) : json()},
                 {"position", placed ? arrayOf(glm::dvec3(source.position)) : json()},
                 {"azimuth", light.angles ? json(light.angles->x) : json()},
                 {"elevation", light.angles ? json(light.angles->y) : json()},
                 {"strength", source.strength},
                 {"size", sizeOf(source)}};
  // Programs use colours above 1 instead of a strength.
  const float largest = std::max({source.color.r, source.color.g, source.color.b, 1.0f});
  described["color"] = hexOf(source.color / largest);
  described["strength"] = source.strength * largest;
  return described;
}

bool showsLit(const scene::Snapshot& s) {
  for (const scene::Instance& instance : s.instances)
    if (scene::isLit(s.shadings[instance.shading]) && !instance.ground) return true;
  return false;
}

}  // namespace

json arrayOf(const glm::dvec3& v) {
  // Residues of rounding become 0.
  const double least = 1e-12 * std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const auto plain = [&](double x) { return std::abs(x) <= least ? 0 : x; };
  return json::array({plain(v.x), plain(v.y), plain(v.z)});
}

std::vector<json> describeObjects(const std::vector<ShownView>& views) {
  std::map<uint32_t, json> found;
  for (size_t v = 0; v < views.size(); ++v)
    for (const gl::ShownBatch* batch : views[v].batches) {
      const BatchObjects objects(v, views[v], *batch->snapshot);
      for (size_t i = 0; i < batch->snapshot->instances.size(); ++i) {
        const scene::Instance& instance = batch->snapshot->instances[i];
        if (instance.object.value == 0 || instance.ground) continue;
        json& kept = found[instance.object.value];
        const bool lit = scene::isLit(batch->snapshot->shadings[instance.shading]);
        if (kept.is_null() || (lit && !kept["lit"].get<bool>())) kept = objects.describe(i);
      }
    }
  std::vector<json> list;
  list.reserve(found.size());
  for (auto& [unused, object] : found) list.push_back(std::move(object));
  return list;
}

json describeLights(const std::vector<ShownView>& views) {
  const scene::Snapshot* largest = nullptr;
  const auto area = [](const scene::Snapshot& s) {
    return int64_t{s.camera.viewport.z} * s.camera.viewport.w;
  };
  for (const ShownView& view : views)
    for (const gl::ShownBatch* batch : view.batches)
      if (showsLit(*batch->snapshot) && (!largest || area(*batch->snapshot) > area(*largest)))
        largest = batch->snapshot.get();
  json lights = json::array();
  if (largest)
    for (const frame::ListedLight& light : frame::listLights(*largest)) lights.push_back(describe(light));
  return lights;
}

json describeCameras(const std::vector<ShownView>& views) {
  json cameras = json::array();
  for (const ShownView& view : views) {
    const scene::Snapshot& s = view.first();
    const frame::CameraDescription camera = frame::describeCamera(s);
    uint64_t triangles = 0;
    for (const gl::ShownBatch* batch : view.batches)
      for (const scene::Instance& instance : batch->snapshot->instances)
        triangles += instance.mesh->triangleCount;
    const glm::ivec4& viewport = s.camera.viewport;
    cameras.push_back({{"view", cameras.size() + 1},
                       {"projection", camera.perspective ? "perspective" : "parallel"},
                       {"angle", camera.perspective ? json(camera.angle) : json()},
                       {"height", camera.perspective ? json() : json(camera.height)},
                       {"position", arrayOf(camera.position)},
                       {"direction", arrayOf(camera.direction)},
                       {"up", arrayOf(camera.up)},
                       {"near", camera.near},
                       {"far", camera.far},
                       {"viewport", {viewport.x, viewport.y, viewport.z, viewport.w}},
                       {"triangles", triangles}});
  }
  return cameras;
}

}  // namespace gluray::intercept
