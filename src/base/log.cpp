#include "base/log.h"

#include "base/files.h"
#include "base/log_filter.h"
#include "base/never_destroyed.h"
#include "base/printable.h"

#include <unistd.h>

#include <atomic>
#include <deque>
#include <mutex>
#include <set>
#include <string>
#include <utility>

namespace gluray::log {
namespace {

struct State {
  std::mutex mutex;
  files::Opened file;  // if not open, standard error is used
  Level level = Level::warning;
  std::set<std::string, std::less<>> said;
  std::deque<std::string> recent;
  bool hasStatus = false;  // the last line of the terminal is a status
};

thread_local Run t_run = nullptr;
std::atomic<Filter> g_filter{nullptr};

State& state() {
  static NeverDestroyed<State> state;
  return *state;
}

constexpr std::string_view kClearLine = "\r\x1b[K";

/// Writes to standard error.
void writeError(std::string_view text) {
  int error = 0;
  const GlurayOutput out = files::stream(STDERR_FILENO);
  glurayWrite(&out, text.data(), text.size(), 0, &error);
}

/// Calls write() on the thread that writes for the calling one.
template <class Write>
void byWriter(const Write& write) {
  if (t_run)
    t_run(write);
  else
    write();
}

bool isTerminal() {
  const GlurayOutput out = files::stream(STDERR_FILENO);
  return out.descriptor >= 0 && glurayIsSame(&out) && isatty(out.descriptor) == 1;
}

/// Writes a line in one piece, so that lines of several processes do not mix.
void writeLine(State& s, std::string_view message) {
  std::string line = "gluray: " + printable(message) + "\n";
  if (s.file.isOpen()) {
    files::write(s.file, line, 0);
    return;
  }
  if (std::exchange(s.hasStatus, false)) line.insert(0, kClearLine);
  writeError(line);
}

/// Whether the line is written, and in which words.
bool passes(const State& s, Level level, std::string_view message, std::string& changed) {
  changed = message;
  const Filter filter = s.file.isOpen() || level < Level::warning ? nullptr : g_filter.load();
  return !filter || filter(changed);
}

void keep(std::deque<std::string>& recent, std::string_view message) {
  constexpr size_t kMaxQuotedBytes = 400;
  recent.emplace_back(printable(message.substr(0, kMaxQuotedBytes)));
  if (recent.size() > kRecent) recent.pop_front();
}

}  // namespace

void configure(Level level, std::string_view file) {
  State& s = state();
  const std::lock_guard lock(s.mutex);
  s.level = level;
  files::stream(STDERR_FILENO);  // identified now, before the host program can open another file
  files::close(s.file);
  if (file.empty()) return;
  const std::string path(file);
  files::Opened opened = files::append(path);
  if (opened.isOpen())
    s.file = std::move(opened);
  else
    writeLine(s, "cannot write the log file " + path + ": " + opened.why + "; logging to stderr");
}

bool enabled(Level level) noexcept {
  try {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    return level != Level::off && level >= s.level;
  } catch (...) { return false; }
}

void write(Level level, std::string_view message) noexcept {
  try {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (level == Level::off) return;
    std::string changed;
    if (level >= s.level && passes(s, level, message, changed)) byWriter([&] { writeLine(s, changed); });
    if (level >= Level::warning) keep(s.recent, message);
  } catch (...) {  // drop the line
  }
}

void status(std::string_view line) noexcept {
  try {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (s.file.isOpen() || s.level > Level::warning || (line.empty() && !s.hasStatus)) return;
    byWriter([&] {
      if (!isTerminal()) return;
      writeError(std::string(kClearLine) + printable(line));
      s.hasStatus = !line.empty();
    });
  } catch (...) {}
}

void once(Level level, std::string_view key, std::string_view message) noexcept {
  try {
    State& s = state();
    {
      const std::lock_guard lock(s.mutex);
      if (!s.said.emplace(key).second) return;
    }
    write(level, message);
  } catch (...) {}
}

void filterBy(Filter filter) noexcept { g_filter = filter; }

void writeBy(Run run) noexcept { t_run = run; }

std::vector<std::string> recent() {
  State& s = state();
  const std::lock_guard lock(s.mutex);
  return {s.recent.begin(), s.recent.end()};
}

}  // namespace gluray::log
