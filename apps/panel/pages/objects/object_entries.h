// Entries of the setting material.objects as the panel shows them. Any thread.
#pragma once
#include "settings/object_rule.h"
#include "settings/rows.h"

#include <nlohmann/json.hpp>

#include <QStringList>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace gluray::panel {

/// Of a value of the setting; entries that are no texts are left out.
std::vector<std::string> entriesOf(const nlohmann::json& value);

/// Entries by their objects: what many objects have, and change, takes no longer than there are entries.
class ObjectEntries {
 public:
  explicit ObjectEntries(const std::vector<std::string>& entries);
  /// As wordsOf().
  std::vector<std::string> words(uint32_t object) const;
  /// As withObject().
  void change(uint32_t object, const std::vector<std::string>& words);
  std::vector<std::string> all() const;

 private:
  std::vector<uint32_t> order_;
  std::unordered_map<uint32_t, std::vector<std::string>> entries_;  // 0: those that name no object
};

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
