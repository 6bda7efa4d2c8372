#include "cluster/worker/facts/rank_facts.h"

#include "cluster/messages/version.h"

#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <fstream>
#include <iterator>
#include <system_error>

namespace gluray::cluster {
namespace {

std::string contentOf(const char* path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Reads a number at the front of `text` and removes it; negative: there is none.
int64_t takeNumber(std::string_view& text) {
  int64_t number = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || number < 0) return -1;
  text.remove_prefix(static_cast<size_t>(end - text.data()));
  return number;
}

}  // namespace

std::string hostName() {
  char name[256] = {};
  return gethostname(name, sizeof name - 1) == 0 ? name : "";
}

std::string lineOf(std::string_view text, std::string_view name) {
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (!line.starts_with(name) || !line.substr(name.size()).starts_with(':')) continue;
    line.remove_prefix(name.size() + 1);
    const size_t begin = line.find_first_not_of(" \t");
    return begin == line.npos ? "" : std::string(line.substr(begin));
  }
  return "";
}

uint64_t memoryOf(std::string_view kilobytes) {
  const int64_t number = takeNumber(kilobytes);
  constexpr int64_t kMax = int64_t{1} << 52;
  return number >= 0 && number < kMax && kilobytes == " kB" ? static_cast<uint64_t>(number) * 1024 : 0;
}

int countCores(std::string_view list) {
  constexpr int64_t kMax = 1 << 20;
  int64_t count = 0;
  for (;;) {
    const int64_t first = takeNumber(list);
    int64_t last = first;
    if (list.starts_with('-')) list.remove_prefix(1), last = takeNumber(list);
    if (first < 0 || last < first || last >= kMax) return 0;
    count += last - first + 1;
    if (list.empty()) return count <= kMax ? static_cast<int>(count) : 0;
    if (!list.starts_with(',')) return 0;
    list.remove_prefix(1);
  }
}

std::string chosenWord(std::string_view text) {
  const size_t open = text.find('['), close = text.find(']', open == text.npos ? 0 : open);
  if (open == text.npos || close == text.npos) return "";
  return std::string(text.substr(open + 1, close - open - 1));
}

RankFacts factsOf(const Ranks& ranks, int threads) {
  RankFacts facts;
  facts.rank = ranks.rank(), facts.rankHere = ranks.rankHere(), facts.ranksHere = ranks.sizeHere();
  facts.version = version(), facts.mpi = ranks.implementation(), facts.host = hostName();
  facts.threads = threads;
  facts.cores = lineOf(contentOf("/proc/self/status"), "Cpus_allowed_list");
  facts.usableCores = countCores(facts.cores);
  facts.hostCores = static_cast<int32_t>(sysconf(_SC_NPROCESSORS_ONLN));
  const std::string memory = contentOf("/proc/meminfo");
  facts.memoryBytes = memoryOf(lineOf(memory, "MemTotal"));
  facts.availableBytes = memoryOf(lineOf(memory, "MemAvailable"));
  if (struct statvfs shm{}; statvfs("/dev/shm", &shm) == 0) {
    facts.shmBytes = uint64_t{shm.f_blocks} * shm.f_frsize;
    facts.shmFreeBytes = uint64_t{shm.f_bavail} * shm.f_frsize;
  }
  facts.hugePages = chosenWord(contentOf("/sys/kernel/mm/transparent_hugepage/enabled"));
  facts.isBigEndian = std::endian::native == std::endian::big;
  return facts;
}

}  // namespace gluray::cluster
