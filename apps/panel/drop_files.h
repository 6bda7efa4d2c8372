// What a file that is dropped on the window is for. Any thread; reads the file.
#pragma once
#include <nlohmann/json.hpp>

#include <QString>

namespace gluray::panel {

/// The settings to which a file belongs, by name, or one line that says why it belongs to none: images of
/// environments, TOML files of materials ([[rule]]) and of lights ([[light]]).
struct DropMeaning {
  nlohmann::json values;
  QString why;
};
DropMeaning meaningOf(const QString& file);

}  // namespace gluray::panel
