// Settings' values as programs send and get them.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include <string>

namespace gluray::launcher {

/// The value of "NAME=VALUE", which problemOfPair() has accepted, for `set`.
nlohmann::json sentValue(const std::string& name, const std::string& text);

/// A value that a program sent, for people: "16", "on", "1,0,0"; "-" if it is empty.
std::string valueText(const std::string& name, const nlohmann::json& value);

/// "live", "user: /home/ann/.config/gluray/gluray.toml:3": where a value that a program sent comes from.
std::string originText(const nlohmann::json& described);

/// "ao = true, ao.samples = 16", of an object with values by name.
std::string valuesText(const nlohmann::json& values);

}  // namespace gluray::launcher
