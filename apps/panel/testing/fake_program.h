// For tests: a program behind the hub, as the panel sees it. It answers requests when the event loop runs, or
// only when it is told to.
#pragma once
#include "control/messages/base64.h"
#include "model/controls.h"

#include <QTest>
#include <QTimer>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace gluray::panel {

class FakeProgram {
 public:
  using json = nlohmann::json;
  static constexpr int kNumber = 1;

  std::vector<json> sent;              // all requests of the panel
  std::map<std::string, json> values;  // of calls, by name
  std::map<std::string, std::string> refusals;
  bool answers = true;          // by itself
  int width = 40, height = 30;  // of its window
  Controls controls{[this](json message) { receive(std::move(message)); }};

  void receiveMessage(const json& message) { controls.receiveMessage(std::make_shared<const json>(message)); }

  void appear() {
    receiveMessage(
        {{"type", "event"},
         {"what", "programs"},
         {"programs",
          {{{"program", kNumber}, {"pid", 4242}, {"name", "paraview"}, {"host", "here"}, {"ranks", 1}}}}});
    say("integrator", "local");
    state();
    thumbnail(width, height);
  }
  void end() { receiveMessage({{"type", "event"}, {"what", "programs"}, {"programs", json::array()}}); }

  /// An event `settings`.
  void say(const std::string& name, const json& value, const char* layer = "live") {
    receiveMessage({{"type", "event"},
                    {"what", "settings"},
                    {"program", kNumber},
                    {"values", {{name, {{"value", value}, {"layer", layer}, {"place", ""}}}}},
                    {"undo", 2},
                    {"redo", 0}});
  }
  void state(const json& more = json::object()) {
    json members{{"fps", 24.0},
                 {"triangles", 1234567},
                 {"traced", 0.98},
                 {"windows", {{{"width", width}, {"height", height}}}}};
    members.update(more);
    receiveMessage({{"type", "event"}, {"what", "state"}, {"program", kNumber}, {"state", members}});
  }
  /// An image, the left half of which is red, the right one blue.
  static std::string halves(int columns, int rows) {
    std::string bytes;
    for (int i = 0; i < columns * rows; ++i)
      bytes += i % columns < columns / 2 ? std::string("\xff\0\0", 3) : std::string("\0\0\xff", 3);
    return bytes;
  }
  void thumbnail(int columns, int rows) { thumbnail(columns, rows, halves(columns, rows)); }
  void thumbnail(int columns, int rows, const std::string& bytes) {
    receiveMessage({{"type", "event"},
                    {"what", "thumbnail"},
                    {"program", kNumber},
                    {"width", columns},
                    {"height", rows},
                    {"pixels", control::toBase64(bytes)}});
  }

  /// The requests of that call, also those in batches.
  std::vector<json> calls(const std::string& name) const {
    std::vector<json> found;
    for (const json& message : sent)
      if (message.value("name", "") == name && message["type"] == "call") found.push_back(message);
    return found;
  }
  std::vector<json> sets() const {
    std::vector<json> found;
    for (const json& message : sent)
      if (message["type"] == "set") found.push_back(message);
    return found;
  }
  /// Answers a request of `sent` now.
  void answer(const json& request) {
    json message = answerOf(request);
    message["type"] = "answer";
    message["id"] = request["id"];
    receiveMessage(message);
  }
  void answerValue(const json& request, const json& value) {
    receiveMessage(
        {{"type", "answer"}, {"id", request["id"]}, {"results", {{{"program", kNumber}, {"value", value}}}}});
  }
  /// Until all requests are answered, also those that answers lead to.
  bool settle() {
    return until([this] { return waiting_ == 0; });
  }
  static bool until(const std::function<bool()>& done) { return QTest::qWaitFor(done, 5000); }

 private:
  int waiting_ = 0;  // requests that are still to be answered

  void receive(json message) {
    sent.push_back(message);
    if (answers && message["type"] != "observe" && message["type"] != "list")
      ++waiting_, QTimer::singleShot(0, &controls, [this, message] {
        answer(message);
        --waiting_;
      });
  }
  json answerOf(const json& request) {
    if (request["type"] == "batch") {
      json all = json::array();
      for (const json& one : request["requests"]) {
        sent.push_back(one);
        all.push_back(answerOf(one));
      }
      return {{"answers", all}};
    }
    json result{{"program", kNumber}};
    if (request["type"] == "set") {
      result["frame"] = 7;
      for (const auto& [name, value] : request["values"].items())
        if (!value.is_null()) say(name, value);
    } else if (request["type"] == "call") {
      const std::string name = request["name"];
      if (refusals.contains(name))
        result["why"] = refusals[name];
      else
        result["value"] = values.contains(name) ? values[name] : builtIn(name, request["arguments"]);
    }
    return {{"results", json::array({result})}};
  }
  /// A window's image, ten rows a piece.
  json builtIn(const std::string& name, const json& arguments) const {
    if (name == "shot") return {{"shot", 1}, {"width", width}, {"height", height}, {"frame", 3}};
    if (name != "pixels") return nullptr;
    const int row = arguments["row"], rows = std::min(10, height - row);
    return {{"row", row}, {"rows", rows}, {"pixels", control::toBase64(halves(width, rows))}};
  }
};

inline nlohmann::json fakeObject(int number, const char* color = "#cc4400",
                                 const char* material = "program") {
  return {{"object", number},
          {"view", 1},
          {"shape", number % 3 ? "triangles" : "spheres"},
          {"triangles", 1000 * number},
          {"color", color ? nlohmann::json(color) : nlohmann::json()},
          {"material", material},
          {"hidden", nlohmann::json::array()}};
}

inline nlohmann::json fakeObjects(int count, int version = 1) {
  nlohmann::json list = nlohmann::json::array();
  for (int i = 1; i <= count; ++i) list.push_back(fakeObject(i));
  return {{"frame", 5}, {"version", version}, {"total", count}, {"objects", list}};
}

}  // namespace gluray::panel
