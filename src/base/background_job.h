// Work behind the frames' back: one job at a time in a thread, of low priority unless it is short.
// One thread makes all calls.
#pragma once
#include <sys/types.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

namespace gluray {

/// For threads that work for a job inside a library which must not be left by cancelling while the process
/// exits: once it does, never returns. Called now and then from there.
void parkAtExit() noexcept;

/// A thread for each job; none while there is nothing to do. When the process exits, a job under way is
/// cancelled before the libraries that it uses are taken down.
class BackgroundJob {
 public:
  /// What is done; it looks at `cancelled` now and then and ends early where that is set. May throw: the job
  /// has then failed.
  using Work = std::function<void(const std::atomic<bool>& cancelled)>;

  BackgroundJob() = default;
  /// Cancels, and waits for the end of, what is being done. In a forked child the thread does not exist.
  ~BackgroundJob();
  BackgroundJob(const BackgroundJob&) = delete;
  BackgroundJob& operator=(const BackgroundJob&) = delete;

  /// Whether a job was started that poll() has not reported yet.
  bool busy() const { return static_cast<bool>(work_); }
  /// Whether poll() would report that one is done.
  bool done() const { return work_ && !cancelled_ && state_.load(std::memory_order_acquire) == State::done; }
  enum class Priority { low, usual };  // low: frames that are traced meanwhile come first
  /// Starts `work`. Only where not busy. False where no thread can be had.
  bool start(Work work, Priority priority = Priority::low) noexcept;
  /// Asks the job to end early. It stays busy until poll() reports it.
  void cancel() noexcept { cancelled_ = true; }
  /// Cancels and waits. The job is then forgotten.
  void stop() noexcept;

  enum class Outcome { none, done, failed };
  /// Reports the end of a job, once: `failed` also where it was cancelled. `none`: nothing has ended.
  Outcome poll() noexcept;

 private:
  friend struct RunningJobs;
  enum class State { running, done, failed };
  void run() noexcept;
  void join() noexcept;
  /// Cancels, and waits for a short time until it has ended or is parked; then it is left alone.
  void abandonAtExit() noexcept;

  Work work_;
  Priority priority_ = Priority::low;
  std::mutex threadMutex_;  // exit() may come from any thread
  std::thread thread_;
  pid_t process_ = 0;  // that the thread belongs to
  std::atomic<bool> cancelled_{false};
  std::atomic<State> state_{State::failed};
};

}  // namespace gluray
