// The program's side of the connection, with a fake program and a fake clock, for tests.
#pragma once
#include "base/clock.h"
#include "control/link/program_side.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gluray::control::test {

using nlohmann::json;

struct FakeProgram final : ControlledProgram {
  json identity() override { return {{"pid", 7}, {"name", "fake"}}; }
  Figures figures() override { return figures_; }
  json state() override { return {{"memory", 5}}; }
  Called call(const std::string& name, const json& arguments, json& value, std::string& why) override {
    if (name == "late" && !drawn) return Called::later;
    if (name != "double" && name != "late") why = "no call is named " + name;
    if (arguments.contains("of")) value = 2 * arguments["of"].get<int>();
    return Called::done;
  }
  void wake() noexcept override { ++woken; }

  Figures figures_;
  int woken = 0;
  bool drawn = false;  // the call "late" needs this
};

struct ProgramSideTest : testing::Test {
  ProgramSideTest() {
    Sources sources;
    sources.variables.emplace();
    live.start(sources);
    frame();
    side.begin(now);
    receiveMessage({{"type", "hello"}, {"version", 1}, {"role", "hub"}});
    sent.clear();
  }
  /// Draws and shows a frame.
  void frame() {
    source.takeNewer(version), source.beginFrame();
    source.endFrame(), source.takeNewer(version);
  }
  void begin() { source.takeNewer(version), source.beginFrame(); }
  void receiveMessage(const json& message) { side.receiveMessage(message, now); }
  void pass(double seconds) { side.passed(now += seconds); }
  /// The last message.
  json last() const { return sent.empty() ? json() : sent.back(); }
  /// The result of a request that is answered at once.
  json ask(json message) {
    const size_t before = sent.size();
    message["id"] = 1;
    receiveMessage(message);
    return sent.size() == before ? json() : resultOf(sent[before]);
  }
  static json resultOf(const json& message) {
    if (message.contains("why")) return {{"why", message["why"]}};
    return message["results"].empty() ? json::object() : message["results"][0];
  }
  static json setting(const json& values) { return {{"type", "set"}, {"values", values}}; }
  /// Sets values without a frame number, and begins a frame.
  json set(const json& values, const std::string& gesture = "") {
    json message = setting(values);
    message["id"] = 9;
    if (!gesture.empty()) message["gesture"] = gesture;
    receiveMessage(message);
    begin(), pass(0.01), source.endFrame();
    return resultOf(last());
  }
  json step(const char* type) {
    receiveMessage({{"type", type}, {"id", 9}});
    begin(), pass(0.01), source.endFrame();
    return resultOf(last());
  }

  double now = nowSeconds() + 1000;
  SettingsSource source;
  LiveSettings live{source, [](const std::string&) {}};
  uint64_t version = 0;  // the version that a context has
  FakeProgram program;
  std::vector<json> sent;
  std::vector<std::string> finished;
  SettingsHistory history;
  ProgramSide side{program,
                   live,
                   source,
                   history,
                   {[this](const Connection::Line& line) { sent.push_back(json::parse(*line)); },
                    [this](const std::string& why) { finished.push_back(why); }, [this] { return waiting; }}};
  size_t waiting = 0;
};

}  // namespace gluray::control::test
