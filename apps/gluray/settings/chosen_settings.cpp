#include "settings/chosen_settings.h"

#include "base/files.h"
#include "settings/values.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace gluray::launcher {
namespace {

bool accumulates(const Row* row) { return row && (row->type == Type::list || row->type == Type::quirks); }

std::string joined(const std::string& first, char separator, const std::string& second) {
  return first.empty() || second.empty() ? first + second : first + separator + second;
}

std::string absolute(const std::string& file) {
  return file.empty() || files::isStream(file) ? file : std::filesystem::absolute(file).string();
}

}  // namespace

void ChosenSettings::add(std::string_view name, const std::string& value) {
  const Row* row = findSetting(name);
  set(name, accumulates(row) ? joined(find(name), separatorOf(*row), value) : value);
}

void ChosenSettings::set(std::string_view name, const std::string& value) {
  for (auto& [known, old] : values_)
    if (known == name) return void(old = value);
  values_.emplace_back(name, value);
}

void ChosenSettings::remove(std::string_view name) {
  std::erase_if(values_, [&](const auto& entry) { return entry.first == name; });
}

std::string ChosenSettings::find(std::string_view name) const {
  const auto found =
      std::find_if(values_.begin(), values_.end(), [&](const auto& entry) { return entry.first == name; });
  return found == values_.end() ? "" : found->second;
}

std::string absoluteFiles(const Row& row, const std::string& value) {
  if (row.type != Type::list) return absolute(value);
  Session session;
  readValue(row, value, session);
  std::string text;
  for (const std::string& file : *std::get<std::vector<std::string>*>(row.place(session)))
    text = joined(text, separatorOf(row), absolute(file));
  return text;
}

NamedValues passedValues(const ChosenSettings& chosen) {
  NamedValues values = chosen.all();
  for (auto& [name, value] : values) {
    const Row& row = *findSetting(name);
    if (row.files) value = absoluteFiles(row, value);
    const char* set = std::getenv(variableOf(row).c_str());
    const std::string inherited = set ? set : "";
    if (row.type == Type::quirks) value = joined(inherited, separatorOf(row), value);  // later ones win
    if (row.type == Type::list) value = joined(value, separatorOf(row), inherited);    // earlier ones win
  }
  return values;
}

}  // namespace gluray::launcher
