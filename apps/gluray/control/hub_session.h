// The hub, as a command uses it: the one that runs, or one of its own for as long as the command lasts.
#pragma once
#include "command_line.h"
#include "control/client/client.h"
#include "control/hub/server/hub_server.h"
#include "control/running_program.h"

#include <asio/io_context.hpp>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace gluray::launcher {

/// Where the hub is: as the command or the settings say, otherwise on this machine.
control::HubAddress addressOf(const CommandLine& line);

class HubSession {
 public:
  /// Connects; where no hub runs on this machine, is one. Gives programs time to connect to a hub that has
  /// just begun. Throws std::runtime_error with one line.
  explicit HubSession(const CommandLine& line);
  /// A hub of its own ends when no other client is connected, or after 15 s.
  ~HubSession();
  HubSession(const HubSession&) = delete;
  HubSession& operator=(const HubSession&) = delete;

  /// The programs that the hub knows. Throws.
  std::vector<RunningProgram> programs();
  /// Those of them that the command names. Throws where there is none, or a word names none.
  std::vector<RunningProgram> chosen();
  /// The hub's answer. Where the hub ends instead, asks the next one, unless the request may have changed
  /// something. Numbers of programs are those that programs() returned. Throws where there is none, or the
  /// request failed as a whole.
  nlohmann::json ask(const nlohmann::json& request);
  control::Client& client() { return client_; }
  asio::io_context& io() { return io_; }

 private:
  void join();
  void beHub();
  void waitForPrograms();
  double secondsToWait(const std::vector<RunningProgram>& programs) const;
  void joinNext();
  nlohmann::json numbered(nlohmann::json request) const;
  void pause();

  const control::HubAddress address_;
  const std::vector<std::string> wanted_;  // programs that the command names
  bool isHub_ = false;
  std::vector<RunningProgram> known_;   // what programs() returned
  std::map<int64_t, int64_t> numbers_;  // of these at the next hub; empty: it is still the same
  nlohmann::json observed_;             // the last request `observe`
  asio::io_context io_;
  control::HubServer hub_{io_};
  control::Client client_{io_};
};

/// Calls `each` with the result of each of the programs in the answer to a request.
/// A program that the answer leaves out counts as one that did not answer.
void forEachResult(
    const nlohmann::json& answer, const std::vector<RunningProgram>& programs,
    const std::function<void(const RunningProgram& program, const nlohmann::json& result)>& each);

/// Why the program failed: the member `why` of its result; empty: it did not.
std::string whyFailed(const nlohmann::json& result);

}  // namespace gluray::launcher
