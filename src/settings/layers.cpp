#include "settings/layers.h"

#include "settings/config_file.h"
#include "settings/values.h"

#include <algorithm>
#include <cstdlib>

namespace gluray {
namespace {

class Reader {
 public:
  Reader(const Sources& sources, Complain complain) : sources_(sources), complain_(complain) {}

  Layers read() {
    const File files[] = {file(Layer::system, sources_.systemFile, Absent::ignored, Trust::ownOnly),
                          file(Layer::user, sources_.userFile,
                               sources_.userFileNamed ? Absent::reported : Absent::ignored, Trust::any),
                          file(Layer::project, sources_.projectFile, Absent::ignored, Trust::ownOnly)};
    for (const File& f : files) takeFile(f, f.layer, "");
    for (const std::string& program : sources_.programs)
      for (const File& f : files) takeFile(f, Layer::program, program);
    for (const Row& row : settingRows()) takeVariable(row);
    if (!sources_.passed)
      for (const auto& [name, value] : sources_.commandLine) takeOption(name, value);
    return std::move(layers_);
  }

 private:
  struct File {
    Layer layer;
    std::string path;
    std::vector<FileSetting> settings;
  };

  File file(Layer layer, const std::string& path, Absent absent, Trust trust) {
    return {layer, path, readConfigFile(path, absent, trust, complain_)};
  }

  void takeFile(const File& file, Layer layer, const std::string& program) {
    for (const FileSetting& s : file.settings) {
      if (s.program != program) continue;
      const std::string place = file.path + ":" + std::to_string(s.line);
      if (s.wrong.empty())
        give(*findSetting(s.name), layer, s.value, place, place + ": " + s.name + " = " + s.value);
      else
        complain_(place + ": " + s.wrong);
    }
  }

  void takeVariable(const Row& row) {
    const std::string name = variableOf(row);
    const char* value = std::getenv(name.c_str());
    if (!value || !*value) return;
    const bool option = sources_.passed && isOption(row, value);
    give(row, option ? Layer::commandLine : Layer::environment, value, option ? optionOf(row) : name,
         name + "=" + value);
  }

  bool isOption(const Row& row, const std::string& value) const {
    const auto& all = sources_.commandLine;
    return std::find(all.begin(), all.end(), std::pair(std::string(row.name), value)) != all.end();
  }

  void takeOption(const std::string& name, const std::string& value) {
    const Row* row = findSetting(name);
    if (!row) return complain_(unknownSetting(name));
    give(*row, Layer::commandLine, value, optionOf(*row), optionOf(*row) + " " + value);
  }

  static std::string optionOf(const Row& row) {
    return row.option.empty() ? "--set " + std::string(row.name) : std::string(row.option);
  }

  /// `what` names the value in an error message.
  void give(const Row& row, Layer layer, std::string value, std::string place, const std::string& what) {
    const std::string why = readValue(row, value, layers_.session);
    if (!why.empty()) return complain_(what + ": " + why);
    layers_.given.push_back({&row, layer, std::move(value), std::move(place)});
  }

  const Sources& sources_;
  Complain complain_;
  Layers layers_;
};

}  // namespace

std::string_view nameOf(Layer layer) {
  static constexpr std::string_view kNames[kLayerCount] = {
      "built-in", "system", "user", "project", "program", "environment", "command line", "live"};
  return kNames[static_cast<size_t>(layer)];
}

const Given* Layers::last(const Row& row) const {
  const auto found =
      std::find_if(given.rbegin(), given.rend(), [&](const Given& g) { return g.row == &row; });
  return found == given.rend() ? nullptr : &*found;
}

Layers readLayers(const Sources& sources, Complain complain) { return Reader(sources, complain).read(); }

}  // namespace gluray
