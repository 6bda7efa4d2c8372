// Values of settings as JSON, and back (docs/control-protocol.md, Requests). Any thread.
#pragma once
#include "settings/layers/settings_layers.h"
#include "settings/rows.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace gluray::control {

/// The value that `text`, in the form of printText(), represents: a boolean, a number, a string or an array.
nlohmann::json valueOf(const Row& row, const std::string& text);

/// The text of a value, for readText(), which checks it. For objects and null, `text` is empty and `why` says
/// why.
struct TextOrWhy {
  std::string text, why;
};
TextOrWhy textOf(const Row& row, const nlohmann::json& value);

/// The values of a setting in all layers, lowest first: objects with `layer`, `value` (null if unset),
/// `place`. A layer may set it in several places.
nlohmann::json layersOf(const Layers& layers, const Row& row);

/// Description of a setting: an object with `name`, `title`, `type`, `default`, `least`, `most` (null: no
/// limit), `leastMeans`, `words` (a list of objects with `word`, `help`), `unit`, `help`, `more`, `group`,
/// `level` ("basic", "advanced" or "expert"), `values`, `applies`, `changesPicture`.
nlohmann::json description(const Row& row);

}  // namespace gluray::control
