#include "render/bsdf/material_rules.h"

#include "base/files.h"
#include "base/log.h"
#include "base/never_destroyed.h"
#include "base/toml_text.h"
#include "render/bsdf/object_rules.h"
#include "scene/secondary_scene.h"

#include <toml++/toml.h>

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <stdexcept>

namespace gluray::render {
namespace {

constexpr std::pair<const char*, SurfaceMaterial> kMaterials[] = {
    {"program", SurfaceMaterial::program},  {"matte", SurfaceMaterial::matte},
    {"plastic", SurfaceMaterial::plastic},  {"metal", SurfaceMaterial::metal},
    {"glass", SurfaceMaterial::glass},      {"thin-glass", SurfaceMaterial::thinGlass},
    {"mirror", SurfaceMaterial::mirror},    {"principled", SurfaceMaterial::principled},
    {"emissive", SurfaceMaterial::emissive}};
constexpr std::pair<const char*, SurfaceMetal> kMetals[] = {
    {"Ag", SurfaceMetal::silver},   {"Al", SurfaceMetal::aluminium}, {"Au", SurfaceMetal::gold},
    {"Cr", SurfaceMetal::chromium}, {"Cu", SurfaceMetal::copper},    {"Fe", SurfaceMetal::iron}};

[[noreturn]] void fail(const toml::node& at, const std::string& why) {
  std::string line = "line ";
  line += std::to_string(at.source().begin.line);
  throw std::runtime_error(line.append(": ").append(why));
}

template <class Choices>
auto chosen(const toml::node& node, const Choices& choices) {
  const auto word = node.value<std::string>();
  for (const auto& [name, value] : choices)
    if (word == name) return value;
  fail(node, std::string("'").append(word.value_or("")).append("' is none of the choices"));
}

float number(const toml::node& node, float least, float most) {
  const auto value = node.value<double>();
  if (!value || !(*value >= double{least} && *value <= double{most}))
    fail(node, "a number from " + std::to_string(least) + " to " + std::to_string(most) + " is needed");
  return static_cast<float>(*value);
}

std::vector<uint32_t> numbers(const toml::node& node) {
  std::vector<uint32_t> result;
  const toml::array* all = node.as_array();
  if (!all) fail(node, "a list of numbers is needed");
  for (const toml::node& one : *all) {
    const auto value = one.value<int64_t>();
    if (!value || *value < 0 || *value > UINT32_MAX) fail(one, "a number that is not negative is needed");
    result.push_back(static_cast<uint32_t>(*value));
  }
  return result;
}

glm::vec3 color(const toml::node& node) {
  const std::string text = node.value<std::string>().value_or("");
  const bool digits = text.size() == 7 && text[0] == '#' &&
                      text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (!digits) fail(node, "a colour like \"#ff8000\" is needed");
  const unsigned long v = std::stoul(text.substr(1), nullptr, 16);
  return glm::vec3(v >> 16 & 255, v >> 8 & 255, v & 255) / 255.0f;
}

constexpr std::pair<const char*, accel::RayKind> kRays[] = {{"camera", accel::RayKind::camera},
                                                            {"shadow", accel::RayKind::shadow},
                                                            {"occlusion", accel::RayKind::occlusion},
                                                            {"reflection", accel::RayKind::reflection}};

uint8_t rays(const toml::node& node) {
  const toml::array* all = node.as_array();
  if (!all) fail(node, "a list of kinds of rays is needed: camera, shadow, occlusion, reflection");
  unsigned bits = 0;
  for (const toml::node& one : *all) bits |= bitOf(chosen(one, kRays));
  return static_cast<uint8_t>(bits);
}

/// Conditions and visibility. False: the key is none of these.
bool readCondition(const std::string& key, const toml::node& node, MaterialRule& rule) {
  if (key == "objects") {
    rule.objects = numbers(node);
  } else if (key == "color") {
    rule.color = color(node);
  } else if (key == "triangles") {
    const std::vector<uint32_t> range = numbers(node);
    if (range.size() != 2) fail(node, "triangles needs the least and the most");
    rule.triangles = glm::uvec2(range[0], range[1]);
  } else if (key == "hidden-from") {
    rule.hiddenFrom = rays(node);
  } else {
    return false;
  }
  return true;
}

void readField(const std::string& key, const toml::node& node, float diagonal, MaterialRule& rule) {
  if (readCondition(key, node, rule)) return;
  MaterialModel& m = rule.model;
  rule.looks = true;
  if (key == "material") {
    m.kind = chosen(node, kMaterials);
  } else if (key == "metal") {
    m.metal = chosen(node, kMetals);
  } else if (key == "roughness") {
    m.roughness = number(node, 0, 1);
  } else if (key == "ior") {
    m.ior = number(node, 1.0001f, 4);
  } else if (key == "metallic") {
    m.metallic = number(node, 0, 1);
  } else if (key == "specular") {
    m.specular = number(node, 0, 1);
  } else if (key == "transmission") {
    m.transmission = number(node, 0, 1);
  } else if (key == "coat") {
    m.coat = number(node, 0, 1);
  } else if (key == "emission") {
    m.emission = number(node, 0, 10000);
  } else if (key == "absorption") {
    m.absorption = number(node, 0, 1000) * diagonal;
  } else {
    fail(node, std::string("rules have no '").append(key).append("'"));
  }
}

/// The text of the last file that could be read.
class LastRules {
 public:
  std::string textOf(const std::string& path) {
    std::error_code ignored;
    const auto time = std::filesystem::last_write_time(path, ignored).time_since_epoch().count();
    const std::string key = path + ' ' + std::to_string(time);
    const std::lock_guard lock(mutex_);
    if (key == key_) return text_;
    key_ = key;
    const files::Content content = files::read(path, size_t{1} << 20);
    try {
      if (!content.why.empty()) throw std::runtime_error(content.why);
      readMaterialRules(content.text, {}, 1);  // whether it can be read
      text_ = content.text;
    } catch (const std::exception& e) {
      log::once(log::Level::warning, "material.file " + key, "material.file: " + path + ": " + e.what());
    }
    return text_;
  }

 private:
  std::mutex mutex_;
  std::string key_, text_;
};

LastRules& lastRules() {
  static NeverDestroyed<LastRules> last;
  return *last;
}

}  // namespace

glm::vec3 ownColor(const scene::Shading& shading, const scene::Instance& instance) {
  const bool program = shading.fragment.model != scene::FragmentShading::Model::off;
  const bool vertices = !program && (!shading.lighting || shading.colorMaterial != scene::ColorMaterial{});
  return glm::vec3(vertices ? instance.color : instance.materials[0].front.diffuse);
}

bool MaterialRule::holdsFor(const scene::Instance& instance, const scene::Shading& shading) const {
  const uint32_t count = instance.mesh->triangleCount;
  if (instance.ground) return false;
  if (!objects.empty() && std::find(objects.begin(), objects.end(), instance.order) == objects.end())
    return false;
  if (triangles && (count < triangles->x || count > triangles->y)) return false;
  const glm::vec3 off = color ? glm::abs(*color - ownColor(shading, instance)) : glm::vec3(0);
  return std::max({off.x, off.y, off.z}) <= 1.01f / 255;
}

accel::HiddenFrom hiddenByRules(const scene::Snapshot& snapshot) {
  const Settings& settings = snapshot.settings;
  std::vector<MaterialRule> rules;
  if (!settings.material.file.empty())
    rules = readMaterialRules(lastRules().textOf(settings.material.file), {}, 1);
  const ObjectRules entries(settings);
  const auto hides = [](const MaterialRule& rule) { return rule.hiddenFrom.value_or(0) != 0; };
  if (std::none_of(rules.begin(), rules.end(), hides) && !entries.hide()) return {};
  accel::HiddenFrom hidden(scene::countAll(snapshot), 0);
  for (size_t i = 0; i < hidden.size(); ++i) {
    const scene::Instance& instance = scene::instanceOf(snapshot, i);
    for (const MaterialRule& rule : rules)
      if (rule.hiddenFrom && rule.holdsFor(instance, scene::shadingOf(snapshot, i)))
        hidden[i] = *rule.hiddenFrom;
    if (const auto own = entries.hiddenFrom(instance)) hidden[i] = *own;
  }
  return hidden;
}

std::vector<MaterialRule> readMaterialRules(const std::string& text, const MaterialModel& otherwise,
                                            float diagonal) {
  toml::table table;
  try {
    table = parseToml(text);
  } catch (const toml::parse_error& e) {
    std::string why = "line ";
    why += std::to_string(e.source().begin.line);
    throw std::runtime_error(why.append(": ").append(e.description()));
  }
  std::vector<MaterialRule> rules;
  for (const auto& [name, node] : table) {
    const toml::array* all = node.as_array();
    if (name.str() != "rule" || !all) fail(node, "a file of materials has tables [[rule]] alone");
    for (const toml::node& one : *all) {
      const toml::table* fields = one.as_table();
      if (!fields) fail(one, "a rule is a table");
      MaterialRule& rule = rules.emplace_back();
      rule.model = otherwise;
      for (const auto& [key, value] : *fields) readField(std::string(key.str()), value, diagonal, rule);
    }
  }
  return rules;
}

std::vector<MaterialModel> materialsOf(const scene::Snapshot& snapshot, float diagonal) {
  const MaterialModel everywhere = MaterialModel::fromSettings(snapshot.settings, diagonal);
  std::vector<MaterialModel> models(scene::countAll(snapshot), everywhere);
  std::vector<MaterialRule> rules;
  if (!snapshot.settings.material.file.empty())
    rules = readMaterialRules(lastRules().textOf(snapshot.settings.material.file), everywhere, diagonal);
  const ObjectRules entries(snapshot.settings);
  for (size_t i = 0; i < models.size(); ++i) {
    const scene::Instance& instance = scene::instanceOf(snapshot, i);
    const scene::Shading& shading = scene::shadingOf(snapshot, i);
    if (!isLit(shading) || instance.ground) models[i] = {};
    for (const MaterialRule& rule : rules)
      if ((rule.looks || !rule.hiddenFrom) && rule.holdsFor(instance, shading)) models[i] = rule.model;
    if (const auto own = entries.modelOf(instance, diagonal)) models[i] = *own;
  }
  return models;
}

}  // namespace gluray::render
