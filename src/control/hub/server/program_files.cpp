#include "control/hub/server/program_files.h"

#include "control/messages/members.h"

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>

namespace gluray::control {
namespace {

using nlohmann::json;

constexpr size_t kMaxFileBytes = 4096, kMaxFiles = 4096, kMaxDisplayCharacters = 255;
constexpr int kStartField = 22;  // of /proc/PID/stat

/// The process id in a file's name; 0 if there is none.
int pidOfName(const std::string& name) {
  int pid = 0;
  const auto read = std::from_chars(name.data(), name.data() + name.size(), pid);
  return read.ec == std::errc{} && read.ptr == name.data() + name.size() && pid > 0 ? pid : 0;
}

/// Whether the process runs for this user. If another user's process has the number, the original has ended.
bool runs(int pid) { return kill(pid, 0) == 0; }

/// Start time of the process in clock ticks since boot; 0 if unknown.
uint64_t startOf(int pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string line;
  std::getline(file, line, '\0');
  const size_t name = line.rfind(')');  // end of field 2, which may contain anything
  if (name == line.npos) return 0;
  std::istringstream fields(line.substr(name + 1));
  std::string skipped;
  for (int field = 3; field < kStartField; ++field) fields >> skipped;
  uint64_t start = 0;
  return fields >> start ? start : 0;
}

/// Whether the file was left by an earlier process with the same id.
bool ofEarlierProcess(const std::string& text, int pid) {
  const json content = json::parse(text, nullptr, false);
  const auto since = wholeNumber(member(content, "since"), 1, kMaxFrame);
  const uint64_t start = since ? startOf(pid) : 0;
  return start != 0 && static_cast<uint64_t>(*since) != start;
}

std::string textOfFile(int directory, const std::string& name) {
  const int file = openat(directory, name.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (file < 0) return "";
  struct stat status {};
  std::string text;
  if (fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == geteuid()) {
    std::array<char, kMaxFileBytes + 1> bytes;
    const ssize_t size = read(file, bytes.data(), bytes.size());
    if (size > 0 && static_cast<size_t>(size) <= kMaxFileBytes)
      text.assign(bytes.data(), static_cast<size_t>(size));
  }
  close(file);
  return text;
}

std::optional<ProgramFile> programFile(const std::string& text, int pid) {
  const json content = json::parse(text, nullptr, false);
  const auto said = wholeNumber(member(content, "pid"), 1, std::numeric_limits<int>::max());
  const auto name = textMember(content, "name", kMaxDisplayCharacters, "");
  const auto display = textMember(content, "display", kMaxDisplayCharacters, "");
  const auto window = wholeNumber(member(content, "window"), 0, std::numeric_limits<uint32_t>::max());
  if (said != pid || !name || !display || !window || (*window != 0 && display->empty())) return std::nullopt;
  return ProgramFile{pid, *name, *display, static_cast<unsigned long>(*window)};
}

}  // namespace

std::vector<ProgramFile> programFiles(const std::string& directory) {
  std::vector<ProgramFile> files;
  const int folder = open((directory + "/programs").c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
  if (folder < 0) return files;
  struct stat status {};
  DIR* const entries =
      fstat(folder, &status) == 0 && status.st_uid == geteuid() ? fdopendir(folder) : nullptr;
  if (!entries) return close(folder), files;
  for (size_t seen = 0; seen < kMaxFiles; ++seen) {
    const dirent* const entry = readdir(entries);
    if (!entry) break;
    const std::string name = entry->d_name;
    const int pid = pidOfName(name);
    if (pid == 0) continue;
    const std::string text = runs(pid) ? textOfFile(folder, name) : "";
    if (!runs(pid) || ofEarlierProcess(text, pid)) {
      unlinkat(folder, name.c_str(), 0);
      continue;
    }
    if (auto file = programFile(text, pid)) files.push_back(std::move(*file));
  }
  closedir(entries);
  return files;
}

}  // namespace gluray::control
