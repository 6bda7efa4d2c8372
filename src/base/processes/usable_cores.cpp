#include "base/processes/usable_cores.h"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string_view>

namespace gluray {
namespace {

constexpr int kMaxThreads = 1024;

/// A whole number from 1 on at the front of `text`, which a comma may follow; 0: none.
int countIn(const std::string& text) {
  int count = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, count);
  const bool isWhole = error == std::errc() && (end == last || *end == ',');
  return isWhole && count > 0 ? std::min(count, kMaxThreads) : 0;
}

std::string firstLineOf(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

/// CPUs of "QUOTA PERIOD" in microseconds; 0: no limit.
double coresIn(const std::string& line) {
  std::istringstream in(line);
  double quota = 0, period = 0;
  if (!(in >> quota >> period) || quota <= 0 || period <= 0) return 0;  // "max 100000", "-1 100000"
  return quota / period;
}

/// The least limit of the cgroup `path` below `folder` and of those around it; 0: none.
template <class Read>
double leastOf(const std::string& folder, std::string path, const Read& read) {
  double least = 0;
  while (!path.empty() && path.back() == '/') path.pop_back();
  for (;;) {
    const double cores = read(folder + path);
    if (cores > 0 && (least <= 0 || cores < least)) least = cores;
    if (path.empty()) return least;
    const size_t slash = path.rfind('/');
    path.resize(slash == path.npos ? 0 : slash);
  }
}

double coresOfVersion2(const std::string& folder) { return coresIn(firstLineOf(folder + "/cpu.max")); }

double coresOfVersion1(const std::string& folder) {
  return coresIn(firstLineOf(folder + "/cpu.cfs_quota_us") + " " +
                 firstLineOf(folder + "/cpu.cfs_period_us"));
}

bool namesCpu(std::string_view controllers) {
  while (!controllers.empty()) {
    const std::string_view one = controllers.substr(0, controllers.find(','));
    if (one == "cpu") return true;
    controllers.remove_prefix(std::min(one.size() + 1, controllers.size()));
  }
  return false;
}

std::string variableOfThisProcess(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

int ranksHere() {
  for (const char* name : {"OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS", "MV2_COMM_WORLD_LOCAL_SIZE"})
    if (const int ranks = countIn(variableOfThisProcess(name))) return ranks;
  return 1;
}

std::string coresText(double cores) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", cores);
  return std::string(text) + (cores == 1 ? " core" : " cores");
}

}  // namespace

Surroundings surroundingsOfThisProcess() {
  Surroundings here;
  here.variable = variableOfThisProcess;
  here.hostCores = static_cast<int>(std::max(sysconf(_SC_NPROCESSORS_ONLN), 1L));
  cpu_set_t set;
  CPU_ZERO(&set);
  here.affinity = sched_getaffinity(0, sizeof set, &set) == 0 ? std::max(CPU_COUNT(&set), 1) : here.hostCores;
  here.ranksHere = ranksHere();
  return here;
}

double coresOfQuota(const Surroundings& here) {
  double least = 0;
  const auto take = [&](double cores) {
    if (cores > 0 && (least <= 0 || cores < least)) least = cores;
  };
  const std::string mount = here.root + "/sys/fs/cgroup";
  std::ifstream groups(here.root + "/proc/self/cgroup");
  // "HIERARCHY:CONTROLLERS:PATH"; version 2 has hierarchy 0 and names no controllers.
  for (std::string line; std::getline(groups, line);) {
    const size_t first = line.find(':'), second = first == line.npos ? first : line.find(':', first + 1);
    if (second == line.npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1),
                      path = line.substr(second + 1);
    if (line.starts_with("0:") && controllers.empty()) {
      take(leastOf(mount, path, coresOfVersion2));
    } else if (namesCpu(controllers)) {
      take(leastOf(mount + "/" + controllers, path, coresOfVersion1));
      take(leastOf(mount + "/cpu", path, coresOfVersion1));
    }
  }
  return least;
}

ThreadCount mostThreads(const Surroundings& here) {
  const double quota = coresOfQuota(here);
  const int granted = quota > 0 && quota < kMaxThreads ? static_cast<int>(std::ceil(quota)) : 0;
  if (granted > 0 && granted < here.affinity)
    return {granted, "CPU quota of the cgroup: " + coresText(quota), true};
  return {here.affinity, here.affinity < here.hostCores ? "cores that the process may run on" : "all cores",
          true};
}

ThreadCount chosenThreads(int wanted, const Surroundings& here) {
  ThreadCount most = mostThreads(here);
  const auto atMost = [&](int threads, const char* because) {
    return threads > most.threads ? most : ThreadCount{threads, because, false};
  };
  if (wanted > 0) return atMost(wanted, "setting threads");
  for (const char* const name : {"SLURM_CPUS_PER_TASK", "OMP_NUM_THREADS"})
    if (const int count = countIn(here.variable(name))) return atMost(count, name);
  // A launcher that binds ranks to cores has already divided the cores.
  if (here.ranksHere <= 1 || here.affinity < here.hostCores) return most;
  return {std::max(1, most.threads / here.ranksHere),
          "share of one of " + std::to_string(here.ranksHere) + " ranks on this host", false};
}

int mostThreadsHere() {
  static const int most = mostThreads(surroundingsOfThisProcess()).threads;
  return most;
}

int chosenThreadsHere() {
  static const int chosen = chosenThreads(0, surroundingsOfThisProcess()).threads;
  return chosen;
}

}  // namespace gluray
