#include "control/link/program_link.h"

#include "base/clock.h"
#include "base/hash.h"
#include "base/log.h"
#include "base/processes/own_thread.h"
#include "control/link/apart.h"
#include "control/link/program_side.h"
#include "control/runtime_directory.h"

#include <asio/error.hpp>
#include <asio/io_context.hpp>
#include <asio/posix/stream_descriptor.hpp>
#include <asio/steady_timer.hpp>
#include <pthread.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <optional>
#include <thread>
#include <utility>

namespace gluray::control {
namespace {

using asio::error_code;
using nlohmann::json;

/// Constructs asio's static objects, which exit() would otherwise destroy before it calls handlers that were
/// registered earlier.
void makeAsiosObjects() {
  asio::error::get_system_category(), asio::error::get_netdb_category();
  asio::error::get_addrinfo_category(), asio::error::get_misc_category();
}

std::atomic<ProgramLink*> g_ends{nullptr};

/// Makes exit() end the link's thread before objects that it uses are destroyed.
void endAtExit(ProgramLink& link) {
  if (g_ends.exchange(&link)) return;
  makeAsiosObjects();
  std::atexit([] { g_ends.load()->exiting(); });
}

/// A missing hub may start later; wrong settings stay wrong until the user corrects them.
void noteNoHub(const std::string& why, ConnectFailure failure) {
  if (failure == ConnectFailure::unreachable) return log::write(log::Level::debug, "no hub: " + why);
  log::once(log::Level::warning, "hub " + why, "the hub cannot be used: " + why);
}

void noteFailure(const std::exception& error) noexcept {
  try {
    log::once(log::Level::warning, "control", std::string("the link to the hub failed: ") + error.what());
  } catch (...) {}  // out of memory
}

/// Distinguishes a socket's file from that of a later hub, which may get the same inode. Never 0.
uint64_t identityOf(const struct stat& status) {
  const uint64_t parts[] = {static_cast<uint64_t>(status.st_dev), static_cast<uint64_t>(status.st_ino),
                            static_cast<uint64_t>(status.st_ctim.tv_sec),
                            static_cast<uint64_t>(status.st_ctim.tv_nsec)};
  return hashBytes(parts, sizeof parts).low | 1;
}

}  // namespace

/// One connection to the hub, from the attempt to its end.
struct ProgramLink::Serving {
  explicit Serving(ProgramLink& of) : link(of) {}

  /// Returns when the connection has ended, or could not be made.
  void run() {
    if (const int descriptor = wakeDescriptor(); descriptor >= 0) wake.assign(descriptor);
    waitForExit();
    connectToHub(io, link.hub_,
                 [this](std::shared_ptr<Connection> made, const std::string& why, ConnectFailure failure) {
                   link.failure_ = failure;
                   if (!made) return wake.close(), noteNoHub(why, failure);
                   connection = std::move(made);
                   serve();
                 });
    io.run();
  }

  void serve() {
    side.emplace(link.program_, link.live_, link.source_, link.history_,
                 ProgramSide::Peer{[this](Connection::Line line) { connection->send(std::move(line)); },
                                   [this](const std::string& why) { connection->finish(why); },
                                   [this] { return connection->waiting(); }});
    connection->start({[this](json&& message) {
                         side->receiveMessage(message, nowSeconds());
                         if (!std::exchange(greeted, side->greeted()) && greeted)
                           link.program_.linkBegan(link.hub_.host.empty());
                         schedule();
                       },
                       [this](const std::string& why) {
                         timer.cancel();
                         wake.close();
                         log::write(log::Level::debug, "the hub has disconnected: " + why);
                       },
                       {}});
    side->begin(nowSeconds());
    schedule();
  }

  /// Ends the connection when the process exits.
  void waitForExit() {
    if (!wake.is_open()) return;
    wake.async_wait(asio::posix::stream_descriptor::wait_read, [this](const error_code& error) {
      if (error) return;
      if (link.exiting_) return io.stop();
      waitForExit();
    });
  }

  void schedule() {
    const double now = nowSeconds(), next = side->nextDue(now);
    if (!connection->open() || !std::isfinite(next)) return void(timer.cancel());
    timer.expires_after(std::chrono::duration_cast<asio::steady_timer::duration>(
        std::chrono::duration<double>(std::clamp(next - now, 0.0, 3600.0))));
    timer.async_wait([this](const error_code& error) {
      if (error || !connection->open()) return;
      side->passed(nowSeconds());
      schedule();
    });
  }

  ProgramLink& link;
  asio::io_context io{1};
  asio::steady_timer timer{io};
  asio::posix::stream_descriptor wake{io};
  const pthread_t thread = pthread_self();
  std::shared_ptr<Connection> connection;
  std::optional<ProgramSide> side;
  bool greeted = false;
};

ProgramLink::ProgramLink(ControlledProgram& program, LiveSettings& live, const SettingsSource& source,
                         HubAddress hub)
    : program_(program),
      live_(live),
      source_(source),
      hub_(std::move(hub)),
      socket_(hub_.host.empty() ? socketIn(hub_.directory) : "") {}

void ProgramLink::lookForHub(double now) noexcept {
  double next = next_.load(std::memory_order_relaxed);
  if (now < next || running_.load(std::memory_order_relaxed)) return;
  if (exiting_ || forked_ || !next_.compare_exchange_strong(next, now + kLookSeconds)) return;
  try {
    if (hub_.host.empty() ? hubIsHere(now) : true) start();
  } catch (const std::exception&) {}  // out of memory: retried at the next check
}

bool ProgramLink::hubIsHere(double now) {
  struct stat status {};
  if (stat(socket_.c_str(), &status) != 0 || !S_ISSOCK(status.st_mode)) return false;
  const uint64_t socket = identityOf(status);
  seen_ = socket;
  if (socket == useless_ && now < retry_) return false;
  const std::string why = whyUnsafe(hub_.directory);
  if (why.empty()) return true;
  log::once(log::Level::warning, "unsafe runtime directory", "the hub is not used: " + why);
  next_ = now + kMaxBackoff;
  return false;
}

void ProgramLink::start() noexcept {
  if (running_.exchange(true)) return;
  endAtExit(*this);
  const auto run = [](void* link) -> void* {
    static_cast<ProgramLink*>(link)->run();
    return nullptr;
  };
  pthread_t thread;
  if (startThread(thread, run, this))
    pthread_detach(thread);
  else
    running_ = false, next_ = nowSeconds() + kMaxBackoff;
}

/// Main function of the thread with the process's descriptors, which runs the tasks of the other one.
void ProgramLink::run() noexcept {
  pthread_setname_np(pthread_self(), "gluray-control");
  bool ran = false;
  try {
    ran = runApart([this] { serveHubs(); });
  } catch (const std::exception& e) { noteFailure(e); }
  next_ = nowSeconds() + (ran ? kLookSeconds : kMaxBackoff);
  running_ = false;
}

/// Runs on the thread with its own descriptors.
void ProgramLink::serveHubs() noexcept {
  const bool tcp = !hub_.host.empty();
  double pause = kTcpSeconds;
  do {
    bool greeted = false;
    try {
      greeted = serve();
    } catch (const std::exception& e) { noteFailure(e); } catch (...) {
    }
    if (!exiting_) program_.linkEnded();
    if (!tcp) {
      noteAttempt(greeted);
      break;
    }
    const bool refused = failure_ == ConnectFailure::key || failure_ == ConnectFailure::refused;
    pause = greeted ? kTcpSeconds : refused ? kRefusedSeconds : pause;
    for (double slept = 0; slept < pause && !exiting_; slept += kLookSeconds)
      std::this_thread::sleep_for(std::chrono::duration<double>(kLookSeconds));
    pause = refused ? kTcpSeconds : std::min(2 * pause, kMaxTcpSeconds);
  } while (!exiting_);
}

/// A socket where no hub answers is tried again at increasing intervals. If another one replaces it, that one
/// is tried at the next check.
void ProgramLink::noteAttempt(bool greeted) {
  const uint64_t socket = greeted ? 0 : seen_.load();
  if (socket != useless_) backoff_ = kLookSeconds;
  backoff_ = std::min(2 * backoff_, kMaxBackoff);
  useless_ = socket;
  retry_ = nowSeconds() + backoff_;
}

/// Serves one connection. Returns whether the hub has sent its hello.
bool ProgramLink::serve() {
  auto serving = std::make_unique<Serving>(*this);
  {
    const std::lock_guard lock(mutex_);
    if (exiting_) return false;
    serving_ = serving.get();
  }
  struct Forget {
    ProgramLink& link;
    ~Forget() {
      const std::lock_guard lock(link.mutex_);
      link.serving_ = nullptr;
    }
  };
  {
    const Forget forget{*this};
    serving->run();
  }
  const bool greeted = serving->greeted;
  if (exiting_) serving.release();  // objects that its destructor uses may be gone
  return greeted;
}

void ProgramLink::forked() noexcept { forked_ = true; }

void ProgramLink::exiting() noexcept {
  if (forked_) return;
  exiting_ = true;
  constexpr int kPatience = 500;  // milliseconds
  for (int i = 0; i < kPatience && running_; ++i) {
    if (const std::unique_lock lock(mutex_, std::try_to_lock); lock && serving_) wakeApart(serving_->thread);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

}  // namespace gluray::control
