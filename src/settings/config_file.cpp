#include "settings/config_file.h"

#include "base/files.h"
#include "settings/keys.h"

#include <toml++/toml.h>

#include <cstdlib>
#include <string>

namespace gluray {
namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

/// A value as the environment would have it; false for tables, arrays, dates and fractions, which no setting
/// takes.
bool asText(const toml::node& node, std::string& text) {
  if (const auto* value = node.as_string()) return text = value->get(), true;
  if (const auto* value = node.as_integer()) return text = std::to_string(value->get()), true;
  if (const auto* value = node.as_boolean()) return text = value->get() ? "true" : "false", true;
  return false;
}

std::string place(const std::string& file, const toml::source_region& where) {
  return file + ":" + std::to_string(where.begin.line) + ": ";
}

void take(const std::string& file, const toml::table& table, Session& session,
          void (*complain)(const std::string&)) {
  for (const auto& [key, node] : table) {
    const std::string name(key.str());
    std::string value;
    if (!isForFiles(name)) {
      complain(place(file, node.source()) + "no setting is called '" + name + "'");
    } else if (!asText(node, value)) {
      complain(place(file, node.source()) + name + ": use a string, a whole number, true or false");
    } else if (const std::string why = setSetting(session, name, value); !why.empty()) {
      complain(place(file, node.source()) + name + " = " + value + ": " + why);
    }
  }
}

}  // namespace

std::string configFile() {
  if (const std::string named = environment("GLURAY_CONFIG"); !named.empty()) return named;
  std::string directory = environment("XDG_CONFIG_HOME");
  if (directory.empty() && !environment("HOME").empty()) directory = environment("HOME") + "/.config";
  return directory.empty() ? "" : directory + "/gluray/gluray.toml";
}

void readConfigFile(const std::string& file, bool wanted, Session& session,
                    void (*complain)(const std::string& line)) {
  if (file.empty()) return;
  constexpr size_t kMost = size_t{16} << 20;
  const files::Content content = files::read(file, kMost);
  if (!content.why.empty()) {
    if (wanted || !content.missing) complain(file + ": " + content.why);
    return;
  }
  try {
    take(file, toml::parse(content.text), session, complain);
  } catch (const toml::parse_error& error) {
    complain(place(file, error.source()) + std::string(error.description()));
  }
}

}  // namespace gluray
