#include "settings/layers/settings_layers.h"

#include "settings/layers/profiles.h"
#include "settings/values.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

namespace gluray {
namespace {

std::string optionOf(const Row& row) {
  return row.option.empty() ? "--set " + std::string(row.name) : std::string(row.option);
}

/// Combines the layers.
class Reader {
 public:
  Reader(const Sources& sources, const ConfigFiles& files, const Complain& complain)
      : sources_(sources), files_(files), complain_(complain) {}

  Layers read() {
    for (const ConfigFile& f : files_) takeFile(f, f.layer, {});
    for (const std::string& program : sources_.programs) takeShippedProfile(program);
    for (const std::string& program : sources_.programs)
      for (const ConfigFile& f : files_) takeFile(f, Layer::program, {Section::Kind::program, program});
    takePreset(valueNamed(*findSetting("preset"), [&](const std::string& name) {
      return name.empty() || whyNoPreset(name, presets()).empty();
    }));
    takePreset(qualityPreset());
    for (const Row& row : settingRows()) takeVariable(row);
    if (!sources_.passed)
      for (const auto& [name, value] : sources_.commandLine) takeOption(name, value);
    for (const auto& [name, value] : sources_.live) takeLive(name, value);
    return std::move(layers_);
  }

 private:
  void takeFile(const ConfigFile& file, Layer layer, const Section& section) {
    for (const FileSetting& s : file.settings) {
      if (!(s.section == section)) continue;
      const std::string place = file.path + ":" + std::to_string(s.line);
      if (s.wrong.empty())
        give(*findSetting(s.name), layer, s.value, place, place + ": " + s.name + " = " + s.value);
      else
        complain_(place + ": " + s.wrong);
    }
  }

  void takeShippedProfile(const std::string& program) {
    for (const FileSetting& s : shippedProfile(program))
      give(*findSetting(s.name), Layer::program, s.value, "shipped",
           program + ", shipped: " + s.name + " = " + s.value);
  }

  /// Adds the values of the preset of that name, if there is one.
  void takePreset(const std::string& name) {
    const Preset* preset = name.empty() ? nullptr : findPreset(name, presets());
    if (!preset) return;
    for (const PresetValue& v : preset->values)
      if (v.wrong.empty())
        give(*findSetting(v.name), Layer::preset, v.value, v.place,
             v.place + ": " + v.name + " = " + v.value);
      else
        complain_(v.wrong);
  }

  /// The name of the preset that the setting `quality` takes; empty: none.
  std::string qualityPreset() {
    const Row& row = *findSetting("quality");
    const std::string word = valueNamed(row, [&](const std::string& value) {
      Session scratch;
      return readValue(row, value, scratch).empty();
    });
    return word.empty() || word == "none" ? "" : "quality-" + word;
  }

  /// The text that the highest layer gives a setting which itself gives others values; empty: none does.
  /// Skips texts that are not valid(), which their layers report.
  template <class Valid>
  std::string valueNamed(const Row& row, const Valid& valid) {
    std::vector<std::string> values;  // highest layer first
    const auto add = [&](const auto& given) {
      for (auto one = given.rbegin(); one != given.rend(); ++one)
        if (one->first == row.name) values.push_back(one->second);
    };
    add(sources_.live);
    if (!sources_.passed) add(sources_.commandLine);
    if (std::string value = variable(variableOf(row)); !value.empty()) values.push_back(std::move(value));
    for (auto one = layers_.given.rbegin(); one != layers_.given.rend(); ++one)
      if (one->row == &row) values.push_back(one->value);
    const auto found = std::find_if(values.begin(), values.end(), valid);
    return found == values.end() ? "" : *found;
  }

  const std::vector<Preset>& presets() {
    if (!presets_) presets_ = presetsOf(files_);
    return *presets_;
  }

  /// The value of a variable; empty if it is not set.
  std::string variable(const std::string& name) const {
    if (!sources_.variables) {
      const char* value = std::getenv(name.c_str());
      return value ? value : "";
    }
    for (const auto& [known, value] : *sources_.variables)
      if (known == name) return value;
    return "";
  }

  void takeVariable(const Row& row) {
    const std::string name = variableOf(row), value = variable(name);
    if (value.empty()) return;
    const bool option = isOption(row, value);
    give(row, option ? Layer::commandLine : Layer::environment, value, option ? optionOf(row) : name,
         name + "=" + value);
  }

  bool isOption(const Row& row, const std::string& value) const {
    const auto& all = sources_.commandLine;
    return sources_.passed &&
           std::find(all.begin(), all.end(), std::pair(std::string(row.name), value)) != all.end();
  }

  void takeOption(const std::string& name, const std::string& value) {
    const Row* row = findSetting(name);
    if (!row) return complain_(unknownSetting(name));
    give(*row, Layer::commandLine, value, optionOf(*row), optionOf(*row) + " " + value);
  }

  void takeLive(const std::string& name, const std::string& value) {
    const Row* row = findSetting(name);
    if (!row) return complain_(unknownSetting(name));
    give(*row, Layer::live, value, "", name + "=" + value);
  }

  /// Adds a value. `what` names it in an error message.
  void give(const Row& row, Layer layer, std::string value, std::string place, const std::string& what) {
    std::string why = row.name == "preset" && !value.empty() ? whyNoPreset(value, presets()) : "";
    if (why.empty()) why = readValue(row, value, layers_.session);
    if (!why.empty()) return complain_(what + ": " + why);
    layers_.given.push_back({&row, layer, std::move(value), std::move(place)});
  }

  const Sources& sources_;
  const ConfigFiles& files_;
  const Complain& complain_;
  std::optional<std::vector<Preset>> presets_;  // read when a preset is named
  Layers layers_;
};

}  // namespace

std::string_view nameOf(Layer layer) {
  static constexpr std::string_view kNames[kLayerCount] = {
      "built-in", "system", "user", "project", "program", "preset", "environment", "command line", "live"};
  return kNames[static_cast<size_t>(layer)];
}

const Given* Layers::last(const Row& row) const {
  const auto found =
      std::find_if(given.rbegin(), given.rend(), [&](const Given& g) { return g.row == &row; });
  return found == given.rend() ? nullptr : &*found;
}

ConfigFiles readConfigFiles(const Sources& sources, const Complain& complain) {
  const Absent user = sources.userFileNamed ? Absent::reported : Absent::ignored;
  return {{{Layer::system, sources.systemFile,
            readConfigFile(sources.systemFile, Absent::ignored, Trust::ownOnly, complain)},
           {Layer::user, sources.userFile, readConfigFile(sources.userFile, user, Trust::any, complain)},
           {Layer::project, sources.projectFile,
            readConfigFile(sources.projectFile, Absent::ignored, Trust::ownOnly, complain)}}};
}

std::vector<Preset> presetsOf(const ConfigFiles& files) {
  std::vector<PresetSource> sources;
  for (const ConfigFile& f : files) sources.push_back({f.path, f.settings});
  return allPresets(sources);
}

Layers layersOf(const Sources& sources, const ConfigFiles& files, const Complain& complain) {
  return Reader(sources, files, complain).read();
}

Layers readLayers(const Sources& sources, const Complain& complain) {
  return layersOf(sources, readConfigFiles(sources, complain), complain);
}

}  // namespace gluray
