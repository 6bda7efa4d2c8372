#include "control/running_program.h"

#include "base/printable.h"
#include "control/messages/members.h"
#include "settings/nearest.h"

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace gluray::launcher {
namespace {

using control::numberIn, control::textIn;
using nlohmann::json;

std::string nameOfHost() {
  char name[256] = {};
  return gethostname(name, sizeof name - 1) == 0 ? name : "";
}

bool isNumber(const std::string& word) {
  return !word.empty() && word.find_first_not_of("0123456789") == word.npos;
}

/// Whether the word names the program; `all` decide whether a number is one of `gluray list`.
bool names(const std::string& word, const RunningProgram& program, const std::vector<RunningProgram>& all) {
  if (word == "all") return true;
  if (!isNumber(word)) return program.name == word;
  const auto numbered = [&](const RunningProgram& p) { return std::to_string(p.number) == word; };
  const bool number = std::any_of(all.begin(), all.end(), numbered);
  return number ? numbered(program) : std::to_string(program.pid) == word;
}

std::string whyNone(const std::string& word, const std::vector<RunningProgram>& all) {
  if (isNumber(word)) return "no program has the number or process id " + word + "; gluray list shows them";
  std::vector<std::string_view> known;
  for (const RunningProgram& program : all) known.push_back(program.name);
  const std::string_view near = nearest(word, known);
  return "no running program is called '" + word + "'" +
         (near.empty() ? "; gluray list shows them" : "; did you mean '" + std::string(near) + "'?");
}

}  // namespace

std::vector<RunningProgram> programsOf(const json& message) {
  std::vector<RunningProgram> programs;
  const auto list = message.find("programs");
  if (list == message.end() || !list->is_array()) return programs;
  for (const json& entry : *list) {
    if (!entry.is_object()) continue;
    RunningProgram program;
    program.number = numberIn<int64_t>(entry, "program", 0);
    program.pid = numberIn<int64_t>(entry, "pid", 0);
    program.ranks = numberIn<int64_t>(entry, "ranks", 1);
    program.since = numberIn<double>(entry, "since", 0);
    program.name = textIn(entry, "name"), program.host = textIn(entry, "host");
    if (program.number > 0) programs.push_back(std::move(program));
  }
  return programs;
}

bool runsElsewhere(const RunningProgram& program) {
  return !program.host.empty() && program.host != nameOfHost();
}

std::string labelOf(const RunningProgram& program) {
  return printable(program.name) + " (" + std::to_string(program.pid) +
         (runsElsewhere(program) ? " on " + printable(program.host) : "") + ")";
}

bool areThere(const std::vector<RunningProgram>& all, const std::vector<std::string>& words) {
  return !all.empty() && std::all_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::any_of(all.begin(), all.end(),
                       [&](const auto& program) { return names(word, program, all); });
  });
}

std::vector<RunningProgram> chosenPrograms(const std::vector<RunningProgram>& all,
                                           const std::vector<std::string>& words) {
  if (all.empty()) throw std::runtime_error("no program runs under GLuRay; start one with: gluray PROGRAM");
  for (const std::string& word : words)
    if (std::none_of(all.begin(), all.end(), [&](const auto& program) { return names(word, program, all); }))
      throw std::runtime_error(whyNone(word, all));
  std::vector<RunningProgram> chosen;
  for (const RunningProgram& program : all)
    if (words.empty() || std::any_of(words.begin(), words.end(),
                                     [&](const std::string& word) { return names(word, program, all); }))
      chosen.push_back(program);
  return chosen;
}

bool isChosen(const RunningProgram& program, const std::vector<std::string>& words) {
  return words.empty() || std::any_of(words.begin(), words.end(), [&](const std::string& word) {
           return names(word, program, {program});
         });
}

json numbersOf(const std::vector<RunningProgram>& programs) {
  json numbers = json::array();
  for (const RunningProgram& program : programs) numbers.push_back(program.number);
  return numbers;
}

}  // namespace gluray::launcher
