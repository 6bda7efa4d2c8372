#include "control/watch.h"

#include "base/printable.h"
#include "control/hub_session.h"
#include "control/state_text.h"
#include "control/values/setting_values.h"
#include "say.h"
#include "settings/rows.h"

#include <asio/signal_set.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <iostream>
#include <stdexcept>

namespace gluray::launcher {
namespace {

using nlohmann::json;
using std::chrono::steady_clock;

constexpr double kNever = 1e9;       // seconds
constexpr double kStateSeconds = 1;  // between events of state

/// Prints events, as lines of text or of JSON.
class EventPrinter {
 public:
  EventPrinter(const CommandLine& line, std::vector<RunningProgram> programs)
      : line_(line), known_(std::move(programs)) {}

  void print(const json& event) {
    const auto what = event.find("what");
    if (what == event.end() || !what->is_string()) return;
    if (*what == "programs") return takePrograms(programsOf(event));
    const RunningProgram* program = find(event.value("program", json()));
    if (!program || !isChosen(*program, line_.control.programs)) return;
    if (*what == "settings") printSettings(*program, event);
    if (*what == "state" && line_.control.state) printState(*program, event);
  }

 private:
  const RunningProgram* find(const json& number) const {
    for (const RunningProgram& program : known_)
      if (number == program.number) return &program;
    return nullptr;
  }

  void out(const RunningProgram& program, const char* what, const std::string& text, json members) {
    if (line_.json) {
      members["what"] = what, members["program"] = program.number;
      members["name"] = program.name, members["pid"] = program.pid;
      std::cout << members.dump(-1, ' ', false, json::error_handler_t::replace) << std::endl;
    } else {
      std::cout << labelOf(program) << ": " << text << std::endl;
    }
  }

  void takePrograms(std::vector<RunningProgram> now) {
    const auto among = [](const std::vector<RunningProgram>& list, const RunningProgram& program) {
      return std::any_of(list.begin(), list.end(), [&](const auto& p) { return p.number == program.number; });
    };
    for (const RunningProgram& old : known_)
      if (!among(now, old) && isChosen(old, line_.control.programs))
        out(old, "ended", "ended", json::object());
    for (const RunningProgram& fresh : now)
      if (!among(known_, fresh) && isChosen(fresh, line_.control.programs))
        out(fresh, "started", "started", json::object());
    known_ = std::move(now);
  }

  void printSettings(const RunningProgram& program, const json& event) {
    const auto values = event.find("values");
    if (values == event.end() || !values->is_object()) return;
    json wanted = json::object();
    for (const auto& [name, described] : values->items())
      if (described.is_object() &&
          (line_.names.empty() || std::count(line_.names.begin(), line_.names.end(), name)))
        wanted[name] = described;
    if (line_.json) {
      if (!wanted.empty()) out(program, "settings", "", {{"values", wanted}});
      return;
    }
    for (const auto& [name, described] : wanted.items())
      out(program, "settings",
          printable(name) + " = " + valueText(name, described.value("value", json())) + "  (" +
              originText(described) + ")",
          {});
  }

  void printState(const RunningProgram& program, const json& event) {
    const json state = event.value("state", json::object());
    out(program, "state", stateText(state), {{"state", state}});
  }

  const CommandLine& line_;
  std::vector<RunningProgram> known_;
};

}  // namespace

int watchPrograms(const CommandLine& line) {
  for (const std::string& name : line.names)
    if (!findSetting(name)) return say(unknownSetting(name)), kUsageError;
  HubSession hub(line);
  bool stopped = false;
  asio::signal_set signals(hub.io(), SIGINT, SIGTERM);
  signals.async_wait([&](const asio::error_code& error, int) {
    if (!error) stopped = true, hub.client().interrupt();
  });
  json what = {"settings", "programs"};
  if (line.control.state) what.push_back("state");
  // Observes before it asks for the programs, so that none is missed.
  hub.ask({{"type", "observe"}, {"program", "all"}, {"what", what}, {"every", kStateSeconds}});
  std::vector<RunningProgram> programs = hub.programs();
  if (!line.control.programs.empty()) chosenPrograms(programs, line.control.programs);  // throws
  EventPrinter printer(line, std::move(programs));
  const double seconds = line.control.seconds > 0 ? line.control.seconds : kNever;
  const auto begin = steady_clock::now();
  while (!stopped) {
    const double rest = seconds - std::chrono::duration<double>(steady_clock::now() - begin).count();
    if (rest <= 0) break;
    const json event = hub.client().awaitEvent(rest);
    if (!event.is_null())
      printer.print(event);
    else if (!hub.client().whyClosed().empty())
      throw std::runtime_error(hub.client().whyClosed());
  }
  return 0;
}

}  // namespace gluray::launcher
