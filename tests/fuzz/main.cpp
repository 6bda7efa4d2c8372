// The fuzzer. Forked workers play streams of consecutive seeds. If a stream differs, crashes or hangs,
// the fuzzer shrinks it by playing parts of it in more processes, and prints the seed and remaining calls.
//   gluray_fuzz [--seed N] [--calls N] [--jobs N] [--failures N]   plays at least N calls
//   gluray_fuzz --differences 0 ...  counts differences from the real OpenGL; only crashes and hangs fail
//   gluray_fuzz --alone 1 ...        GLuRay only, over an OpenGL that draws nothing: ten times as fast
//   gluray_fuzz --stream N           plays and shrinks the stream of one seed
#include "tests/fuzz/options.h"
#include "tests/fuzz/session.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace gluray::fuzz {
namespace {

constexpr int kDiffers = 3;
// Seconds of processor time for one stream; where it is known to hang. By the clock ten times as long: other
// work on the machine is no hang.
constexpr unsigned kPatience = 30, kShortPatience = 6;
constexpr uint64_t kStateEvery = 16;

/// A worker's messages, in memory that it shares with its parent.
struct Progress {
  uint64_t seed = 0, calls = 0, failedCall = 0, differing = 0, skipped = 0;
  bool ours = false;  // the stream has reached our OpenGL
  bool differencesFail = true;
  bool alone = false;
  Drawn drawn;
  char what[4096] = {};
};

Progress* sharedProgress() {
  void* p = mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  return p == MAP_FAILED ? nullptr : new (p) Progress;
}

/// Ends this process after so many seconds. 0: never.
void allow(unsigned patience) {
  const itimerval processor{{}, {static_cast<time_t>(patience), 0}};
  setitimer(ITIMER_PROF, &processor, nullptr);
  alarm(10 * patience);
}

/// Plays one stream in this process; ends the process if the results differ.
void playOrEnd(const Stream& stream, uint64_t seed, Progress& progress, unsigned patience = kPatience) {
  progress.seed = seed;
  allow(patience);
  if (progress.alone) {
    progress.ours = true;
    const Drawn drawn = playAlone(stream);
    progress.drawn.traced += drawn.traced, progress.drawn.byPrograms += drawn.byPrograms;
    progress.drawn.rasterised += drawn.rasterised;
    return void(allow(0));
  }
  const Outcome outcome = play(stream, seed % kStateEvery == 0, progress.ours);
  allow(0);
  if (outcome.what.empty()) return;
  if (!progress.differencesFail) return void(++progress.differing);
  std::snprintf(progress.what, sizeof progress.what, "%s", outcome.what.c_str());
  progress.failedCall = outcome.call;
  _exit(kDiffers);
}

template <class Body>
pid_t inChild(bool quiet, Body body) {
  const pid_t child = fork();
  if (child != 0) return child;
  if (quiet) dup2(open("/dev/null", O_WRONLY), STDERR_FILENO);
  body();
  _exit(0);
}

/// 0: no failure; otherwise the kind of failure: a difference, or how the process died.
int statusOf(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 256 + WTERMSIG(status);
}

std::string kindOf(int status) {
  if (status == kDiffers) return "differs";
  if (status == 256 + SIGALRM || status == 256 + SIGPROF) return "hangs";
  if (status > 256) return std::string("dies of ") + strsignal(status - 256);
  return "ends with code " + std::to_string(status);
}

/// The kind of difference, without the values.
std::string differenceOf(const Progress& progress) {
  const std::string_view what = progress.what;
  return std::string(what.substr(0, what.find(':', what.find(':') + 1)));
}

/// Removes calls as long as the failure stays of the same kind (after Zeller's ddmin, 2002).
class Shrinker {
 public:
  Shrinker(Stream stream, uint64_t seed, int kind, const Progress& found)
      : stream_(std::move(stream)),
        seed_(seed),
        kind_(kind),
        alone_(found.alone),
        difference_(differenceOf(found)) {}

  Stream run() {
    if (!fails(stream_)) return stream_;  // not reproducible: returns the whole stream
    for (size_t chunk = std::max<size_t>(1, stream_.calls.size() / 2);; chunk /= 2) {
      for (size_t at = 0; at < stream_.calls.size();) {
        Stream less = stream_;
        const auto first = less.calls.begin() + static_cast<ptrdiff_t>(at);
        less.calls.erase(first, first + static_cast<ptrdiff_t>(std::min(chunk, less.calls.size() - at)));
        if (fails(less))
          stream_ = std::move(less);
        else
          at += chunk;
      }
      if (chunk == 1) return stream_;
    }
  }

 private:
  bool fails(const Stream& stream) {
    Progress* progress = sharedProgress();
    progress->alone = alone_;
    const int status = statusOf(inChild(true, [&] {
      playOrEnd(stream, seed_, *progress,
                kind_ == 256 + SIGALRM || kind_ == 256 + SIGPROF ? kShortPatience : kPatience);
    }));
    const bool same = status == kind_ && progress->ours && differenceOf(*progress) == difference_;
    munmap(progress, sizeof *progress);
    return same;
  }
  Stream stream_;
  uint64_t seed_;
  int kind_;
  bool alone_;
  std::string difference_;
};

void explain(uint64_t seed, int kind, const Progress& progress) {
  std::printf("fuzz: the stream of seed %llu %s%s%s\n", static_cast<unsigned long long>(seed),
              kindOf(kind).c_str(), kind == kDiffers ? ": " : "", kind == kDiffers ? progress.what : "");
  std::fflush(stdout);
  const Stream small = Shrinker(makeStream(seed, progress.alone), seed, kind, progress).run();
  std::printf("fuzz: %zu calls are enough (absurd %u %%, small buffers %d, errors asked %d, tame %d):\n",
              small.calls.size(), small.weird, small.smallBuffers, small.askErrors, small.tame);
  std::fflush(stdout);
  std::fputs(describe(small, progress.alone).c_str(), stdout);
  std::fflush(stdout);
  Progress* last = sharedProgress();
  last->alone = progress.alone;
  statusOf(inChild(false, [&] { playOrEnd(small, seed, *last); }));
  if (last->what[0])
    std::printf("fuzz: call %llu of these: %s\n", static_cast<unsigned long long>(last->failedCall),
                last->what);
  std::printf("fuzz: again with: gluray_fuzz%s --stream %llu\n", progress.alone ? " --alone 1" : "",
              static_cast<unsigned long long>(seed));
  std::fflush(stdout);
}

struct Worker {
  pid_t pid = 0;
  Progress* progress = nullptr;
  uint64_t next = 0;  // seed to begin with
};

void work(uint64_t seed, unsigned step, uint64_t calls, Progress& progress) {
  for (; progress.calls < calls; seed += step) {
    const Stream stream = makeStream(seed, progress.alone);
    playOrEnd(stream, seed, progress);
    progress.calls += stream.calls.size();
  }
}

int playAll(const Options& options) {
  std::vector<Worker> workers(options.jobs);
  const auto start = [&](Worker& w) {
    w.pid = inChild(options.failures > 0,
                    [&] { work(w.next, options.jobs, options.calls / options.jobs, *w.progress); });
  };
  for (unsigned i = 0; i < options.jobs; ++i) {
    workers[i].progress = sharedProgress();
    workers[i].progress->differencesFail = options.differences;
    workers[i].progress->alone = options.alone;
    workers[i].next = options.seed + i;
    start(workers[i]);
  }
  unsigned failures = 0;
  for (size_t running = workers.size(); running > 0;) {
    int status = 0;
    const pid_t ended = waitpid(-1, &status, 0);
    for (Worker& w : workers) {
      if (w.pid != ended) continue;
      const int kind = WIFEXITED(status) ? WEXITSTATUS(status) : 256 + WTERMSIG(status);
      if (kind != 0) {
        w.next = w.progress->seed + options.jobs;
        // A crash of the real OpenGL alone says nothing about GLuRay.
        const bool skip = !w.progress->ours;
        if (skip)
          ++w.progress->skipped;
        else
          explain(w.progress->seed, kind, *w.progress);
        if (skip || ++failures < options.failures) {
          start(w);
          break;
        }
      }
      w.pid = 0, --running;
    }
    if (failures >= options.failures)
      for (Worker& w : workers)
        if (w.pid > 0) kill(w.pid, SIGKILL);
  }
  unsigned long long calls = 0, differing = 0, skipped = 0, traced = 0, byPrograms = 0, rasterised = 0;
  for (const Worker& w : workers) {
    calls += w.progress->calls, differing += w.progress->differing;
    skipped += w.progress->skipped;
    traced += w.progress->drawn.traced, byPrograms += w.progress->drawn.byPrograms;
    rasterised += w.progress->drawn.rasterised;
  }
  std::printf("fuzz: %llu calls, %u failures; %llu streams stopped the plain OpenGL by itself\n", calls,
              failures, skipped);
  if (options.alone)
    std::printf("fuzz: %llu draws traced, %llu of them by programs; %llu rasterised\n", traced, byPrograms,
                rasterised);
  if (!options.differences) std::printf("fuzz: %llu streams differ from the real OpenGL\n", differing);
  return failures ? 1 : 0;
}

int playOne(uint64_t seed, bool alone) {
  Progress* progress = sharedProgress();
  progress->alone = alone;
  const int kind = statusOf(inChild(true, [&] { playOrEnd(makeStream(seed, alone), seed, *progress); }));
  if (kind == 0)
    return std::printf("fuzz: the stream of seed %llu is fine\n", static_cast<unsigned long long>(seed)), 0;
  if (!progress->ours)
    return std::printf("fuzz: the stream of seed %llu stops the plain OpenGL by itself\n",
                       static_cast<unsigned long long>(seed)),
           0;
  explain(seed, kind, *progress);
  return 1;
}

}  // namespace
}  // namespace gluray::fuzz

int main(int argc, char** argv) {
  using namespace gluray::fuzz;
  Options options;
  if (!parse(argc, argv, options)) {
    std::fprintf(
        stderr,
        "usage: gluray_fuzz [--seed N] [--calls N] [--jobs N] [--failures N] [--differences 0] [--alone 1] | "
        "--stream N\n");
    return 2;
  }
  // Compiling a shader for every combination of state would take too long.
  setenv("GALLIUM_DRIVER", "softpipe", 0), setenv("DRAW_USE_LLVM", "0", 0);
  setenv("MESA_NO_ERROR", "0", 1);
  return options.stream ? playOne(options.stream, options.alone) : playAll(options);
}
