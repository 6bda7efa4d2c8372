#include "pictures/wanted_settings.h"

#include "base/printable.h"
#include "say.h"
#include "settings/settings_list.h"
#include "shell_word.h"

#include <stdexcept>

namespace gluray::launcher {
namespace {

void takePreset(const std::string& name, const std::vector<Preset>& all, ChosenSettings& into) {
  const Preset* const preset = findPreset(name, all);
  if (!preset) throw std::runtime_error(printable(name) + ": " + whyNoPreset(name, all));
  for (const PresetValue& value : preset->values) {
    if (!value.wrong.empty()) throw std::runtime_error(value.wrong);
    into.set(value.name, value.value);
  }
}

}  // namespace

NamedValues wantedSettings(const CommandLine& line) {
  const std::string preset = line.settings.find("preset"), quality = line.settings.find("quality");
  ChosenSettings wanted;
  if (!preset.empty() || !quality.empty()) {
    const Complain complain = [](const std::string& complaint) { say(complaint); };
    const std::vector<Preset> all = presetsOf(readConfigFiles(sourcesOf(line), complain));
    if (!preset.empty() && preset != "none") takePreset(preset, all, wanted);
    if (!quality.empty() && quality != "none") takePreset("quality-" + quality, all, wanted);
  }
  for (const auto& [name, value] : line.settings.all())
    if (name != "preset" && name != "quality") wanted.set(name, value);
  return wanted.all();
}

std::string commandOf(const PictureOptions& options, const NamedValues& settings) {
  std::string command = options.scene.empty() ? "gluray shot" : "gluray render " + shellWord(options.scene);
  command += ' ' + shellWord(options.file);
  if (!options.size.empty()) command += " --size " + shellWord(options.size);
  if (options.fit != "all") command += " --fit " + options.fit;
  if (options.background != "as-shown") command += " --background " + options.background;
  if (!options.layers.empty()) command += " --layers " + shellWord(options.layers);
  if (options.depth != 0) command += " --depth " + std::to_string(options.depth);
  if (options.turntable > 0) command += " --turntable " + std::to_string(options.turntable);
  for (const std::string& file : options.path) command += " --path " + shellWord(file);
  if (options.frames > 0) command += " --frames " + std::to_string(options.frames);
  if (!options.savedCamera.empty()) command += " --saved-camera " + shellWord(options.savedCamera);
  if (!options.overlays) command += " --no-overlays";
  for (const auto& [name, value] : settings) command += " --set " + shellWord(name + "=" + value);
  return command;
}

}  // namespace gluray::launcher
