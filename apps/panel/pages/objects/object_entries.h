// Entries of the setting material.objects as the panel shows them. Any thread.
#pragma once
#include "settings/object_entries.h"
#include "settings/object_rule.h"
#include "settings/rows.h"

#include <nlohmann/json.hpp>

#include <QStringList>
#include <optional>
#include <string>
#include <vector>

namespace gluray::panel {

/// Of a value of the setting; entries that are no texts are left out.
std::vector<std::string> entriesOf(const nlohmann::json& value);

/// What the words of an entry say of `row`, one of material and material.*; none: nothing, or nothing that
/// the setting accepts.
std::optional<nlohmann::json> valueIn(const std::vector<std::string>& words, const Row& row);

/// The kinds of rays that the words of an entry name; none: they say nothing about rays.
std::optional<QStringList> raysIn(const std::vector<std::string>& words);

/// "roughness=0.1", "glass". Empty: the value is none of the setting.
std::string wordFor(const Row& row, const nlohmann::json& value);

/// "hidden-from=camera+shadow", "hidden-from=none".
std::string wordForRays(const QStringList& rays);

}  // namespace gluray::panel
