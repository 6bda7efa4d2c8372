#include "accel/refiner.h"

#include "accel/arena.h"

#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <vector>

namespace gluray::accel {

/// Refiners whose thread may be running, for the end of the process. Never destroyed.
struct RunningRefiners {
  std::mutex mutex;
  std::vector<Refiner*> refiners;
  bool exiting = false;

  static RunningRefiners& instance() {
    static auto* running = new RunningRefiners;
    return *running;
  }

  /// False while the process exits: nothing may be started any more.
  bool add(Refiner* refiner) {
    const std::lock_guard lock(mutex);
    static const bool registered = std::atexit([] { instance().abandonAll(); }) == 0;
    if (!registered || exiting) return false;
    refiners.push_back(refiner);
    return true;
  }

  void remove(Refiner* refiner) {
    const std::lock_guard lock(mutex);
    std::erase(refiners, refiner);
  }

  void abandonAll() {
    // exit() may have been called by a signal handler in the middle of anything.
    const std::unique_lock lock(mutex, std::try_to_lock);
    if (!lock) return;
    exiting = true;
    for (Refiner* refiner : refiners) refiner->abandonAtExit();
  }
};

namespace {

/// Blocks the host's signals for threads started while it lives: its handlers must not run on threads of
/// ours.
class SignalsBlocked {
 public:
  SignalsBlocked() {
    sigset_t blocked;
    sigfillset(&blocked);
    for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP}) sigdelset(&blocked, fault);
    pthread_sigmask(SIG_SETMASK, &blocked, &saved_);
  }
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &saved_, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t saved_;
};

}  // namespace

Refiner::~Refiner() { stop(); }

bool Refiner::start(BlasPtr blas) noexcept {
  try {
    if (!RunningRefiners::instance().add(this)) return false;
  } catch (...) { return false; }
  blas_ = std::move(blas);
  cancelled_ = false;
  state_ = State::running;
  process_ = getpid();
  try {
    const std::lock_guard lock(threadMutex_);
    const SignalsBlocked signals;
    thread_ = std::thread(&Refiner::build, this);
  } catch (...) {
    RunningRefiners::instance().remove(this);
    blas_.reset();
    return false;
  }
  return true;
}

void Refiner::build() noexcept {
  // On Linux the priority belongs to the thread: frames that are being traced come first.
  constexpr int kLowPriority = 10;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kLowPriority);
  State end = State::failed;
  try {
    Arena alone(1);
    alone.execute([&] { blas_->buildBehind(cancelled_); });
    end = State::built;
  } catch (...) {  // the structure that is there already goes on serving
  }
  state_.store(end, std::memory_order_release);
}

Refiner::Outcome Refiner::poll() noexcept {
  Outcome outcome;
  if (!blas_ || state_.load(std::memory_order_acquire) == State::running) return outcome;
  outcome.ended = true;
  if (state_ == State::built && !cancelled_) outcome.blas = blas_;
  join();
  return outcome;
}

void Refiner::stop() noexcept {
  if (!blas_) return;
  cancel();
  join();
}

void Refiner::join() noexcept {
  if (process_ == getpid()) RunningRefiners::instance().remove(this);
  const std::lock_guard lock(threadMutex_);
  if (thread_.joinable() && process_ == getpid())
    thread_.join();
  else if (thread_.joinable())
    thread_.detach();
  blas_.reset();
}

void Refiner::abandonAtExit() noexcept {
  if (process_ != getpid()) return;
  cancel();
  const std::unique_lock lock(threadMutex_, std::try_to_lock);
  if (!lock || !thread_.joinable()) return;
  timespec latest;
  clock_gettime(CLOCK_REALTIME, &latest);
  ++latest.tv_sec;
  pthread_timedjoin_np(thread_.native_handle(), nullptr, &latest);
  // Joined or not, nobody waits for it any more.
  static std::vector<std::thread>* ended = new std::vector<std::thread>;
  ended->push_back(std::move(thread_));
}

}  // namespace gluray::accel
