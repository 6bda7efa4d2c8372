#include "control/program_lists.h"

#include "say.h"
#include "text_table.h"

#include <iostream>

namespace gluray::launcher {
namespace {

using nlohmann::json;

std::string tableOf(const ListKind& kind, const json& list) {
  TextTable table(kind.sides);
  table.row(kind.heads);
  for (const json& entry : list) table.row(kind.cells(AnswerReader(entry)));
  return list.empty() ? std::string(kind.none) + "\n" : table.text("");
}

}  // namespace

int printLists(const CommandLine& line, const ListKind& kind) {
  HubSession hub(line);
  const std::vector<RunningProgram> programs = hub.chosen();
  json all = json::array();
  bool failed = false;
  for (const RunningProgram& program : programs) {
    json one = named(program);
    try {
      one[kind.member] = kind.fetch(hub, program);
      const std::string table = tableOf(kind, one[kind.member]);  // throws where an entry is wrong
      if (!line.json) std::cout << (programs.size() > 1 ? labelOf(program) + ":\n" : "") << table;
    } catch (const std::runtime_error& error) {
      failed = true;
      one.erase(kind.member);
      one["why"] = error.what();
      say(labelOf(program) + ": " + error.what());
    }
    all.push_back(std::move(one));
  }
  if (line.json) std::cout << jsonText(all) << "\n";
  return failed ? 1 : 0;
}

}  // namespace gluray::launcher
