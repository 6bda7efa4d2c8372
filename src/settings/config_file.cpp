#include "settings/config_file.h"

#include "base/files.h"
#include "base/toml_text.h"
#include "settings/rows.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string_view>

namespace gluray {
namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

bool takesArrays(const Row& row) {
  return row.type == Type::list || row.type == Type::color || row.type == Type::vector;
}

/// A value as text in the format of environment variables; nothing for tables and dates, which no setting
/// takes, and for arrays if the setting takes none.
std::optional<std::string> asText(const Row& row, const toml::node& node) {
  if (const auto* value = node.as_string()) return value->get();
  if (const auto* value = node.as_integer()) return std::to_string(value->get());
  if (const auto* value = node.as_boolean()) return value->get() ? "true" : "false";
  if (const auto* value = node.as_floating_point()) {
    char digits[32];
    return std::string(digits, std::to_chars(digits, digits + sizeof digits, value->get()).ptr);
  }
  if (!node.is_array() || !takesArrays(row)) return std::nullopt;
  std::string text;
  for (const toml::node& entry : *node.as_array()) {
    const std::optional<std::string> one = entry.is_array() ? std::nullopt : asText(row, entry);
    if (!one || one->find(separatorOf(row)) != one->npos) return std::nullopt;
    text.append(text.empty() ? "" : std::string(1, separatorOf(row))).append(*one);
  }
  return text;
}

const char* kindsOf(const Row& row) {
  return takesArrays(row) ? "use a string or an array" : "use a string, a whole number, true or false";
}

bool isGroup(const std::string& name) {
  const auto rows = settingRows();
  return std::any_of(rows.begin(), rows.end(), [&](const Row& r) { return r.name.starts_with(name + "."); });
}

class Collector {
 public:
  explicit Collector(std::vector<FileSetting>& settings) : settings_(settings) {}

  void file(const toml::table& all) {
    for (const auto& [key, node] : all) {
      if (key.str() == "program")
        profiles(node);
      else
        entry("", std::string(key.str()), node);
    }
  }

 private:
  void profiles(const toml::node& node) {
    const toml::table* table = node.as_table();
    if (!table ||
        std::any_of(table->begin(), table->end(), [](const auto& e) { return !e.second.is_table(); }))
      return add("", "program", node, "", "program: use tables such as [program.glxgears]");
    for (const auto& [program, settings] : *table)
      for (const auto& [key, value] : *settings.as_table())
        entry(std::string(program.str()), std::string(key.str()), value);
  }

  void entry(const std::string& program, const std::string& name, const toml::node& node) {
    const Row* row = findSetting(name);
    if (isGroup(name) && node.is_table()) {
      for (const auto& [key, value] : *node.as_table())
        // A switch that heads a group: TOML has no room for ao = true beside ao.samples.
        entry(program, row && key.str() == "enabled" ? name : name + "." + std::string(key.str()), value);
      return;
    }
    if (!row || !row->inFiles) return add(program, name, node, "", unknownSetting(name));
    const std::optional<std::string> text = asText(*row, node);
    add(program, name, node, text.value_or(""), text ? "" : name + ": " + kindsOf(*row));
  }

  void add(const std::string& program, const std::string& name, const toml::node& node, std::string value,
           std::string wrong) {
    settings_.push_back({program, name, std::move(value), node.source().begin.line, std::move(wrong)});
  }

  std::vector<FileSetting>& settings_;
};

}  // namespace

std::vector<FileSetting> readConfigFile(const std::string& file, Absent absent, Trust trust,
                                        Complain complain) {
  constexpr size_t kMost = size_t{16} << 20;
  std::vector<FileSetting> settings;
  if (file.empty()) return settings;
  const files::Content content = trust == Trust::any ? files::read(file, kMost) : files::readOwn(file, kMost);
  if (!content.why.empty()) {
    if (absent == Absent::reported || !content.missing) complain(file + ": " + content.why);
    return settings;
  }
  try {
    Collector(settings).file(parseToml(content.text));
  } catch (const toml::parse_error& error) {
    settings.clear();
    complain(file + ":" + std::to_string(error.source().begin.line) + ": " +
             std::string(error.description()));
  }
  std::stable_sort(settings.begin(), settings.end(),
                   [](const FileSetting& a, const FileSetting& b) { return a.line < b.line; });
  return settings;
}

std::string userConfigFile() {
  if (const std::string named = environment("GLURAY_CONFIG"); !named.empty()) return named;
  std::string directory = environment("XDG_CONFIG_HOME");
  if (directory.empty() && !environment("HOME").empty()) directory = environment("HOME") + "/.config";
  return directory.empty() ? "" : directory + "/gluray/gluray.toml";
}

}  // namespace gluray
