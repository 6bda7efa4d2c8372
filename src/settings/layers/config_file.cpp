#include "settings/layers/config_file.h"

#include "base/environment_variable.h"
#include "base/files.h"
#include "base/toml_text.h"
#include "settings/rows.h"

#include <toml++/toml.h>

#include <algorithm>
#include <optional>
#include <string_view>

namespace gluray {
namespace {

bool takesArrays(const Row& row) {
  return row.type == Type::list || row.type == Type::color || row.type == Type::vector;
}

/// A value as text in the format of environment variables. Nullopt for tables and dates, which no setting
/// accepts, and for arrays if the setting accepts none.
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
        sections(Section::Kind::program, "program", "[program.glxgears]", node);
      else if (key.str() == "presets")
        sections(Section::Kind::preset, "presets", "[presets.mine]", node);
      else
        entry({}, std::string(key.str()), node);
    }
  }

 private:
  void sections(Section::Kind kind, const std::string& word, const char* example, const toml::node& node) {
    const toml::table* table = node.as_table();
    if (!table ||
        std::any_of(table->begin(), table->end(), [](const auto& e) { return !e.second.is_table(); }))
      return add({}, word, node, "", word + ": use tables such as " + example);
    for (const auto& [key, settings] : *table) {
      const std::string name(key.str());
      if (kind == Section::Kind::preset && (name.empty() || name == kNoPreset))
        add({}, word, settings, "", word + "." + name + ": a preset needs another name");
      else
        for (const auto& [setting, value] : *settings.as_table())
          entry({kind, name}, std::string(setting.str()), value);
    }
  }

  void entry(const Section& section, const std::string& name, const toml::node& node) {
    const Row* row = findSetting(name);
    if (isGroup(name) && node.is_table()) {
      for (const auto& [key, value] : *node.as_table())
        // A switch that heads a group: TOML does not allow ao = true beside ao.samples.
        entry(section, row && key.str() == "enabled" ? name : name + "." + std::string(key.str()), value);
      return;
    }
    const bool preset = section.kind == Section::Kind::preset;
    if (preset && name == "help") return help(section, node);
    if (preset && name == "preset")
      return add(section, name, node, "", "preset: a preset cannot name another");
    if (!row || !row->inFiles) return add(section, name, node, "", unknownSetting(name));
    const std::optional<std::string> text = asText(*row, node);
    add(section, name, node, text.value_or(""), text ? "" : name + ": " + kindsOf(*row));
  }

  /// The help text of a preset, for lists of presets.
  void help(const Section& section, const toml::node& node) {
    const auto* text = node.as_string();
    add(section, "help", node, text ? text->get() : "", text ? "" : "help: use a string");
  }

  void add(const Section& section, const std::string& name, const toml::node& node, std::string value,
           std::string wrong) {
    settings_.push_back({section, name, std::move(value), node.source().begin.line, std::move(wrong)});
  }

  std::vector<FileSetting>& settings_;
};

}  // namespace

std::vector<FileSetting> readConfigFile(const std::string& file, Absent absent, Trust trust,
                                        const Complain& complain) {
  constexpr size_t kMax = size_t{16} << 20;
  std::vector<FileSetting> settings;
  if (file.empty()) return settings;
  const files::Content content = trust == Trust::any ? files::read(file, kMax) : files::readOwn(file, kMax);
  if (!content.why.empty()) {
    if (absent == Absent::reported || !content.missing) complain(file + ": " + content.why);
    return settings;
  }
  try {
    return readConfigText(content.text);
  } catch (const toml::parse_error& error) {
    complain(file + ":" + std::to_string(error.source().begin.line) + ": " +
             std::string(error.description()));
    return settings;
  }
}

std::vector<FileSetting> readConfigText(std::string_view text) {
  std::vector<FileSetting> settings;
  Collector(settings).file(parseToml(text));
  std::stable_sort(settings.begin(), settings.end(),
                   [](const FileSetting& a, const FileSetting& b) { return a.line < b.line; });
  return settings;
}

std::string userConfigFile() {
  if (const std::string named = environmentVariable("GLURAY_CONFIG"); !named.empty()) return named;
  std::string directory = environmentVariable("XDG_CONFIG_HOME");
  if (directory.empty() && !environmentVariable("HOME").empty())
    directory = environmentVariable("HOME") + "/.config";
  return directory.empty() ? "" : directory + "/gluray/gluray.toml";
}

}  // namespace gluray
