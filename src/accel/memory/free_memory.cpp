#include "accel/memory/free_memory.h"

#include <sys/resource.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

namespace gluray::accel {
namespace {

constexpr size_t kUnlimited = std::numeric_limits<size_t>::max();

std::string contents(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

size_t number(std::string_view text, size_t otherwise) {
  const size_t start = std::min(text.find_first_not_of(" \t"), text.size());
  size_t value = otherwise;
  std::from_chars(text.data() + start, text.data() + text.size(), value);
  return value;
}

/// Bytes left below one group's limit. `limit`, `usage`: names of its files. Inactive file pages count as
/// free, because the kernel reclaims them.
size_t leftIn(const std::string& folder, const char* limit, const char* usage) {
  const size_t most = number(contents(folder + limit), kUnlimited);
  if (most >= kUnlimited / 2) return kUnlimited;
  const size_t used = number(contents(folder + usage), 0);
  const size_t reclaimable = numberBehind(contents(folder + "/memory.stat"), "inactive_file", 0);
  const size_t held = used - std::min(used, reclaimable);
  return most - std::min(most, held);
}

/// The least that is left in the process's control group and its ancestors (version 2), or in its memory
/// controller's group (version 1).
size_t leftInGroups() {
  const std::string groups = contents("/proc/self/cgroup");
  const auto pathBehind = [&](std::string_view mark) {
    const size_t start = groups.find(mark);
    if (start == std::string::npos) return std::string();
    const size_t path = start + mark.size();
    return groups.substr(path, groups.find('\n', path) - path);
  };
  size_t least = kUnlimited;
  for (std::string path = pathBehind("0::");; path.resize(path.rfind('/'))) {
    if (path == "/") path.clear();
    least = std::min(least, leftIn("/sys/fs/cgroup" + path, "/memory.max", "/memory.current"));
    if (path.empty() || path.rfind('/') == std::string::npos) break;
  }
  // Containers often mount the group's own folder as the root.
  for (const std::string& path : {pathBehind(":memory:"), std::string()})
    least = std::min(
        least, leftIn("/sys/fs/cgroup/memory" + path, "/memory.limit_in_bytes", "/memory.usage_in_bytes"));
  return least;
}

/// Bytes left below the process's limits of address space and data.
size_t leftInLimits() {
  size_t least = kUnlimited;
  std::string status;
  for (const auto& [which, name] : {std::pair{RLIMIT_AS, "VmSize"}, std::pair{RLIMIT_DATA, "VmData"}}) {
    rlimit limit;
    if (getrlimit(which, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) continue;
    if (status.empty()) status = contents("/proc/self/status");
    const size_t used = numberBehind(status, name, 0) * 1024;
    least = std::min<size_t>(least, limit.rlim_cur - std::min<size_t>(limit.rlim_cur, used));
  }
  return least;
}

}  // namespace

size_t numberBehind(std::string_view text, std::string_view name, size_t otherwise) {
  for (size_t at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
    const size_t end = at + name.size();
    const bool whole =
        (at == 0 || text[at - 1] == '\n') && end < text.size() && (text[end] == ':' || text[end] == ' ');
    if (whole) return number(text.substr(end + 1), otherwise);
  }
  return otherwise;
}

size_t freeMemory() noexcept {
  try {
    const size_t kilobytes = numberBehind(contents("/proc/meminfo"), "MemAvailable", kUnlimited / 1024);
    return std::min({kilobytes * 1024, leftInGroups(), leftInLimits()});
  } catch (...) { return kUnlimited; }
}

}  // namespace gluray::accel
