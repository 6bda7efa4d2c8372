// Which settings stand where in the panel. Constant data; any thread.
#pragma once
#include "settings/rows.h"

#include <string>
#include <string_view>
#include <vector>

namespace gluray::panel {

/// Settings of one heading: those whose names begin with the same word.
struct Section {
  std::string word;  // "ao"
  std::vector<const Row*> rows;
};

struct Page {
  std::string title;
  std::vector<Section> sections;
};

/// All settings that a running program takes, in the table's order: Light, Materials, Camera, Quality, Speed,
/// Image; settings that none of these names come last, under their group.
std::vector<Page> pages();

/// Whether the row fits what the user searches for: each word is in its name, help or group.
bool matches(const Row& row, std::string_view search);

}  // namespace gluray::panel
