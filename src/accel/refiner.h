// Builds one acceleration structure at a time behind the frames' back. Owned by BlasCache, whose thread makes
// all calls.
#pragma once
#include "accel/blas.h"

#include <sys/types.h>

#include <atomic>
#include <mutex>
#include <thread>

namespace gluray::accel {

/// A thread of low priority for each build; none while there is nothing to build. When the process exits, a
/// build under way is cancelled before the libraries that it uses are taken down.
class Refiner {
 public:
  Refiner() = default;
  /// Cancels, and waits for the end of, what is being built. In a forked child the thread does not exist.
  ~Refiner();
  Refiner(const Refiner&) = delete;
  Refiner& operator=(const Refiner&) = delete;

  /// Whether a build was started that poll() has not reported yet.
  bool busy() const { return blas_ != nullptr; }
  /// Starts building `blas`. Only where not busy. False where no thread can be had.
  bool start(BlasPtr blas) noexcept;
  /// Asks the build to end early. It stays busy until poll() reports it.
  void cancel() noexcept { cancelled_ = true; }
  /// Cancels and waits. The build is then forgotten.
  void stop() noexcept;

  struct Outcome {
    bool ended = false;  // the build started last is over and forgotten
    BlasPtr blas;        // what it made; null where it failed or was cancelled
  };
  /// Reports the end of a build, once.
  Outcome poll() noexcept;

 private:
  friend struct RunningRefiners;
  enum class State { running, built, failed };
  void build() noexcept;
  void join() noexcept;
  /// Cancels and waits for at most a second; then the build is left alone.
  void abandonAtExit() noexcept;

  BlasPtr blas_;
  std::mutex threadMutex_;  // exit() may come from any thread
  std::thread thread_;
  pid_t process_ = 0;  // that the thread belongs to
  std::atomic<bool> cancelled_{false};
  std::atomic<State> state_{State::failed};
};

}  // namespace gluray::accel
