// Lists that programs answer: objects, lights, cameras; as tables or as JSON.
#pragma once
#include "command_line.h"
#include "control/answer_reader.h"
#include "control/one_program.h"

#include <functional>
#include <string>
#include <vector>

namespace gluray::launcher {

struct ListKind {
  const char* member;  // of JSON
  const char* sides;   // of the table's columns
  std::vector<std::string> heads;
  const char* none;  // what is said of an empty list
  /// The list as the program sends it. Throws.
  std::function<nlohmann::json(HubSession&, const RunningProgram&)> fetch;
  /// A row of the table. Throws where the entry cannot be read.
  std::function<std::vector<std::string>(const AnswerReader&)> cells;
};

/// Prints the lists of the chosen programs. Returns the exit code.
int printLists(const CommandLine& line, const ListKind& kind);

}  // namespace gluray::launcher
