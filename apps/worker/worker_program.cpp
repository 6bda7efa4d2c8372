#include "worker_program.h"

#include "accel/memory/free_memory.h"
#include "base/environment_variable.h"
#include "base/files.h"
#include "base/processes/usable_cores.h"
#include "cluster/program/worker_link.h"
#include "cluster/worker/worker.h"
#include "control/listening_place.h"
#include "control/runtime_directory.h"
#include "mpi_choice.h"

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

namespace {

using namespace gluray;

std::atomic<bool> stop{false};
static_assert(std::atomic<bool>::is_always_lock_free);

// Launchers may drop what a process says just before it ends its job.
constexpr auto kLastWords = std::chrono::milliseconds(300);

struct Options {
  std::string job, mpi;
  int threads = 0;
  uint64_t memory = 0;  // bytes
  bool quiet = false;
};

int fail(const std::string& why) {
  std::fprintf(stderr, "gluray-worker: %s\n", why.c_str());
  return 1;
}

/// What batch systems say, or the machine's share of each of its ranks.
int threadsFor(const cluster::Ranks& ranks, int wanted) {
  if (wanted > 0) return wanted;
  Surroundings here = surroundingsOfThisProcess();
  here.ranksHere = std::max(ranks.sizeHere(), 1);
  return chosenThreads(0, here).threads;
}

/// What is free for each of the machine's ranks, but for a quarter.
size_t memoryFor(const cluster::Ranks& ranks, uint64_t wanted) {
  if (wanted > 0) return wanted;
  return accel::freeMemory() / static_cast<size_t>(std::max(ranks.sizeHere(), 1)) / 4 * 3;
}

void say(const cluster::Ranks& ranks, const std::string& line) {
  std::fprintf(stderr, "gluray-worker %d: %s\n", ranks.rank(), line.c_str());
}

std::string described(const Options& options, const cluster::Ranks& ranks, int threads) {
  return "job \"" + options.job + "\": " + std::to_string(ranks.size()) +
         (ranks.size() == 1 ? " rank, " : " ranks, ") + std::to_string(threads) +
         (threads == 1 ? " thread" : " threads") + " each, " + ranks.implementation() +
         "; programs join with gluray --workers " + options.job;
}

/// Until a signal ends it. Throws std::exception, with a line for the user.
void serve(const Options& options, cluster::Ranks& ranks) {
  control::ListeningPlace place(cluster::workerPlace(options.job, ranks.rankHere()),
                                "gluray-worker --job " + options.job);
  bool taken = false;
  std::string why = place.lockPlace(control::runtimeDirectory(), taken);
  control::Descriptor listening(why.empty() ? place.listenHere(why) : -1);
  if (!why.empty()) throw std::runtime_error(why);

  const int threads = threadsFor(ranks, options.threads);
  cluster::Worker worker(ranks, threads, memoryFor(ranks, options.memory), std::move(listening),
                         [&](const std::string& line) {
                           if (!options.quiet) say(ranks, line);
                         });
  worker.meet(stop);
  if (ranks.rank() == 0 && !options.quiet && !stop) say(ranks, described(options, ranks, threads));
  worker.run(stop);
}

int work(const Options& options, int argc, char** argv) {
  if (const std::string why = cluster::whyNoJobName(options.job); !why.empty()) return fail(why);
  const std::string mpi = options.mpi == "auto" ? worker::launchersMpi(environmentVariable) : options.mpi;
  std::string why;
  const std::unique_ptr<cluster::Ranks> ranks = worker::startRanks(mpi, &argc, &argv, why);
  if (!ranks) return fail(why);
  try {
    serve(options, *ranks);
    return 0;
  } catch (const std::exception& error) {
    say(*ranks, error.what());
    std::this_thread::sleep_for(kLastWords);
    ranks->endJob();
  }
  return 1;
}

}  // namespace

__attribute__((visibility("default"))) int glurayWorker(const GlurayWorkerOptions* options, int argc,
                                                        char** argv) {
  files::ownStreams();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, [](int) { stop = true; });
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return work({options->job, options->mpi, options->threads, options->memory, options->quiet != 0}, argc,
                argv);
  } catch (const std::exception& error) { return fail(error.what()); }
}
