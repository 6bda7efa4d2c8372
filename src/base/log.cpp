#include "base/log.h"

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <mutex>
#include <set>
#include <string>

namespace gluray::log {
namespace {

struct State {
  std::mutex mutex;
  std::shared_ptr<spdlog::logger> logger;
  Level level = Level::warning;
  std::set<std::string, std::less<>> said;
};

State& state() {
  static State* s = new State;  // never destroyed: hosts call us while they exit
  return *s;
}

spdlog::level::level_enum toSpdlog(Level level) { return static_cast<spdlog::level::level_enum>(level); }

std::shared_ptr<spdlog::logger> makeLogger(std::string_view file) {
  spdlog::sink_ptr sink;
  if (file.empty())
    sink = std::make_shared<spdlog::sinks::stderr_sink_mt>();
  else
    sink = std::make_shared<spdlog::sinks::basic_file_sink_mt>(std::string(file));
  auto logger = std::make_shared<spdlog::logger>("gluray", std::move(sink));
  logger->set_pattern("gluray: %v");
  logger->set_level(spdlog::level::trace);
  logger->flush_on(spdlog::level::trace);
  return logger;
}

}  // namespace

void configure(Level level, std::string_view file) {
  State& s = state();
  const std::lock_guard lock(s.mutex);
  s.level = level;
  try {
    s.logger = makeLogger(file);
  } catch (const std::exception&) {
    if (file.empty()) throw;
    s.logger = makeLogger({});
    s.logger->warn("cannot write the log file {}; logging to stderr", file);
  }
}

void write(Level level, std::string_view message) noexcept {
  try {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (level < s.level || level == Level::off) return;
    if (!s.logger) s.logger = makeLogger({});
    s.logger->log(toSpdlog(level), message);
  } catch (...) {  // a log line is never worth a failure
  }
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

}  // namespace gluray::log
