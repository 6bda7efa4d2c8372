// The settings of a picture, as options of gluray name them. GUI thread.
#pragma once
#include "settings/layers/presets.h"

#include <QStringList>
#include <string>
#include <utility>
#include <vector>

namespace gluray::panel {

/// What `gluray render --preset ... --set ...` would say.
struct LookOptions {
  std::string preset, quality;                              // empty: none
  std::vector<std::pair<std::string, std::string>> values;  // name, value: over those of both

  /// The options' words.
  QStringList words() const;
  /// "name=value" each; a setting has one value. Values that presets have wrong are left out.
  std::vector<std::string> settings(const std::vector<Preset>& presets) const;
};

/// All presets that gluray knows in this directory.
std::vector<Preset> presetsHere();
/// Whether it is one that the setting `quality` takes.
bool isQuality(const Preset& preset);

}  // namespace gluray::panel
