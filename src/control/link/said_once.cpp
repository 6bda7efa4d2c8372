#include "control/link/said_once.h"

#include "base/hash.h"
#include "control/process_start.h"
#include "control/runtime_directory.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <mutex>
#include <set>
#include <system_error>

namespace gluray::control {
namespace {

namespace fs = std::filesystem;

constexpr const char kPrefix[] = "said-";
constexpr double kOfThisJob = 60;  // seconds between the starts of a job's ranks

std::string claimOf(const Job& job, const std::string& line) {
  const std::string text = job.name + "\n" + line;
  const Hash128 hash = hashBytes(text.data(), text.size());
  char name[64];
  std::snprintf(name, sizeof name, "%s%016llx%016llx", kPrefix, static_cast<unsigned long long>(hash.high),
                static_cast<unsigned long long>(hash.low));
  return name;
}

/// Makes the file. Returns false if another process of the job has made it.
bool claim(const std::string& path, double began) {
  for (int attempt = 0; attempt < 2; ++attempt) {
    const int file = open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (file >= 0) return close(file), true;
    struct stat found {};
    if (errno != EEXIST || lstat(path.c_str(), &found) != 0) return true;
    if (static_cast<double>(found.st_mtime) >= began - kOfThisJob) return false;
    unlink(path.c_str());
  }
  return true;
}

/// Removes claims of a day before.
void removeOld(const std::string& directory, double began) {
  constexpr double kDay = 86400;
  std::error_code error;
  for (fs::directory_iterator at(directory, error), end; !error && at != end; at.increment(error)) {
    struct stat found {};
    if (at->path().filename().string().starts_with(kPrefix) && lstat(at->path().c_str(), &found) == 0 &&
        static_cast<double>(found.st_mtime) < began - kDay)
      unlink(at->path().c_str());
  }
}

}  // namespace

bool saysLine(const Job& job, const std::string& line, const std::string& directory, double began) {
  if (job.ranks < 2 || job.name.empty() || !makeRuntimeDirectory(directory).empty()) return true;
  static std::mutex& mutex = *new std::mutex;
  static std::set<std::string>& own = *new std::set<std::string>;  // claims of this process
  const std::string path = directory + "/" + claimOf(job, line);
  const std::lock_guard lock(mutex);
  if (own.contains(path)) return true;
  if (!claim(path, began)) return false;
  own.insert(path);
  removeOld(directory, began);
  return true;
}

std::string withRank(const Job& job, const std::string& line) {
  if (job.ranks < 2) return line;
  return line + " (rank " + std::to_string(job.rank) + " of " + std::to_string(job.ranks) +
         "; once on this host)";
}

bool saysLineHere(std::string& line) noexcept {
  try {
    static const Job& job = *new Job(jobOfThisProcess());
    if (job.ranks < 2) return true;
    if (!saysLine(job, line, runtimeDirectory(), beginOfProcess())) return false;
    line = withRank(job, line);
  } catch (const std::exception&) {}  // no memory: says it
  return true;
}

}  // namespace gluray::control
