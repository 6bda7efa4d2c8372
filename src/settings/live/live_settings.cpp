#include "settings/live/live_settings.h"

#include "settings/values.h"

#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <ctime>
#include <exception>

namespace gluray {
namespace {

constexpr double kWritingSeconds = 0.02;  // younger files may still be being written
constexpr double kShare = 0.01;           // maximum share of time for checks, on slow file systems

double secondsSince(const int64_t (&when)[2]) {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  return static_cast<double>(now.tv_sec - when[0]) + 1e-9 * static_cast<double>(now.tv_nsec - when[1]);
}

/// "gluray.toml:12: spp ..." -> "gluray.toml: spp ...", so that a mistake stays the same if lines before it
/// change.
std::string withoutLine(const std::string& mistake) {
  for (size_t at = mistake.find(':'); at != mistake.npos; at = mistake.find(':', at + 1)) {
    size_t end = at + 1;
    while (end < mistake.size() && std::isdigit(static_cast<unsigned char>(mistake[end]))) ++end;
    if (end > at + 1 && end < mistake.size() && mistake[end] == ':')
      return mistake.substr(0, at) + mistake.substr(end);
  }
  return mistake;
}

/// Why the setting cannot be set live; empty if it can.
std::string whyNotLive(const Row& row) {
  if (!row.inFiles) return std::string(row.name) + " belongs to one run";
  if (row.applies == Applies::context)
    return std::string(row.name) + " applies when windows are made; set it in gluray.toml or as an option";
  if (row.applies == Applies::process)
    return std::string(row.name) + " applies to the next run only; set it in gluray.toml or as an option";
  return "";
}

}  // namespace

LiveSettings::Stamp LiveSettings::Stamp::stampOf(const std::string& file) {
  struct stat s {};
  if (file.empty() || stat(file.c_str(), &s) != 0) return {};
  return {static_cast<int64_t>(s.st_dev),
          static_cast<int64_t>(s.st_ino),
          s.st_size,
          {s.st_mtim.tv_sec, s.st_mtim.tv_nsec},
          {s.st_ctim.tv_sec, s.st_ctim.tv_nsec}};
}

LiveSettings::Stamps LiveSettings::stamps() const {
  return {Stamp::stampOf(sources_.systemFile), Stamp::stampOf(sources_.userFile),
          Stamp::stampOf(sources_.projectFile)};
}

/// Whether no file is being written: editors truncate or remove a file before they write it.
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

Settings LiveSettings::withThreads(Settings settings) const {
  if (settings.threads == 0) settings.threads = ownThreads_;
  return settings;
}

Session LiveSettings::takeSession(Session session) {
  session.settings = withThreads(std::move(session.settings));
  if (session.settings != *source_.current()) source_.store(session.settings);
  started_ = true;
  ++revision_;
  return session;
}

/// Once their frame has begun, changes that waited for it become ordinary ones.
void LiveSettings::settle() {
  if (!later_ || !source_.counts(ticket_)) return;
  sources_ = std::move(*later_);
  later_.reset();
  ++revision_;
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
  return takeSession(layersOf(sources_, files_, report).session);
}

void LiveSettings::readIfChanged(double now) noexcept {
  try {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock || !started_ || now < next_) return;
    settle();
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
      if (later_)
        source_.storeBoth(withThreads(layers.session.settings),
                          withThreads(layersOf(*later_, files, note).session.settings)),
            ++revision_;
      else
        takeSession(std::move(layers.session));
      files_ = std::move(files);
      for (std::string& line : mistakes) line = withoutLine(line);
      mistakes_ = std::move(mistakes);
    }
    read_ = current;
  } catch (const std::exception&) {}  // out of memory: the settings stay unchanged
}

/// The sources after the changes and the resulting settings, or an error.
struct LiveSettings::Next {
  Sources sources;
  Settings settings;
  Changes before;
  std::string why;
};

LiveSettings::Next LiveSettings::settingsAfter(std::span<const Change> changes) const {
  Next next{later_ ? *later_ : sources_, {}, {}, ""};
  auto& live = next.sources.live;
  for (const Change& c : changes) {
    const Row* const row = findSetting(c.name);
    next.why = row ? whyNotLive(*row) : unknownSetting(c.name);
    if (!next.why.empty()) return next;
    const auto known =
        std::find_if(live.begin(), live.end(), [&](const auto& l) { return l.first == c.name; });
    next.before.push_back({c.name, known == live.end() ? std::nullopt : std::optional(known->second)});
    if (known != live.end()) live.erase(known);
    if (c.value) live.emplace_back(c.name, *c.value);
  }
  next.settings = withThreads(layersOf(next.sources, files_, [&](const std::string& line) {
                                if (next.why.empty() && isNew(line)) next.why = line;
                              }).session.settings);
  return next;
}

LiveSettings::Answer LiveSettings::change(std::span<const Change> changes, uint64_t frame) {
  const std::lock_guard lock(mutex_);
  settle();
  Next next = this->settingsAfter(changes);
  if (!next.why.empty()) return {std::move(next.why), 0, 0, {}};
  ++revision_;
  if (frame > source_.frame()) {
    ticket_ = source_.storeAt(frame, next.settings);
    later_ = std::move(next.sources);
    return {"", 0, ticket_, std::move(next.before)};
  }
  if (later_ || next.settings != *source_.current()) source_.store(next.settings);
  sources_ = std::move(next.sources);
  later_.reset();
  return {"", source_.version(), 0, std::move(next.before)};
}

std::string LiveSettings::whyNot(std::span<const Change> changes) {
  const std::lock_guard lock(mutex_);
  settle();
  return settingsAfter(changes).why;
}

std::optional<uint64_t> LiveSettings::firstFrameWith(const Answer& answer) const {
  return answer.ticket ? source_.firstFrameOfTicket(answer.ticket) : source_.firstFrameWith(answer.version);
}

Layers LiveSettings::layers(bool waiting) {
  const std::lock_guard lock(mutex_);
  settle();
  return layersOf(waiting && later_ ? *later_ : sources_, files_, [](const std::string&) {});
}

std::vector<LiveSettings::Value> LiveSettings::values(bool waiting) {
  const Layers layers = this->layers(waiting);
  std::vector<Value> values;
  for (const Row& row : settingRows()) {
    if (!row.inFiles) continue;
    const Given* const given = layers.last(row);
    values.push_back({&row, printValue(row, layers.session), given ? given->layer : Layer::builtIn,
                      given ? given->place : ""});
  }
  return values;
}

uint64_t LiveSettings::revision() noexcept {
  if (const std::unique_lock lock(mutex_, std::try_to_lock); lock) {
    try {
      settle();
    } catch (const std::exception&) {}  // out of memory: retried next time
  }
  return revision_;
}

}  // namespace gluray
