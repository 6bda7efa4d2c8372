#include "control/hub_session.h"

#include "control/runtime_directory.h"
#include "say.h"
#include "settings/settings_list.h"
#include "settings/values.h"
#include "wake/wake.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace gluray::launcher {
namespace {

using nlohmann::json;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr double kConnectSeconds = 5, kListSeconds = 5;
// More than the hub gives a program: then it says which one does not answer.
constexpr double kAnswerSeconds = 12;
// Programs look for a hub when a frame begins, at most every 50 ms. Those that draw nothing are woken.
constexpr milliseconds kLeast{120}, kMost{1000};

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

HubSession::HubSession(const CommandLine& line) {
  const control::HubAddress address = addressOf(line);
  std::string why = client_.connect(address, kConnectSeconds);
  if (why.empty()) return;
  if (client_.reached() || !address.host.empty()) throw std::runtime_error(why);
  beHub(address.directory);
  why = client_.connect(address, kConnectSeconds);
  if (!why.empty()) throw std::runtime_error(why);
}

void HubSession::beHub(const std::string& directory) {
  control::HubOptions options;
  options.directory = directory;
  options.wake = wakeWindow;
  const std::string why = hub_.start(options);
  if (hub_.otherHubRuns()) return;  // it has begun since
  if (!why.empty()) throw std::runtime_error(why);
  const auto begin = steady_clock::now();
  for (auto now = begin; now < begin + kMost; now = steady_clock::now()) {
    if (now >= begin + kLeast && hub_.expected() == 0 && hub_.programs() > 0) return;
    if (io_.stopped()) io_.restart();
    io_.run_one_for(milliseconds(20));
  }
}

std::vector<RunningProgram> HubSession::programs() { return programsOf(ask({{"type", "list"}})); }

json HubSession::ask(const json& request) {
  control::Client::Answer answer =
      client_.ask(request, request["type"] == "list" ? kListSeconds : kAnswerSeconds);
  if (!answer.why.empty()) throw std::runtime_error(answer.why);
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
