#include "control/programs_list.h"

#include "base/printable.h"
#include "control/hub_session.h"
#include "say.h"
#include "text_table.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <ctime>
#include <iostream>

namespace gluray::launcher {
namespace {

/// "2026-03-01 14:05:12" in local time.
std::string timeText(double since) {
  if (!(std::fabs(since) < 1e12)) return "-";
  const auto seconds = static_cast<time_t>(since);
  tm parts{};
  char text[64];
  if (!localtime_r(&seconds, &parts) || strftime(text, sizeof text, "%F %T", &parts) == 0) return "-";
  return text;
}

}  // namespace

int listPrograms(const CommandLine& line) {
  HubSession hub(line);
  const std::vector<RunningProgram> programs = hub.programs();
  TextTable table("rlrlrl");
  table.row({"number", "name", "pid", "host", "ranks", "since"});
  nlohmann::json list = nlohmann::json::array();
  for (const RunningProgram& p : programs) {
    table.row({std::to_string(p.number), printable(p.name), std::to_string(p.pid), printable(p.host),
               std::to_string(p.ranks), timeText(p.since)});
    list.push_back({{"program", p.number},
                    {"name", p.name},
                    {"pid", p.pid},
                    {"host", p.host},
                    {"ranks", p.ranks},
                    {"since", p.since}});
  }
  if (line.json) std::cout << jsonText(list) << "\n";
  if (!line.json && !programs.empty()) std::cout << table.text("");
  if (programs.empty()) chosenPrograms(programs, {});  // says what to do
  return 0;
}

}  // namespace gluray::launcher
