#include "control/hub_session.h"

#include "control/runtime_directory.h"
#include "say.h"
#include "settings/settings_list.h"
#include "settings/values.h"
#include "wake/wake.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <thread>

namespace gluray::launcher {
namespace {

using nlohmann::json;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr double kConnectSeconds = 5, kListSeconds = 5;
// More than the hub gives a program: then it says which one does not answer.
constexpr double kAnswerSeconds = 12;
// Programs look for a hub when a frame begins, at most every 50 ms. Those that draw nothing are woken.
constexpr milliseconds kMin{120}, kMax{1000};
// While none is there, or not the one that the command names, but the hub expects some: those with slow
// frames. A hub asks windows to draw for the last time after three seconds.
constexpr milliseconds kMaxExpected{5000};
// Programs of other machines try to reach a hub at least this often, and cannot be expected.
constexpr milliseconds kMaxFar{9000};
constexpr milliseconds kPause{20};
constexpr std::chrono::seconds kMaxForOthers{15};
constexpr int64_t kNoProgram = 0;

double seconds(milliseconds time) { return std::chrono::duration<double>(time).count(); }

std::string settingOr(const Layers& layers, const char* name, const std::string& given) {
  const Row* row = given.empty() ? findSetting(name) : nullptr;
  return row ? printValue(*row, layers.session) : given;
}

}  // namespace

control::HubAddress addressOf(const CommandLine& line) {
  const Layers layers = readLayers(sourcesOf(line), [](const std::string& complaint) { say(complaint); });
  control::HubAddress address;
  address.directory = control::runtimeDirectory();
  address.host = settingOr(layers, "hub", line.control.hub);
  address.keyFile = settingOr(layers, "hub-key", line.control.keyFile);
  return address;
}

HubSession::HubSession(const CommandLine& line) : address_(addressOf(line)), wanted_(line.control.programs) {
  join();
  waitForPrograms();
}

HubSession::~HubSession() {
  client_.leave();
  if (!isHub_) return;
  std::cout.flush();
  try {
    const auto end = steady_clock::now() + kMaxForOthers;
    do {
      while (hub_.clients() > 0 && steady_clock::now() < end) pause();
      if (io_.stopped()) io_.restart();
      io_.poll();  // those that connect just now
    } while (hub_.clients() > 0 && steady_clock::now() < end);
  } catch (const std::exception&) {  // no memory: others look for another hub
  }
}

/// Lets the hub work for a moment.
void HubSession::pause() {
  const auto end = steady_clock::now() + kPause;
  while (steady_clock::now() < end) {
    if (io_.stopped()) io_.restart();
    if (io_.run_one_until(end) == 0 && io_.stopped()) std::this_thread::sleep_until(end);
  }
}

/// A hub that ends, or one that begins, is in nobody's way for longer than a moment.
void HubSession::join() {
  const auto end = steady_clock::now() + kMax;
  while (true) {
    const std::string why = client_.connect(address_, kConnectSeconds);
    if (why.empty()) return;
    const bool none = !client_.reached();
    if (!address_.host.empty() || (!none && !client_.ended()) || steady_clock::now() >= end)
      throw std::runtime_error(why);
    if (none && !isHub_) beHub();
    if (!isHub_) pause();
  }
}

void HubSession::beHub() {
  control::HubOptions options;
  options.directory = address_.directory;
  options.wake = wakeWindow;
  const std::string why = hub_.start(options);
  if (hub_.otherHubRuns()) return;
  if (!why.empty()) throw std::runtime_error(why);
  isHub_ = true;
}

/// How old a hub is from which on programs that are not there are not waited for.
double HubSession::secondsToWait(const std::vector<RunningProgram>& programs) const {
  const bool complete = areThere(programs, wanted_);
  if (complete && client_.hubExpects() == 0) return seconds(kMin);
  if (!complete && client_.hubListensOnTcp()) return seconds(kMaxFar);
  return seconds(!complete && client_.hubExpects() > 0 ? kMaxExpected : kMax);
}

/// Each hello says anew how many programs are expected.
void HubSession::waitForPrograms() {
  const auto end = steady_clock::now() + kMaxFar;
  while (client_.hubAge() < seconds(kMaxFar) && steady_clock::now() < end) {
    const json list = client_.ask({{"type", "list"}}, kListSeconds).message;
    if (client_.hubAge() >= secondsToWait(programsOf(list))) return;
    pause();
    join();
  }
}

std::vector<RunningProgram> HubSession::programs() {
  known_.clear();
  numbers_.clear();
  known_ = programsOf(ask({{"type", "list"}}));
  return known_;
}

std::vector<RunningProgram> HubSession::chosen() {
  const std::vector<RunningProgram> all = programs();
  if (const int64_t expected = client_.hubExpects(); all.empty() && expected > 0)
    throw std::runtime_error((expected == 1
                                  ? "a program runs under GLuRay that has"
                                  : std::to_string(expected) + " programs run under GLuRay that have") +
                             std::string(" not connected to this hub yet; try again after its next frame"));
  return chosenPrograms(all, wanted_);
}

/// The hub has ended: its programs have other numbers at the next one.
void HubSession::joinNext() {
  join();
  waitForPrograms();
  if (!observed_.is_null()) client_.ask(observed_, kAnswerSeconds);
  const std::vector<RunningProgram> now = programsOf(client_.ask({{"type", "list"}}, kListSeconds).message);
  numbers_.clear();
  for (const RunningProgram& before : known_)
    for (const RunningProgram& after : now)
      if (before.pid == after.pid && before.host == after.host && before.name == after.name)
        numbers_[before.number] = after.number;
  for (const RunningProgram& before : known_)
    if (!numbers_.contains(before.number)) numbers_[before.number] = kNoProgram;
}

json HubSession::numbered(json request) const {
  const auto named = request.find("program");
  if (numbers_.empty() || named == request.end() || !named->is_array()) return request;
  for (json& number : *named) {
    const auto found = numbers_.find(number.get<int64_t>());
    if (found == numbers_.end() || found->second == kNoProgram)
      throw std::runtime_error("the hub has ended, and a program has not come to the next one; try again");
    number = found->second;
  }
  return request;
}

json HubSession::ask(const json& request) {
  const std::string type = request["type"];
  const double patience = type == "list" ? kListSeconds : kAnswerSeconds;
  control::Client::Answer answer = client_.ask(numbered(request), patience);
  const bool again = !answer.sent || type == "list" || type == "get" || type == "observe";
  if (!answer.why.empty() && client_.ended() && again && address_.host.empty()) {
    joinNext();
    answer = client_.ask(numbered(request), patience);
  }
  if (!answer.why.empty()) throw std::runtime_error(answer.why);
  if (type == "observe") observed_ = request;
  const auto results = answer.message.find("results");
  if (!numbers_.empty() && results != answer.message.end() && results->is_array())
    for (json& result : *results)
      for (const auto& [before, after] : numbers_)
        if (result.is_object() && result.value("program", json()) == after) {
          result["program"] = before;
          break;
        }
  return std::move(answer.message);
}

void forEachResult(const json& answer, const std::vector<RunningProgram>& programs,
                   const std::function<void(const RunningProgram&, const json&)>& each) {
  static const json none = {{"why", "it does not answer"}};
  const auto results = answer.find("results");
  for (const RunningProgram& program : programs) {
    const json* found = nullptr;
    if (results != answer.end() && results->is_array())
      for (const json& result : *results)
        if (result.is_object() && result.value("program", json()) == program.number) found = &result;
    each(program, found ? *found : none);
  }
}

std::string whyFailed(const json& result) {
  const auto why = result.find("why");
  if (why == result.end()) return "";
  return why->is_string() && !why->get_ref<const std::string&>().empty() ? why->get<std::string>()
                                                                         : "it refuses, and does not say why";
}

}  // namespace gluray::launcher
