#include "settings/quirks_list.h"

#include "programs/doors.h"
#include "say.h"
#include "settings/quirks.h"
#include "text_table.h"

#include <nlohmann/json.hpp>

#include <iostream>

namespace gluray::launcher {

int listQuirks(const CommandLine& line) {
  const QuirkSet quirks = sessionOf(line).settings.quirks;
  nlohmann::json list = nlohmann::json::array();
  for (int i = 0; i < kQuirkCount; ++i) {
    const auto quirk = static_cast<Quirk>(i);
    const QuirkText& text = describe(quirk);
    list.push_back(
        {{"name", text.name}, {"on", quirks.has(quirk)}, {"reason", text.reason}, {"test", text.test}});
    if (line.json) continue;
    std::cout << text.name << ": " << (quirks.has(quirk) ? "on" : "off") << "\n"
              << wrapped(std::string(text.reason), 76, "  ") << "  switch: gluray --quirk " << text.name
              << (quirks.has(quirk) ? "=off" : "=on") << " ...\n  test: " << text.test << "\n";
  }
  if (line.json) std::cout << jsonText(list) << "\n";
  return 0;
}

}  // namespace gluray::launcher
