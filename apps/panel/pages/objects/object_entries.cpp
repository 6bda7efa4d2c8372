#include "pages/objects/object_entries.h"

#include "control/messages/value.h"
#include "settings/values.h"

#include <algorithm>

namespace gluray::panel {
namespace {

using nlohmann::json;

constexpr std::string_view kRaysKey = "hidden-from=";

std::string keyOf(const Row& row) {
  const size_t dot = row.name.find('.');
  return dot == row.name.npos ? "" : std::string(row.name.substr(dot + 1)) + "=";
}

}  // namespace

std::vector<std::string> entriesOf(const json& value) {
  std::vector<std::string> entries;
  if (value.is_array())
    for (const json& entry : value)
      if (entry.is_string()) entries.push_back(entry.get<std::string>());
  return entries;
}

std::optional<json> valueIn(const std::vector<std::string>& words, const Row& row) {
  const std::string key = keyOf(row);
  for (const std::string& word : words) {
    const bool fits = key.empty() ? word.find('=') == word.npos : word.starts_with(key);
    Session session;
    if (fits && readValue(row, word.substr(key.size()), session).empty())
      return control::valueOf(row, printValue(row, session));
  }
  return std::nullopt;
}

std::optional<QStringList> raysIn(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (!word.starts_with(kRaysKey)) continue;
    const QStringList said = QString::fromStdString(word.substr(kRaysKey.size())).split('+');
    QStringList rays;
    for (const std::string_view ray : kRayWords)
      if (const QString name = QString::fromUtf8(ray.data(), static_cast<qsizetype>(ray.size()));
          said.contains("all") || said.contains(name))
        rays << name;
    return rays;
  }
  return std::nullopt;
}

std::string wordFor(const Row& row, const json& value) {
  const std::string text = control::textOf(row, value).text;
  return text.empty() ? "" : keyOf(row) + text;
}

std::string wordForRays(const QStringList& rays) {
  return std::string(kRaysKey) + (rays.isEmpty() ? "none" : rays.join('+').toStdString());
}

}  // namespace gluray::panel
