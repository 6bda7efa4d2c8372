#include "pages/layout.h"

#include <cctype>
#include <sstream>

namespace gluray::panel {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

}  // namespace

std::vector<Page> pages() {
  std::vector<Page> all;
  for (const std::string_view group : settingGroups()) {
    Page page{std::string(group), {}};
    for (const Row* row : rowsOfGroup(group)) {
      if (row->applies != Applies::frame || row->name == "preset") continue;
      if (page.sections.empty() || page.sections.back().level != row->level)
        page.sections.push_back({row->level, {}});
      page.sections.back().rows.push_back(row);
    }
    if (!page.sections.empty()) all.push_back(std::move(page));
  }
  return all;
}

bool matches(const Row& row, std::string_view search) {
  std::string text;
  for (const std::string_view part : {row.title, row.name, row.help, row.group})
    text.append(lower(part)).append(" ");
  std::istringstream words{lower(search)};
  for (std::string word; words >> word;)
    if (text.find(word) == text.npos) return false;
  return true;
}

}  // namespace gluray::panel
