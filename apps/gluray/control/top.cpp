#include "control/top.h"

#include "base/clock.h"
#include "control/hub_session.h"
#include "control/top_rows.h"
#include "say.h"

#include <asio/signal_set.hpp>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <stdexcept>

namespace gluray::launcher {
namespace {

using nlohmann::json;

constexpr double kTableEvery = 1;    // seconds between tables
constexpr double kStateEvery = 0.5;  // seconds between events of state
constexpr double kOncePatience = 3;  // seconds that --once waits for programs

/// The programs of the table, as events tell them.
class Top {
 public:
  Top(const CommandLine& line, const std::vector<RunningProgram>& programs) : line_(line) { keep(programs); }

  void take(const json& event) {
    const json what = event.value("what", json());
    if (what == "programs") return keep(programsOf(event));
    if (what != "state") return;
    for (TopProgram& program : programs_)
      if (event.value("program", json()) == program.program().number)
        program.take(event.value("state", json()), nowSeconds());
  }
  bool isComplete() const {
    return std::all_of(programs_.begin(), programs_.end(), [](const auto& p) { return p.hasRates(); });
  }
  void print() const {
    if (line_.json) {
      std::cout << topJson(programs_).dump(-1, ' ', false, json::error_handler_t::replace) << std::endl;
      return;
    }
    if (!line_.control.once && isatty(STDOUT_FILENO)) std::cout << "\x1b[H\x1b[2J";
    std::cout << (programs_.empty() ? "no program runs under GLuRay\n" : topTable(programs_)) << std::flush;
  }

 private:
  void keep(const std::vector<RunningProgram>& now) {
    std::vector<TopProgram> kept;
    for (const RunningProgram& program : now) {
      if (!isChosen(program, line_.control.programs)) continue;
      const auto known = std::find_if(programs_.begin(), programs_.end(), [&](const TopProgram& p) {
        return p.program().number == program.number;
      });
      kept.push_back(known == programs_.end() ? TopProgram(program) : std::move(*known));
    }
    programs_ = std::move(kept);
  }

  const CommandLine& line_;
  std::vector<TopProgram> programs_;
};

}  // namespace

int showTop(const CommandLine& line) {
  HubSession hub(line);
  bool stopped = false;
  asio::signal_set signals(hub.io(), SIGINT, SIGTERM);
  signals.async_wait([&](const asio::error_code& error, int) {
    if (!error) stopped = true, hub.client().interrupt();
  });
  // Observes before it asks for the programs, so that none is missed.
  hub.ask({{"type", "observe"}, {"program", "all"}, {"what", {"state", "programs"}}, {"every", kStateEvery}});
  const std::vector<RunningProgram> programs = hub.programs();
  chosenPrograms(programs, line.control.programs);  // throws, also where no program runs
  Top top(line, programs);
  double next = nowSeconds() + (line.control.once ? kOncePatience : kTableEvery);
  while (!stopped) {
    const json event = hub.client().awaitEvent(std::max(0.0, next - nowSeconds()));
    if (!event.is_null())
      top.take(event);
    else if (!hub.client().whyClosed().empty())
      throw std::runtime_error(hub.client().whyClosed());
    const bool isDue = nowSeconds() >= next || (line.control.once && top.isComplete());
    if (stopped || !isDue) continue;
    top.print();
    if (line.control.once) break;
    next = nowSeconds() + kTableEvery;
  }
  return 0;
}

}  // namespace gluray::launcher
