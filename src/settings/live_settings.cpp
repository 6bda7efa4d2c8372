#include "settings/live_settings.h"

#include "settings/values.h"

#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <ctime>
#include <exception>

namespace gluray {
namespace {

constexpr double kWritingSeconds = 0.02;  // files that are younger may still be written
constexpr double kShare = 0.01;           // of the time for looks, on slow file systems

double secondsSince(const int64_t (&when)[2]) {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  return static_cast<double>(now.tv_sec - when[0]) + 1e-9 * static_cast<double>(now.tv_nsec - when[1]);
}

/// "gluray.toml:12: spp ..." -> "gluray.toml: spp ...": a mistake stays the same when lines before it change.
std::string withoutLine(const std::string& mistake) {
  for (size_t at = mistake.find(':'); at != mistake.npos; at = mistake.find(':', at + 1)) {
    size_t end = at + 1;
    while (end < mistake.size() && std::isdigit(static_cast<unsigned char>(mistake[end]))) ++end;
    if (end > at + 1 && end < mistake.size() && mistake[end] == ':')
      return mistake.substr(0, at) + mistake.substr(end);
  }
  return mistake;
}

/// Why the setting cannot be set live; empty: it can.
std::string whyNot(const Row& row) {
  if (!row.inFiles) return std::string(row.name) + " belongs to one run";
  if (row.applies == Applies::process)
    return std::string(row.name) + " applies to the next run only; set it in gluray.toml or as an option";
  return "";
}

}  // namespace

LiveSettings::Stamp LiveSettings::Stamp::of(const std::string& file) {
  struct stat s {};
  if (file.empty() || stat(file.c_str(), &s) != 0) return {};
  return {static_cast<int64_t>(s.st_dev),
          static_cast<int64_t>(s.st_ino),
          s.st_size,
          {s.st_mtim.tv_sec, s.st_mtim.tv_nsec},
          {s.st_ctim.tv_sec, s.st_ctim.tv_nsec}};
}

LiveSettings::Stamps LiveSettings::stamps() const {
  return {Stamp::of(sources_.systemFile), Stamp::of(sources_.userFile), Stamp::of(sources_.projectFile)};
}

/// Whether no file is being written: editors truncate a file or remove it before they write it.
bool LiveSettings::settled(const Stamps& now) const {
  if (now == seen_) return true;
  for (size_t i = 0; i < now.size(); ++i) {
    if (now[i] == read_[i]) continue;
    const double age = secondsSince(now[i].changed);
    if (now[i].size <= 0 || (age >= 0 && age < kWritingSeconds)) return false;
  }
  return true;
}

bool LiveSettings::isNew(const std::string& mistake) const {
  return std::find(mistakes_.begin(), mistakes_.end(), withoutLine(mistake)) == mistakes_.end();
}

Session LiveSettings::take(Session session) {
  if (session.settings.threads == 0) session.settings.threads = ownThreads_;
  if (session.settings != *source_.current()) source_.store(session.settings);
  started_ = true;
  return session;
}

Session LiveSettings::start(Sources sources) {
  const std::lock_guard lock(mutex_);
  sources_ = std::move(sources);
  ownThreads_ = threadsOfThisRank();
  seen_ = read_ = stamps();
  const Complain report = [&](const std::string& line) {
    mistakes_.push_back(withoutLine(line));
    complain_(line);
  };
  files_ = readConfigFiles(sources_, report);
  return take(layersOf(sources_, files_, report).session);
}

void LiveSettings::look(double now) noexcept {
  try {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock || !started_ || now < next_) return;
    const double before = nowSeconds();
    const Stamps current = stamps();
    next_ = now + std::max(kLookSeconds, (nowSeconds() - before) / kShare);
    const bool changed = current != read_ && settled(current);
    seen_ = current;
    if (!changed) return;
    Lines mistakes;
    const Complain note = [&](const std::string& line) { mistakes.push_back(line); };
    ConfigFiles files = readConfigFiles(sources_, note);
    Layers layers = layersOf(sources_, files, note);
    const bool fine = std::none_of(mistakes.begin(), mistakes.end(), [&](const auto& m) { return isNew(m); });
    for (const std::string& line : mistakes)
      complain_(fine ? line : line + "; all settings stay as they are");
    if (fine) {
      take(std::move(layers.session));
      files_ = std::move(files);
      for (std::string& line : mistakes) line = withoutLine(line);
      mistakes_ = std::move(mistakes);
    }
    read_ = current;
  } catch (const std::exception&) {}  // out of memory: the settings stay as they are
}

LiveSettings::Answer LiveSettings::change(std::span<const Change> changes) {
  const std::lock_guard lock(mutex_);
  Sources next = sources_;
  for (const Change& c : changes) {
    const Row* const row = findSetting(c.name);
    if (!row) return {unknownSetting(c.name), 0};
    if (std::string why = whyNot(*row); !why.empty()) return {std::move(why), 0};
    std::erase_if(next.live, [&](const auto& known) { return known.first == c.name; });
    if (c.value) next.live.emplace_back(c.name, *c.value);
  }
  std::string why;  // the first new mistake
  Layers layers = layersOf(next, files_, [&](const std::string& line) {
    if (why.empty() && isNew(line)) why = line;
  });
  if (!why.empty()) return {std::move(why), 0};
  take(std::move(layers.session));
  sources_ = std::move(next);
  return {"", source_.version()};
}

}  // namespace gluray
