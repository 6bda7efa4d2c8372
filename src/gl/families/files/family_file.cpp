// Parses family files: TOML to Family.
#include "base/toml_text.h"
#include "gl/families/family.h"
#include "gl/families/files/code_sections.h"
#include "gl/families/files/family_reader.h"

#include <algorithm>

namespace gluray::gl {

std::string ofLight(const std::string& pattern, const FamilyLights& lights, int number) {
  const size_t at = pattern.find("{}");
  if (at == std::string::npos) return pattern;
  const auto i = static_cast<size_t>(number);
  const std::string name = lights.names.empty()      ? std::to_string(number)
                           : i < lights.names.size() ? lights.names[i]
                                                     : "";
  return pattern.substr(0, at) + name + pattern.substr(at + 2);
}

namespace {

[[noreturn]] void fail(const toml::node& at, const std::string& file, const std::string& what) {
  throw FamilyError(file + ":" + std::to_string(at.source().begin.line) + ": " + what);
}

/// Reads one [[family]] or [[code]] section into `list`.
void readSection(std::string_view key, const toml::table& table, const std::string& file, FamilyList& list) {
  if (key == "code") return readCode(table, file, list.code);
  auto family = std::make_shared<Family>();
  FamilyReader(table, file, *family).read(list.families);
  list.families.push_back(std::move(family));
}

}  // namespace

FamilyList parseFamilies(std::string_view text, const std::string& file) {
  FamilyList list;
  toml::table root;
  try {
    root = parseToml(text, file);
  } catch (const toml::parse_error& e) {
    throw FamilyError(file + ":" + std::to_string(e.source().begin.line) + ": " +
                      std::string(e.description()));
  }
  for (const auto& [key, node] : root) {
    const toml::array* sections = node.as_array();
    if (!sections || (key != "family" && key != "code"))
      fail(node, file, "only [[family]] and [[code]] sections are expected here");
    for (const toml::node& section : *sections) {
      if (!section.is_table()) fail(section, file, std::string(key) + " must be a section");
      readSection(key, *section.as_table(), file, list);
    }
  }
  return list;
}

}  // namespace gluray::gl
