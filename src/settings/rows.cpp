#include "settings/rows.h"

#include "settings/nearest.h"
#include "settings/object_rule.h"

#include <algorithm>
#include <cctype>
#include <iterator>

namespace gluray {
namespace {

#include "settings/rows.gen.h"

}  // namespace

std::span<const Row> settingRows() { return kRows; }

std::span<const std::string_view> settingGroups() { return kGroups; }

std::vector<const Row*> rowsOfGroup(std::string_view group) {
  std::vector<const Row*> rows;
  for (const Row& row : kRows)
    if (row.group == group) rows.push_back(&row);
  std::stable_sort(rows.begin(), rows.end(), [](const Row* a, const Row* b) { return a->level < b->level; });
  return rows;
}

std::string_view nameOf(Level level) {
  constexpr std::string_view kNames[] = {"basic", "advanced", "expert"};
  return kNames[static_cast<size_t>(level)];
}

const Row* findSetting(std::string_view name) {
  const auto* found =
      std::find_if(std::begin(kRows), std::end(kRows), [&](const Row& r) { return r.name == name; });
  return found == std::end(kRows) ? nullptr : found;
}

std::string variableOf(const Row& row) {
  std::string name = "GLURAY_";
  for (const char c : row.name)
    name += c == '-' || c == '.' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

char separatorOf(const Row& row) { return row.files ? ':' : ','; }

std::string unknownSetting(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Row& row : kRows)
    if (row.inFiles) names.push_back(row.name);
  const std::string_view near = nearest(name, names);
  std::string text = "no setting is called '" + std::string(name) + "'";
  return near.empty() ? text : text + "; did you mean '" + std::string(near) + "'?";
}

}  // namespace gluray
