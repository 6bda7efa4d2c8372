#include "control/hub.h"

#include "control/auth/key.h"
#include "control/hub/server/hub_server.h"
#include "control/runtime_directory.h"
#include "say.h"
#include "wake/wake.h"

#include <asio/posix/stream_descriptor.hpp>
#include <asio/signal_set.hpp>
#include <unistd.h>

#include <csignal>
#include <exception>
#include <optional>

namespace gluray::launcher {
namespace {

int writeKeyFile(const std::string& file) {
  if (const std::string why = control::writeNewKey(file); !why.empty()) return say(why), 1;
  say("wrote a key to " + file + "; copy it to the other machines, and let nobody else read it");
  return 0;
}

/// Stops the context when standard input reaches its end: the process that holds a pipe's other side has
/// ended, however it ended. What is written to the pipe is thrown away.
class InputEnd {
 public:
  explicit InputEnd(asio::io_context& io) : io_(io), input_(io) {
    asio::error_code error;
    input_.assign(STDIN_FILENO, error);
    if (error)
      io_.stop();  // it is closed
    else
      wait();
  }

 private:
  void wait() {
    // No read of asio's: that would make the input non-blocking for others who use it, too.
    input_.async_wait(asio::posix::stream_descriptor::wait_read, [this](const asio::error_code& error) {
      char bytes[256];
      if (error == asio::error::operation_aborted) return;
      if (error || read(STDIN_FILENO, bytes, sizeof bytes) <= 0) return io_.stop();
      wait();
    });
  }

  asio::io_context& io_;
  asio::posix::stream_descriptor input_;
};

/// Where the hub listens.
std::string placesOf(const control::HubServer& hub, const HubLine& line, const std::string& directory) {
  if (line.listen.empty()) return directory;
  const std::string host = line.listen.substr(0, line.listen.rfind(':'));
  return directory + " and on " + host + ":" + std::to_string(hub.port());
}

}  // namespace

int runHub(const CommandLine& line) {
  if (!line.hub.newKey.empty()) return writeKeyFile(line.hub.newKey);
  asio::io_context io;
  asio::signal_set signals(io, SIGINT, SIGTERM);
  signals.async_wait([&](const asio::error_code& error, int) {
    if (!error) io.stop();
  });
  control::HubServer hub(io);
  control::HubOptions options;
  options.directory = control::runtimeDirectory();
  options.listen = line.hub.listen;
  options.keyFile = line.hub.key;
  options.wake = wakeWindow;
  if (const std::string why = hub.start(options); !why.empty()) return say(why), 1;
  std::optional<InputEnd> inputEnd;
  if (line.hub.withParent) inputEnd.emplace(io);
  say("the hub listens in " + placesOf(hub, line.hub, options.directory));
  while (!io.stopped()) try {
      io.run();
    } catch (const std::exception& error) {  // no memory: what it was about is lost, the hub is not
      say(error.what());
    }
  hub.stop();
  return 0;
}

}  // namespace gluray::launcher
