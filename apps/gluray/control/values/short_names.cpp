#include "control/values/short_names.h"

#include "control/values/setting_values.h"
#include "settings/nearest.h"
#include "settings/rows.h"
#include "settings/setting_options.h"

#include <nlohmann/json.hpp>

namespace gluray::launcher {
namespace {

/// The setting that the name means; empty: none.
std::string fullName(const ShortNames& names, const std::string& name) {
  const std::string prefix = std::string(names.group) + ".";
  if (!name.empty() && name == names.self) return std::string(names.group);
  if ((name == names.group && !names.self.empty()) || name.starts_with(prefix))
    return findSetting(name) ? name : "";
  return findSetting(prefix + name) ? prefix + name : "";
}

std::string unknownShortName(const ShortNames& names, const std::string& name) {
  std::vector<std::string_view> known;
  if (!names.self.empty()) known.push_back(names.self);
  const std::string prefix = std::string(names.group) + ".";
  for (const Row& row : settingRows())
    if (row.name.starts_with(prefix)) known.push_back(row.name.substr(prefix.size()));
  const std::string_view near =
      nearest(name.starts_with(prefix) ? std::string_view(name).substr(prefix.size()) : name, known);
  std::string text = "the group " + std::string(names.group) + " has no '" + name.substr(0, 40) + "'";
  if (!near.empty()) return text.append("; did you mean '").append(near).append("'?");
  text += "; it has";
  for (const std::string_view one : known) text.append(one == known.front() ? " " : ", ").append(one);
  return text;
}

}  // namespace

std::string readShortPairs(const ShortNames& names, const std::vector<std::string>& pairs,
                           nlohmann::json& values) {
  for (const std::string& pair : pairs) {
    const size_t sign = pair.find('=');
    if (sign == pair.npos) return pair.substr(0, 40) + ": use NAME=VALUE";
    const std::string name = fullName(names, pair.substr(0, sign));
    if (name.empty()) return unknownShortName(names, pair.substr(0, sign));
    const std::string value = pair.substr(sign + 1);
    if (std::string why = problemOfPair(name + "=" + value); !why.empty()) return why;
    values[name] = sentValue(name, value);
  }
  return "";
}

}  // namespace gluray::launcher
