#include "render/lights/light_file.h"

#include "base/files.h"
#include "base/log.h"
#include "base/never_destroyed.h"
#include "base/toml_text.h"

#include <sys/stat.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>

namespace gluray::render {
namespace {

using scene::LightSource;
using Kind = LightSource::Kind;

constexpr double kRadiansADegree = 0.017453292519943295;

std::string placeOf(const std::string& file, const toml::source_region& at) {
  return file + ":" + std::to_string(at.begin.line) + ": ";
}

/// One table [[light]]; remembers which keys were read.
class Table {
 public:
  Table(const toml::table& table, const std::string& file) : table_(table), file_(file) {}

  [[noreturn]] void fail(const std::string& what, const toml::node* at = nullptr) const {
    throw LightFileError(placeOf(file_, (at ? at : &table_)->source()) + what);
  }
  bool has(const char* key) const { return table_.contains(key); }
  const toml::node* get(const char* key) {
    known_.emplace_back(key);
    return table_.get(key);
  }
  std::string word(const char* key, std::string otherwise, const std::vector<std::string>& allowed) {
    const toml::node* node = get(key);
    if (!node) return otherwise;
    const std::optional<std::string> value = node->value<std::string>();
    std::string words;
    for (const std::string& w : allowed) words += (words.empty() ? "" : ", ") + w;
    if (!value || std::find(allowed.begin(), allowed.end(), *value) == allowed.end())
      fail(std::string(key) + " must be one of " + words, node);
    return *value;
  }
  float number(const char* key, float otherwise, float least, float most) {
    const toml::node* node = get(key);
    return node ? numberIn(*node, key, least, most) : otherwise;
  }
  std::optional<glm::vec3> vector(const char* key, float least, float most) {
    const toml::node* node = get(key);
    if (!node) return {};
    const toml::array* list = node->as_array();
    if (!list || list->size() != 3) fail(std::string(key) + " must be three numbers", node);
    glm::vec3 v;
    for (int c = 0; c < 3; ++c) v[c] = numberIn((*list)[static_cast<size_t>(c)], key, least, most);
    return v;
  }
  bool flag(const char* key) {
    const toml::node* node = get(key);
    if (node && !node->is_boolean()) fail(std::string(key) + " must be true or false", node);
    return node && *node->value<bool>();
  }
  void refuseOthers() const {
    for (const auto& [key, node] : table_)
      if (std::find(known_.begin(), known_.end(), key.str()) == known_.end())
        fail("this kind of light has no " + std::string(key.str()), &node);
  }

 private:
  float numberIn(const toml::node& node, const char* key, float least, float most) const {
    const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
    const float rounded = value ? static_cast<float>(std::clamp(*value, -1e38, 1e38)) : 0;
    if (!value || !(rounded >= least && rounded <= most)) {
      char range[80];
      std::snprintf(range, sizeof range, " must be numbers from %g to %g", double{least}, double{most});
      fail(key + std::string(range), &node);
    }
    return rounded;
  }

  const toml::table& table_;
  const std::string& file_;
  std::vector<std::string> known_;
};

constexpr float kLargest = 1e30f;

glm::vec3 directionOf(Table& table, const LightSource& light) {
  const auto direction = table.vector("direction", -kLargest, kLargest);
  const auto target =
      light.kind == Kind::distant ? std::nullopt : table.vector("target", -kLargest, kLargest);
  if (direction && target) table.fail("either direction or target");
  if (!direction && !target)
    table.fail(light.kind == Kind::distant ? "needs a direction" : "needs a direction or a target");
  const glm::dvec3 v(direction ? *direction : *target - light.position);
  if (glm::length(v) == 0) table.fail("its direction has no length");
  return glm::vec3(glm::normalize(v));
}

void readRectangle(Table& table, LightSource& light) {
  const float width = table.number("width", 1, 1e-30f, kLargest),
              height = table.number("height", 1, 1e-30f, kLargest);
  glm::vec3 up = table.vector("up", -kLargest, kLargest).value_or(glm::vec3(0, 1, 0));
  glm::dvec3 across = glm::cross(glm::dvec3(light.direction), glm::dvec3(up));
  // Lying flat, it has no top.
  if (glm::length(across) <= 1e-6 * glm::length(glm::dvec3(up)))
    across = glm::cross(glm::dvec3(light.direction), glm::dvec3(0, 0, 1));
  if (glm::length(across) == 0) across = {1, 0, 0};
  across = glm::normalize(across);
  light.halfEdge[0] = glm::vec3(across * (width * 0.5));
  light.halfEdge[1] = glm::vec3(glm::cross(across, glm::dvec3(light.direction)) * (height * 0.5));
}

void readSize(Table& table, LightSource& light) {
  switch (light.kind) {
    case Kind::distant: light.angle = table.number("angle", 0, 0, 90); break;
    case Kind::spot:
      light.coneCosine = static_cast<float>(std::cos(table.number("cone", 30, 0, 90) * kRadiansADegree));
      light.coneExponent = table.number("exponent", 0, 0, 128);
      [[fallthrough]];
    case Kind::point:
      light.radius = table.number("radius", 0, 0, kLargest);
      light.attenuation = table.vector("attenuation", 0, kLargest).value_or(glm::vec3(1, 0, 0));
      if (light.attenuation == glm::vec3(0)) table.fail("its attenuation is nothing");
      break;
    case Kind::disc:
    case Kind::sphere: light.radius = table.number("radius", 1, 1e-15f, kLargest); break;
    case Kind::rectangle: readRectangle(table, light); break;
  }
}

FileLight readLight(Table& table) {
  static const std::vector<std::string> kKinds{"distant", "point", "spot", "rectangle", "disc", "sphere"};
  FileLight read;
  LightSource& light = read.light;
  if (!table.has("kind")) table.fail("needs a kind");
  const std::string kind = table.word("kind", "", kKinds);
  light.kind = static_cast<Kind>(std::find(kKinds.begin(), kKinds.end(), kind) - kKinds.begin());
  read.onCamera = table.word("space", "scene", {"scene", "camera"}) == "camera";
  light.color = table.vector("color", 0, 1000).value_or(glm::vec3(1));
  light.strength = table.number("strength", 1, 0, 1e6f);
  if (light.kind != Kind::distant) {
    const auto position = table.vector("position", -kLargest, kLargest);
    if (!position) table.fail("needs a position");
    light.position = *position;
  }
  if (light.kind != Kind::point && light.kind != Kind::sphere) light.direction = directionOf(table, light);
  readSize(table, light);
  light.visible = table.flag("visible");
  table.refuseOthers();
  return read;
}

struct Stamp {
  timespec time{};
  off_t size = -1;
  ino_t inode = 0;
  bool operator==(const Stamp& o) const {
    return time.tv_sec == o.time.tv_sec && time.tv_nsec == o.time.tv_nsec && size == o.size &&
           inode == o.inode;
  }
};

Stamp stampOf(const std::string& file) {
  struct stat s {};
  if (stat(file.c_str(), &s) != 0) return {};
  return {s.st_mtim, s.st_size, s.st_ino};
}

struct Known {
  std::optional<Stamp> stamp;
  std::shared_ptr<const std::vector<FileLight>> lights = std::make_shared<std::vector<FileLight>>();
};

void readInto(const std::string& file, Known& known) {
  constexpr size_t kMax = size_t{1} << 20;
  const files::Content content = files::read(file, kMax);
  try {
    if (!content.why.empty()) throw LightFileError(file + ": " + content.why);
    known.lights = std::make_shared<const std::vector<FileLight>>(parseLights(content.text, file));
  } catch (const LightFileError& error) {
    log::write(log::Level::warning, std::string(error.what()) + "; the lights stay as they were");
  }
}

}  // namespace

std::vector<FileLight> parseLights(std::string_view text, const std::string& file) {
  constexpr size_t kMax = 64;
  toml::table root;
  try {
    root = parseToml(text, file);
  } catch (const toml::parse_error& error) {
    throw LightFileError(placeOf(file, error.source()) + std::string(error.description()));
  }
  std::vector<FileLight> lights;
  for (const auto& [key, node] : root) {
    const toml::array* tables = node.as_array();
    if (key.str() != "light" || !tables)
      throw LightFileError(placeOf(file, node.source()) + "only tables [[light]] may stand here");
    for (const toml::node& entry : *tables) {
      if (!entry.is_table())
        throw LightFileError(placeOf(file, entry.source()) + "a light is a table [[light]]");
      Table table(*entry.as_table(), file);
      lights.push_back(readLight(table));
      if (lights.size() > kMax) table.fail("more than 64 lights");
    }
  }
  return lights;
}

std::shared_ptr<const std::vector<FileLight>> lightsOf(const std::string& file) {
  static std::mutex mutex;
  static NeverDestroyed<std::map<std::string, Known>> files;
  if (file.empty()) return nullptr;
  const std::lock_guard lock(mutex);
  Known& known = (*files)[file];
  const Stamp now = stampOf(file);
  if (known.stamp != now) readInto(file, known);
  known.stamp = now;
  return known.lights;
}

LightSource placed(const FileLight& light, const glm::dmat4& eyeFromWorld) {
  LightSource l = light.light;
  if (light.onCamera) return l;
  const glm::dmat3 linear(eyeFromWorld);
  const auto stretch = static_cast<float>(std::cbrt(std::abs(glm::determinant(linear))));
  l.position = glm::vec3(eyeFromWorld * glm::dvec4(l.position, 1));
  for (glm::vec3& edge : l.halfEdge) edge = glm::vec3(linear * glm::dvec3(edge));
  // An area shines along its normal, which a world of unequal axes turns differently from directions.
  const bool flat = l.kind == Kind::rectangle || l.kind == Kind::disc;
  const glm::dmat3 turned = flat ? glm::transpose(glm::inverse(linear)) : linear;
  l.direction = glm::vec3(glm::normalize(turned * glm::dvec3(l.direction)));
  l.radius *= stretch;
  l.attenuation /= glm::vec3(1, stretch, stretch * stretch);
  return l;
}

}  // namespace gluray::render
