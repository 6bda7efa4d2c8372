// The link from this program to the hub: two threads that exist while there is a hub (control/link/apart.h).
// Never destroyed, because programs draw while they exit.
#pragma once
#include "control/connection/connect.h"
#include "control/link/program/controlled_program.h"
#include "settings/live/live_settings.h"
#include "settings/live/settings_history.h"

#include <atomic>
#include <mutex>
#include <string>

namespace gluray::control {

class ProgramLink {
 public:
  static constexpr double kLookSeconds = 0.05;                  // between checks for a hub on this machine
  static constexpr double kMaxBackoff = 2;                      // between attempts at one socket
  static constexpr double kTcpSeconds = 2, kMaxTcpSeconds = 8;  // between attempts at another machine
  static constexpr double kRefusedSeconds = 90;  // longer than hubs block a machine with a wrong key

  ProgramLink(ControlledProgram& program, LiveSettings& live, const SettingsSource& source, HubAddress hub);
  ProgramLink(const ProgramLink&) = delete;
  ProgramLink& operator=(const ProgramLink&) = delete;

  /// Call when a frame begins. Checks for a hub at most every kLookSeconds, and starts the threads if there
  /// is one. Any thread; `now`: nowSeconds().
  void lookForHub(double now) noexcept;
  /// Call in the child of a fork, which has no such threads.
  void forked() noexcept;
  /// Call when the process exits: ends the threads, and waits a short time for them.
  void exiting() noexcept;

 private:
  struct Serving;
  bool hubIsHere(double now);
  void noteAttempt(bool greeted);
  void start() noexcept;
  void run() noexcept;
  void serveHubs() noexcept;
  bool serve();

  ControlledProgram& program_;
  LiveSettings& live_;
  const SettingsSource& source_;
  const HubAddress hub_;
  const std::string socket_;  // path of the hub's socket
  SettingsHistory history_;   // used by one thread after the other
  std::atomic<double> next_{0};
  std::atomic<bool> running_{false}, exiting_{false}, forked_{false};
  std::mutex mutex_;
  Serving* serving_ = nullptr;                     // guarded by mutex_; null: nothing to stop
  ConnectFailure failure_ = ConnectFailure::none;  // result of the last attempt; the thread's
  // Sockets of this machine's hubs, identified by device, inode and time of change; 0: none. A killed hub
  // leaves its socket behind.
  std::atomic<uint64_t> seen_{0};     // found by the last check
  std::atomic<uint64_t> useless_{0};  // no hub answered there
  std::atomic<double> retry_{0};      // time when `useless_` is tried again
  double backoff_ = kLookSeconds;     // delay before that; the thread's
};

}  // namespace gluray::control
