#include "intercept/control/in_process.h"

#include "base/clock.h"
#include "base/never_destroyed.h"
#include "control/link/program_side.h"
#include "control/messages/members.h"
#include "intercept/control/engine_program.h"
#include "intercept/reports/report.h"
#include "intercept/session/session.h"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <cstring>
#include <exception>
#include <limits>
#include <mutex>
#include <string>

namespace gluray::intercept {
namespace {

using nlohmann::json;

/// The program draws by itself: it is never asked to.
class AskingProgram final : public EngineProgram {
 public:
  void wake() noexcept override {}
};

/// The engine's side of a connection that has no hub: requests come from the program itself. Requires the
/// mutex.
class InProcess {
 public:
  InProcess()
      : side_(program_, liveSettings(), settingsSource(), history_,
              {[this](const control::Connection::Line& line) { last_ = json::parse(*line); },
               [](const std::string&) {}, [] { return size_t{0}; }}) {
    side_.begin(0);
    side_.receiveMessage({{"type", "hello"}, {"version", 1}}, 0);
  }

  json ask(json request) {
    constexpr int kId = 1;
    request["id"] = kId;
    last_ = json();
    side_.receiveMessage(request, nowSeconds());
    // Nobody draws while the caller waits: a change is answered as if its time had passed.
    if (last_.is_null()) side_.passed(std::numeric_limits<double>::max());
    if (const auto why = last_.find("why"); why != last_.end()) return {{"why", *why}};
    const auto results = last_.find("results");
    return results != last_.end() && !results->empty() ? results->front() : json::object();
  }

  std::mutex mutex;

 private:
  AskingProgram program_;
  SettingsHistory history_;
  json last_;  // message to the caller
  control::ProgramSide side_;
};

json answerTo(const char* text) {
  json request = json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!request.is_object()) return {{"why", "a request is a JSON object"}};
  const std::string type = control::textMember(request, "type", control::kMaxCharacters).value_or("");
  if (type == "report") return reportOfNow();
  if (type != "get" && type != "describe" && type != "set" && type != "undo" && type != "redo")
    return {{"why", "a program cannot ask itself for '" + type + "'; a program of its own can"}};
  request.erase("hold");  // frames of other ranks
  static NeverDestroyed<InProcess> inProcess;
  const std::lock_guard lock((*inProcess).mutex);
  return (*inProcess).ask(std::move(request));
}

char* copied(const std::string& text) {
  auto* const copy = static_cast<char*>(std::malloc(text.size() + 1));
  if (copy) std::memcpy(copy, text.c_str(), text.size() + 1);
  return copy;
}

}  // namespace
}  // namespace gluray::intercept

__attribute__((visibility("default"))) char* glurayAsk(const char* request) {
  using nlohmann::json;
  try {
    // Names of programs and drivers may be invalid UTF-8.
    return gluray::intercept::copied(
        gluray::intercept::answerTo(request).dump(-1, ' ', false, json::error_handler_t::replace));
  } catch (const std::exception&) { return nullptr; }  // out of memory
}

__attribute__((visibility("default"))) void glurayForget(char* answer) { std::free(answer); }
