// Background jobs: one at a time on a thread of its own, at low priority unless it is short. One thread makes
// all calls.
#pragma once
#include <pthread.h>
#include <sys/types.h>

#include <atomic>
#include <functional>
#include <mutex>

namespace gluray {

/// Does not return once the process exits. Called from time to time by a job's threads in a library whose
/// work must not be cancelled during exit.
void parkAtExit() noexcept;

/// Starts a thread per job. When the process exits, it cancels a running job before the libraries that the
/// job uses are unloaded.
class BackgroundJob {
 public:
  /// The job's function. It polls `cancelled` and ends early once that is set. An exception means failure.
  using Work = std::function<void(const std::atomic<bool>& cancelled)>;

  BackgroundJob() = default;
  /// Cancels and waits for a running job. In a forked child the thread does not exist.
  ~BackgroundJob();
  BackgroundJob(const BackgroundJob&) = delete;
  BackgroundJob& operator=(const BackgroundJob&) = delete;

  /// Whether a job was started whose end poll() has not reported yet.
  bool busy() const { return static_cast<bool>(work_); }
  /// Whether poll() would report Outcome::done.
  bool done() const { return work_ && !cancelled_ && state_.load(std::memory_order_acquire) == State::done; }
  enum class Priority { low, usual };  // low: a quarter of a core shared with a tracing thread
  /// Starts `work`. Requires !busy(). False if no thread can be started.
  bool start(Work work, Priority priority = Priority::low) noexcept;
  /// Asks the job to end early. It stays busy until poll() reports it.
  void cancel() noexcept { cancelled_ = true; }
  /// Cancels and waits; poll() then reports nothing.
  void stop() noexcept;

  enum class Outcome { none, done, failed };
  /// Reports the end of a job, once: `failed` also if it was cancelled. `none`: no job has ended.
  Outcome poll() noexcept;

 private:
  friend struct RunningJobs;
  enum class State { running, done, failed };
  void run() noexcept;
  void join() noexcept;
  /// Cancels, waits for a short time until the thread has ended or is parked, then detaches it.
  void abandonAtExit() noexcept;

  Work work_;
  Priority priority_ = Priority::low;
  std::mutex threadMutex_;  // guards the thread: any thread may call exit()
  pthread_t thread_{};
  bool joinable_ = false;
  pid_t process_ = 0;  // owner of the thread
  std::atomic<bool> cancelled_{false};
  std::atomic<State> state_{State::failed};
};

}  // namespace gluray
