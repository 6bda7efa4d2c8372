#include "base/background_job.h"

#include "base/never_destroyed.h"
#include "base/processes/own_thread.h"

#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <vector>

namespace gluray {
namespace {

constexpr time_t kExitPatience = 2;  // maximum seconds by which exit() is delayed
constexpr useconds_t kParkingMicroseconds = 20'000;

std::atomic<bool> g_abandoned{false};
std::atomic<int> g_parked{0};  // threads in parkAtExit()

}  // namespace

/// Jobs whose thread may be running; abandoned when the process exits. Never destroyed.
struct RunningJobs {
  std::mutex mutex;
  std::vector<BackgroundJob*> jobs;
  bool exiting = false;

  static RunningJobs& instance() {
    static NeverDestroyed<RunningJobs> running;
    return *running;
  }

  /// False while the process exits: no job may start.
  bool add(BackgroundJob* job) {
    const std::lock_guard lock(mutex);
    static const bool registered = std::atexit([] { instance().abandonAll(); }) == 0;
    if (!registered || exiting) return false;
    jobs.push_back(job);
    return true;
  }

  void remove(BackgroundJob* job) {
    const std::lock_guard lock(mutex);
    std::erase(jobs, job);
  }

  void abandonAll() {
    // A signal handler may have called exit() at any point, even with the mutex held.
    const std::unique_lock lock(mutex, std::try_to_lock);
    if (!lock) return;
    exiting = true;
    g_abandoned = true;
    for (BackgroundJob* job : jobs) job->abandonAtExit();
  }
};

void parkAtExit() noexcept {
  if (!g_abandoned) return;
  ++g_parked;
  for (;;) pause();
}

BackgroundJob::~BackgroundJob() { stop(); }

bool BackgroundJob::start(Work work, Priority priority) noexcept {
  try {
    if (!RunningJobs::instance().add(this)) return false;
  } catch (...) { return false; }
  work_ = std::move(work);
  priority_ = priority;
  cancelled_ = false;
  state_ = State::running;
  process_ = getpid();
  const auto run = [](void* job) -> void* {
    static_cast<BackgroundJob*>(job)->run();
    return nullptr;
  };
  {
    const std::lock_guard lock(threadMutex_);
    joinable_ = startThread(thread_, run, this);
    if (joinable_) return true;
  }
  RunningJobs::instance().remove(this);
  work_ = nullptr;
  return false;
}

namespace {

/// Lowers the priority of the calling thread, on Linux: to a quarter of a core that it shares with a tracing
/// thread, and to all of an idle core. With much less, a program that never pauses would hardly ever get the
/// results of background jobs.
void lowerPriority() noexcept {
  constexpr int kNicer = 5, kNicest = 19;
  const auto thread = static_cast<id_t>(gettid());
  setpriority(PRIO_PROCESS, thread, std::min(getpriority(PRIO_PROCESS, thread) + kNicer, kNicest));
}

}  // namespace

void BackgroundJob::run() noexcept {
  if (priority_ == Priority::low) lowerPriority();
  State end = State::failed;
  try {
    work_(cancelled_);
    end = State::done;
  } catch (...) {  // reported as failed
  }
  state_.store(end, std::memory_order_release);
}

BackgroundJob::Outcome BackgroundJob::poll() noexcept {
  if (!work_ || state_.load(std::memory_order_acquire) == State::running) return Outcome::none;
  const Outcome outcome = done() ? Outcome::done : Outcome::failed;
  join();
  return outcome;
}

void BackgroundJob::stop() noexcept {
  if (!work_) return;
  cancel();
  join();
}

void BackgroundJob::join() noexcept {
  if (process_ == getpid()) RunningJobs::instance().remove(this);
  const std::lock_guard lock(threadMutex_);
  if (joinable_ && process_ == getpid()) pthread_join(thread_, nullptr);
  joinable_ = false;  // a forked child does not have the thread
  work_ = nullptr;
}

void BackgroundJob::abandonAtExit() noexcept {
  if (process_ != getpid()) return;
  cancel();
  const std::unique_lock lock(threadMutex_, std::try_to_lock);
  if (!lock || !joinable_) return;
  timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  const time_t latest = now.tv_sec + kExitPatience;
  bool joined = false;
  while (!joined && g_parked == 0 && now.tv_sec <= latest) {
    constexpr long kNap = 1'000'000, kSecond = 1'000'000'000;  // nanoseconds
    now.tv_nsec += kNap;
    if (now.tv_nsec >= kSecond) now.tv_nsec -= kSecond, ++now.tv_sec;
    joined = pthread_timedjoin_np(thread_, nullptr, &now) == 0;
    clock_gettime(CLOCK_REALTIME, &now);
  }
  // Gives the job's other threads time to park, too.
  if (!joined) usleep(kParkingMicroseconds);
  if (!joined) pthread_detach(thread_);
  joinable_ = false;
}

}  // namespace gluray
