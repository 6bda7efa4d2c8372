// Values of settings as JSON, and back (docs/control-protocol.md, Requests). Any thread.
#pragma once
#include "settings/layers/settings_layers.h"
#include "settings/rows.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace gluray::control {

/// The value that `text`, as printText() gives it, stands for: a boolean, a number, a string, or an array.
nlohmann::json valueOf(const Row& row, const std::string& text);

/// The text of a value, for readText(), which checks it. Objects and null give an empty `text` and a `why`.
struct TextOrWhy {
  std::string text, why;
};
TextOrWhy textOf(const Row& row, const nlohmann::json& value);

/// What each layer says of a setting, the lowest first: objects with `layer`, `value` (null: nothing),
/// `place`. A layer may say something in several places.
nlohmann::json layersOf(const Layers& layers, const Row& row);

/// What is to be known of a setting: an object with `name`, `type`, `default`, `least`, `most` (null: no
/// limit), `words` (a list of objects with `word`, `help`), `unit`, `help`, `more`, `group`, `applies`,
/// `changesPicture`.
nlohmann::json description(const Row& row);

}  // namespace gluray::control
