// The link from this program to the hub: two threads that exist while there is a hub (control/link/apart.h).
// Never destroyed: programs draw while they exit.
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
  static constexpr double kLookSeconds = 0.05;                  // between two looks for a hub of this machine
  static constexpr double kMaxBackoff = 2;                      // between two attempts at one socket
  static constexpr double kTcpSeconds = 2, kMaxTcpSeconds = 8;  // between two attempts to reach another one
  static constexpr double kRefusedSeconds = 90;  // longer than hubs refuse a machine whose key is wrong

  ProgramLink(ControlledProgram& program, LiveSettings& live, const SettingsSource& source, HubAddress hub);
  ProgramLink(const ProgramLink&) = delete;
  ProgramLink& operator=(const ProgramLink&) = delete;

  /// Call when a frame begins. Looks for a hub at most every kLookSeconds, and starts the threads if there is
  /// one. Any thread; `now`: nowSeconds().
  void lookForHub(double now) noexcept;
  /// In the child of a fork, which has no such threads.
  void forked() noexcept;
  /// When the process exits: ends the threads, and waits for them for a short time.
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
  const std::string socket_;  // the hub's path
  SettingsHistory history_;   // the thread's; of one thread after the other
  std::atomic<double> next_{0};
  std::atomic<bool> running_{false}, exiting_{false}, forked_{false};
  std::mutex mutex_;
  Serving* serving_ = nullptr;                     // guarded by mutex_; null: nothing to stop
  ConnectFailure failure_ = ConnectFailure::none;  // the thread's: of the last attempt
  // Sockets of this machine's hubs, by device, inode and time of change; 0: none. A killed hub leaves its
  // socket.
  std::atomic<uint64_t> seen_{0};     // found by the last look
  std::atomic<uint64_t> useless_{0};  // no hub answered there
  std::atomic<double> retry_{0};      // when `useless_` is tried again
  double backoff_ = kLookSeconds;     // the thread's: before that
};

}  // namespace gluray::control
