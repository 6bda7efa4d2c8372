#include "control/link/apart.h"

#include "base/log.h"
#include "base/processes/own_thread.h"

#include <fcntl.h>
#include <linux/close_range.h>
#include <sched.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <utility>

namespace gluray::control {
namespace {

constexpr int kWake = SIGURG;  // ignored unless it has a handler

/// State that the two threads share.
struct Pair {
  std::mutex mutex;
  std::condition_variable changed;
  const std::function<void()>* work = nullptr;
  const std::function<void()>* task = nullptr;  // null: no task waits
  std::exception_ptr thrown;                    // by the task
  bool ended = false;
};

thread_local Pair* t_pair = nullptr;

/// Gives the calling thread an empty descriptor table. Other threads keep theirs.
bool separateDescriptors() {
#ifdef SYS_close_range
  if (syscall(SYS_close_range, 0u, ~0u, CLOSE_RANGE_UNSHARE) == 0) return true;
#endif
  if (unshare(CLONE_FILES) != 0) return false;  // Linux before 5.9
  constexpr rlim_t kMax = 1 << 16;
  rlimit limit{kMax, kMax};
  getrlimit(RLIMIT_NOFILE, &limit);
  for (rlim_t number = 0; number < std::min(limit.rlim_cur, kMax); ++number) close(static_cast<int>(number));
  return true;
}

/// Occupies the numbers of the standard streams: libraries write to them, so no connection may get them.
void fillStreams() {
  for (int number = STDIN_FILENO; number <= STDERR_FILENO; ++number) open("/dev/null", O_RDWR | O_CLOEXEC);
}

void* runWork(void* argument) {
  Pair& pair = *static_cast<Pair*>(argument);
  pthread_setname_np(pthread_self(), "gluray-control");
  if (separateDescriptors()) {
    fillStreams();
    t_pair = &pair;
    log::writeBy(inProcess);
  } else {
    log::write(log::Level::debug, "the link to the hub has no descriptor table of its own");
  }
  try {
    (*pair.work)();
  } catch (...) {}  // the work reports its failures itself
  const std::lock_guard lock(pair.mutex);
  pair.ended = true;
  pair.changed.notify_all();
  return nullptr;
}

}  // namespace

bool runApart(const std::function<void()>& work) {
  Pair pair;
  pair.work = &work;
  pthread_t thread{};
  if (!startThread(thread, runWork, &pair)) return false;
  {
    std::unique_lock lock(pair.mutex);
    while (!pair.ended) {
      pair.changed.wait(lock, [&] { return pair.ended || pair.task; });
      if (!pair.task) continue;
      const std::function<void()>& task = *pair.task;
      lock.unlock();
      std::exception_ptr thrown;
      try {
        task();
      } catch (...) { thrown = std::current_exception(); }
      lock.lock();
      pair.thrown = thrown;
      pair.task = nullptr;
      pair.changed.notify_all();
    }
  }
  pthread_join(thread, nullptr);
  return true;
}

void inProcess(const std::function<void()>& task) {
  Pair* const pair = t_pair;
  if (!pair) return task();
  std::unique_lock lock(pair->mutex);
  pair->task = &task;
  pair->changed.notify_all();
  pair->changed.wait(lock, [&] { return !pair->task; });
  if (pair->thrown) std::rethrow_exception(std::exchange(pair->thrown, nullptr));
}

void wakeApart(pthread_t thread) noexcept { pthread_kill(thread, kWake); }

int wakeDescriptor() noexcept {
  sigset_t wake;
  sigemptyset(&wake);
  sigaddset(&wake, kWake);
  return signalfd(-1, &wake, SFD_NONBLOCK | SFD_CLOEXEC);
}

}  // namespace gluray::control
