// What the panel remembers between runs. GUI thread.
#pragma once
#include <QSettings>

namespace gluray::panel {

/// The file panel.ini beside the user's gluray.toml. Changes are written when the object ends.
class PanelMemory : public QSettings {
 public:
  PanelMemory() : QSettings(QSettings::IniFormat, QSettings::UserScope, "gluray", "panel") {}
};

}  // namespace gluray::panel
