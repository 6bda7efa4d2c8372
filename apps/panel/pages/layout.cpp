#include "pages/layout.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace gluray::panel {
namespace {

struct Place {
  std::string_view word, page;
};

// By the first word of a name.
constexpr Place kPlaces[] = {
    {"ao", "Light"},
    {"shadows", "Light"},
    {"lights", "Light"},
    {"integrator", "Light"},
    {"path", "Light"},
    {"environment", "Light"},
    {"material", "Materials"},
    {"lines", "Materials"},
    {"points", "Materials"},
    {"transparency", "Materials"},
    {"camera", "Camera"},
    {"spp", "Quality"},
    {"pixel-filter", "Quality"},
    {"noise", "Quality"},
    {"refine", "Quality"},
    {"denoise", "Quality"},
    {"shading", "Quality"},
    {"fps", "Speed"},
    {"engine", "Speed"},
    {"bvh", "Speed"},
    {"threads", "Speed"},
    {"quirks", "Speed"},
    {"renderer", "Speed"},
    {"program-families", "Speed"},
    {"exposure", "Image"},
    {"tone", "Image"},
    {"look", "Image"},
    {"ground", "Image"},
    {"background", "Image"},
};
constexpr std::string_view kPages[] = {"Light", "Materials", "Camera", "Quality", "Speed", "Image"};

std::string_view wordOf(const Row& row) { return row.name.substr(0, row.name.find('.')); }

std::string_view pageOf(const Row& row) {
  for (const Place& place : kPlaces)
    if (place.word == wordOf(row)) return place.page;
  return row.group;
}

Page& pageCalled(std::string_view title, std::vector<Page>& all) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Page& page) { return page.title == title; });
  return found == all.end() ? all.emplace_back(Page{std::string(title), {}}) : *found;
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

}  // namespace

std::vector<Page> pages() {
  std::vector<Page> all;
  for (const std::string_view title : kPages) all.push_back({std::string(title), {}});
  for (const Row& row : settingRows()) {
    if (row.applies != Applies::frame || row.name == "preset") continue;
    std::vector<Section>& sections = pageCalled(pageOf(row), all).sections;
    const auto section = std::find_if(sections.begin(), sections.end(),
                                      [&](const Section& s) { return s.word == wordOf(row); });
    if (section == sections.end())
      sections.push_back({std::string(wordOf(row)), {&row}});
    else
      section->rows.push_back(&row);
  }
  std::erase_if(all, [](const Page& page) { return page.sections.empty(); });
  return all;
}

bool matches(const Row& row, std::string_view search) {
  const std::string text =
      lower(std::string(row.name) + " " + std::string(row.help) + " " + std::string(row.group));
  std::istringstream words{lower(search)};
  for (std::string word; words >> word;)
    if (text.find(word) == text.npos) return false;
  return true;
}

}  // namespace gluray::panel
