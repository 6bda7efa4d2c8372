// PyMOL's shader sources, as installed and as statements in spec/programs, for tests of their families.
#pragma once
#include "base/toml_text.h"
#include "gl/families/built_in_families.gen.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::gl {

inline const std::filesystem::path kPyMolShaders = "/usr/share/pymol/data/shaders";
using Defines = std::set<std::string>;

/// PyMOL's own preprocessor: resolves conditions and includes, and repeats one file for each light.
class PyMolText {
 public:
  PyMolText(const std::string& file, const Defines& defines, int lights, int highlights)
      : defines_(defines), lights_(lights), highlights_(highlights) {
    include(file);
  }
  std::string text;

 private:
  void include(const std::string& name) {
    if (name != "CallComputeColorForLight") return read(name, {}, {});
    for (int i = 0; i < lights_; ++i)
      read("call_compute_color_for_light.fs", std::to_string(i),
           i == 0            ? "_0"
           : i > highlights_ ? " * 0.0"
                             : "");
  }
  void read(const std::string& name, const std::string& light, const std::string& postfix) {
    std::ifstream file(kPyMolShaders / name);
    std::vector<bool> on;
    for (std::string line; std::getline(file, line);) {
      std::istringstream words(line);
      std::string first, second;
      words >> first >> second;
      const bool shown = std::find(on.begin(), on.end(), false) == on.end();
      if (first == "#ifdef" || first == "#ifndef")
        on.push_back(defines_.contains(second) == (first == "#ifdef"));
      else if (first == "#else")
        on.back() = !on.back();
      else if (first == "#endif")
        on.pop_back();
      else if (shown && first == "#include")
        include(second);
      else if (shown)
        text += replaced(replaced(line, "`light`", light), "`postfix`", postfix) + "\n";
    }
  }
  static std::string replaced(std::string line, std::string_view from, const std::string& to) {
    for (size_t at = line.find(from); at != std::string::npos; at = line.find(from, at + to.size()))
      line.replace(at, from.size(), to);
    return line;
  }
  const Defines& defines_;
  int lights_, highlights_;
};

/// A text of the section in spec/programs. `what`: "statements" or "blocks".
inline std::string textOf(std::string_view section, const char* what) {
  for (const auto& [file, text] : kBuiltInFamilyFiles) {
    const toml::table root = parseToml(text, file);
    const toml::array* sections = root["code"].as_array();
    for (size_t i = 0; sections && i < sections->size(); ++i)
      if ((*sections)[i].as_table()->at("name").value_or(std::string_view()) == section)
        return (*sections)[i].as_table()->at(what).value_or(std::string());
  }
  return "";
}

}  // namespace gluray::gl
