// Which settings stand where in the panel. Constant data; any thread.
#pragma once
#include "settings/rows.h"

#include <string>
#include <string_view>
#include <vector>

namespace gluray::panel {

/// Settings of one level.
struct Section {
  Level level;
  std::vector<const Row*> rows;
};

/// The settings of a group, basic ones in the first section.
struct Page {
  std::string title;  // the group's name
  std::vector<Section> sections;
};

/// All settings that a running program takes, in the order of settingGroups(). The setting `preset` is left
/// out: the tool bar has it.
std::vector<Page> pages();

/// Whether the row fits what the user searches for: each word is in its title, name, help or group.
bool matches(const Row& row, std::string_view search);

}  // namespace gluray::panel
