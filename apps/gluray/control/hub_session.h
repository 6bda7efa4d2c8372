// The hub, as a command uses it: the one that runs, or one of its own for as long as the command lasts.
#pragma once
#include "command_line.h"
#include "control/client/client.h"
#include "control/hub/hub_server.h"
#include "control/running_program.h"

#include <asio/io_context.hpp>

#include <functional>
#include <string>
#include <vector>

namespace gluray::launcher {

/// Where the hub is: as the command or the settings say, otherwise on this machine.
control::HubAddress addressOf(const CommandLine& line);

class HubSession {
 public:
  /// Connects; where no hub runs on this machine, is one, and gives programs a second to connect. Throws
  /// std::runtime_error with one line.
  explicit HubSession(const CommandLine& line);

  /// The programs that the hub knows. Throws.
  std::vector<RunningProgram> programs();
  /// The hub's answer. Throws where there is none, or the request failed as a whole.
  nlohmann::json ask(const nlohmann::json& request);
  control::Client& client() { return client_; }
  asio::io_context& io() { return io_; }

 private:
  void beHub(const std::string& directory);

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
