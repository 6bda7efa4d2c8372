#include "settings/settings_source.h"

namespace gluray {

SettingsSource& settingsSource() {
  static auto* const source = new SettingsSource;  // never destroyed: programs call OpenGL while they exit
  return *source;
}

}  // namespace gluray
