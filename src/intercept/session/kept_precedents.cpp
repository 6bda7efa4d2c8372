#include "intercept/session/kept_precedents.h"

#include "base/environment_variable.h"
#include "base/files.h"
#include "base/log.h"
#include "base/never_destroyed.h"
#include "control/link/job.h"
#include "intercept/session/guarded.h"
#include "intercept/session/session.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iterator>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace gluray::intercept {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kFormat = 1;
constexpr size_t kMostBytes = size_t{1} << 20;

int64_t today() { return static_cast<int64_t>(std::time(nullptr)) / (24 * 60 * 60); }

/// Empty if there is no such directory, or the program has no name.
fs::path fileOfProgram() {
  const std::string cache = environmentVariable("XDG_CACHE_HOME"), home = environmentVariable("HOME");
  const fs::path base = cache.empty() ? fs::path(home.empty() ? "" : home + "/.cache") : fs::path(cache);
  const std::string program = programName();
  return base.is_absolute() && !program.empty() ? base / "gluray" / "trials" / (program + ".json")
                                                : fs::path();
}

/// The precedents of this process, by engines.
class Memory {
 public:
  std::shared_ptr<gl::Precedents> of(const Engines& engines) {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(loaded_, true)) load();
    for (const Known& known : known_)
      if (known.engines == engines) return known.precedents;
    return known_.emplace_back(Known{engines, today(), {}, std::make_shared<gl::Precedents>()}).precedents;
  }

  /// Writes the file if there are new results.
  void save() {
    const std::lock_guard lock(mutex_);
    std::vector<KeptPrecedents> kept;
    bool changed = false;
    for (const Known& known : known_) {
      std::vector<gl::Precedent> now = known.precedents->all();
      const bool isNew = now != known.read;
      changed |= isNew;
      if (!now.empty()) kept.push_back({known.engines, isNew ? today() : known.day, std::move(now)});
    }
    if (!changed) return;
    std::error_code error;
    fs::create_directories(file_.parent_path(), error);  // replace() tells what failed
    if (const std::string why = files::replace(file_.string(), writtenPrecedents(std::move(kept)));
        !why.empty())
      log::write(log::Level::debug, "results of engine = auto are not kept: " + why);
  }

 private:
  struct Known {
    Engines engines;
    int64_t day;
    std::vector<gl::Precedent> read;  // from the file
    std::shared_ptr<gl::Precedents> precedents;
  };

  void load() {
    if (!session().rememberEngine) return;
    file_ = fileOfProgram();
    if (file_.empty()) return;
    if (control::jobOfThisProcess().rank == 0) std::atexit(keep);
    const files::Content content = files::readOwn(file_.string(), kMostBytes);
    if (content.missing) return;
    try {
      if (!content.why.empty()) throw std::runtime_error(content.why);
      for (KeptPrecedents& one : readPrecedents(content.text, today())) {
        auto precedents = std::make_shared<gl::Precedents>();
        for (const gl::Precedent& precedent : one.list) precedents->add(precedent);
        known_.push_back({std::move(one.engines), one.day, precedents->all(), precedents});
      }
    } catch (const std::exception& e) {
      log::write(log::Level::debug,
                 "results of engine = auto are not read from " + file_.string() + ": " + e.what());
    }
  }

  static void keep() noexcept;

  std::mutex mutex_;
  bool loaded_ = false;
  fs::path file_;
  std::vector<Known> known_;
};

/// Never destroyed: programs create contexts while they exit.
Memory& memory() {
  static NeverDestroyed<Memory> memory;
  return *memory;
}

void Memory::keep() noexcept {
  guarded("cannot keep the results of engine = auto", [] { memory().save(); });
}

}  // namespace

std::shared_ptr<gl::Precedents> precedentsOf(const Engines& engines) { return memory().of(engines); }

std::vector<KeptPrecedents> readPrecedents(std::string_view text, int64_t today) {
  const json content = json::parse(text);
  if (content.at("format") != kFormat) throw std::runtime_error("unknown format");
  std::vector<KeptPrecedents> all;
  for (const json& engines : content.at("engines")) {
    KeptPrecedents kept{{engines.at("renderer"), engines.at("threads")}, engines.at("day"), {}};
    if (kept.day > today || kept.day < today - kDaysKept) continue;
    for (const json& trial : engines.at("trials"))
      kept.list.push_back(
          {{trial.at("triangles"), trial.at("pixels")}, trial.at("traced"), trial.at("direct")});
    all.push_back(std::move(kept));
  }
  return all;
}

std::string writtenPrecedents(std::vector<KeptPrecedents> kept) {
  std::stable_sort(kept.begin(), kept.end(), [](const auto& a, const auto& b) { return a.day > b.day; });
  if (kept.size() > kMostEngines) kept.erase(std::next(kept.begin(), kMostEngines), kept.end());
  json all = json::array();
  for (const KeptPrecedents& one : kept) {
    json trials = json::array();
    for (const gl::Precedent& trial : one.list)
      trials.push_back({{"triangles", trial.load.triangles},
                        {"pixels", trial.load.pixels},
                        {"traced", trial.traced},
                        {"direct", trial.direct}});
    all.push_back({{"renderer", one.engines.renderer},
                   {"threads", one.engines.threads},
                   {"day", one.day},
                   {"trials", trials}});
  }
  return json{{"format", kFormat}, {"engines", all}}.dump(1, ' ', false, json::error_handler_t::replace) +
         "\n";
}

}  // namespace gluray::intercept
