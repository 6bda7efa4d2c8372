#include "explain/watched_run.h"

#include "base/files.h"
#include "base/processes/rest_detector.h"
#include "programs/doors.h"
#include "programs/launch.h"
#include "programs/stop_signals.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace gluray::launcher {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Seconds of processor time that a process has used; 0 after it has ended.
double processorSeconds(int pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string text((std::istreambuf_iterator<char>(file)), {});
  const size_t name = text.rfind(')');  // the name may hold blanks
  if (name == text.npos) return 0;
  std::istringstream fields(text.substr(name + 1));
  std::string skipped;
  for (int i = 3; i < 14; ++i) fields >> skipped;
  double user = 0, system = 0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

/// The reports in a folder; read() reads those that have changed.
class Reports {
 public:
  explicit Reports(std::string folder) : folder_(std::move(folder)) {}

  /// Returns whether a report is new.
  bool read() {
    bool fresh = false;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder_, ignored)) {
      const std::string name = entry.path().filename();
      if (!name.starts_with("report.json") || name.ends_with("pm")) continue;
      const fs::file_time_type written = fs::last_write_time(entry.path(), ignored);
      Known& known = known_[name];
      if (known.written == written) continue;
      std::ifstream file(entry.path());
      json report = json::parse(file, nullptr, /*allow_exceptions=*/false);
      if (report.is_discarded() || !report.contains("explain")) continue;
      known = {written, std::move(report)};
      fresh = true;
    }
    return fresh;
  }
  template <class T>
  T sum(const std::function<T(const json&)>& of) const {
    T total{};
    for (const auto& [name, known] : known_)
      if (known.report.is_object()) total += of(known.report);
    return total;
  }
  std::vector<json> all() const {
    std::vector<json> list;
    for (const auto& [name, known] : known_)
      if (known.report.is_object() && known.report["contexts"].get<int>() > 0) list.push_back(known.report);
    std::stable_sort(list.begin(), list.end(), [](const json& a, const json& b) {
      return a["frames"].get<uint64_t>() > b["frames"].get<uint64_t>();
    });
    return list;
  }

 private:
  struct Known {
    fs::file_time_type written;
    json report;
  };
  std::string folder_;
  std::map<std::string, Known> known_;
};

/// The number of frames, or of draws in programs that end no frame.
uint64_t drawn(const Reports& reports) {
  const auto frames = reports.sum<uint64_t>([](const json& r) { return r["frames"].get<uint64_t>(); });
  if (frames > 0) return frames;
  return reports.sum<uint64_t>([](const json& r) {
    uint64_t draws = r["draws"]["traced"].get<uint64_t>();
    for (const auto& [reason, count] : r["draws"]["rasterised"].items()) draws += count.get<uint64_t>();
    return draws;
  });
}

double worked(const Reports& reports) {
  return reports.sum<double>([](const json& r) { return processorSeconds(r["pid"].get<int>()); });
}

bool isComplete(const Reports& reports) {
  return reports.sum<int>([](const json& r) { return r["explain"]["complete"].get<bool>() ? 1 : 0; }) > 0;
}

WatchedRun::Ending waitForEnding(Child& child, const Watch& wish, Reports& reports) {
  const double start = now();
  RestDetector rest(wish.restSeconds);
  for (;; std::this_thread::sleep_for(std::chrono::milliseconds(20))) {
    const bool ended = child.ended();
    reports.read();
    if (isComplete(reports)) return WatchedRun::Ending::frames;
    if (ended) return WatchedRun::Ending::byItself;
    if (StopSignals::stopped()) return WatchedRun::Ending::stopped;
    if (wish.restSeconds > 0 && rest.isAtRest(drawn(reports), now(), [&] { return worked(reports); }))
      return WatchedRun::Ending::rest;
    if (wish.limitSeconds > 0 && now() - start > wish.limitSeconds) return WatchedRun::Ending::limit;
  }
}

void prepareEnvironment(const Watch& wish) {
  setenv("GLURAY_EXPLAIN", std::to_string(wish.frames).c_str(), 1);
  if (wish.image) setenv("GLURAY_PICTURE", "1", 1);
  if (!wish.steadyClock) return;
  const char* preload = std::getenv("LD_PRELOAD");
  const std::string clock = libraryDirectory() + "/libgluray-clock.so";
  setenv("LD_PRELOAD", (preload && *preload ? clock + ":" + preload : clock).c_str(), 1);
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string pattern = fs::temp_directory_path() / "gluray-XXXXXX";
  if (!mkdtemp(pattern.data())) throw std::runtime_error("cannot make a folder in " + pattern);
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

WatchedRun watch(const CommandLine& given, const Program& program, const Watch& wish,
                 const std::string& folder) {
  CommandLine line = given;
  line.settings.set("report", folder + "/report.json");
  const StopSignals signals;
  Child child(line, program, [&] {
    prepareEnvironment(wish);
    if (line.json || files::isOutput(line.html))
      dup2(STDERR_FILENO, STDOUT_FILENO);  // keeps the launcher's output pure
  });
  Reports reports(folder);
  WatchedRun run;
  run.ending = waitForEnding(child, wish, reports);
  child.end();
  // A program that ends by itself writes its last report at exit; after the last requested frame it has.
  reports.read();
  run.exitCode = child.exitCode();
  run.signal = child.signal();
  run.reports = reports.all();
  return run;
}

}  // namespace gluray::launcher
