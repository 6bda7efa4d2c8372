#include "control/link/program_side.h"

#include "control/messages/members.h"
#include "control/messages/value.h"
#include "settings/values.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace gluray::control {
namespace {

using nlohmann::json;

constexpr int kVersion = 1;

json descriptions() {
  json rows = json::array();
  for (const Row& row : settingRows())
    if (row.inFiles) rows.push_back(description(row));
  return rows;
}

}  // namespace

ProgramSide::ProgramSide(ControlledProgram& program, LiveSettings& live, const SettingsSource& source,
                         SettingsHistory& history, Peer peer)
    : program_(program),
      live_(live),
      peer_(std::move(peer)),
      waker_(program, source),
      changes_(
          live, source, history, [this] { waker_.wake(); },
          [this](const json& id, json result) { answer(id, std::move(result)); }),
      observed_(program, live, source, [this](const json& event) { send(event); }),
      images_(
          program, source, waker_, [this](const json& id, json result) { answer(id, std::move(result)); },
          [this](const json& event) { send(event); }),
      calls_(program, source, waker_,
             [this](const json& id, json result) { answer(id, std::move(result)); }) {}

void ProgramSide::begin(double now) {
  helloBy_ = now + kHelloSeconds;
  json hello = program_.identity();
  hello["type"] = "hello", hello["version"] = kVersion, hello["role"] = "program";
  send(hello);
}

void ProgramSide::send(const json& message) {
  const Connection::Line line = sharedLine(message);
  if (line->size() <= kMaxBytes) return peer_.send(line);
  if (const json* const id = member(message, "id"); isId(id))
    answer(*id, {{"why", "the answer is longer than 1 MiB"}});
}

void ProgramSide::error(const std::string& why) { send({{"type", "error"}, {"why", why}}); }

void ProgramSide::answer(const json& id, json result) {
  json message{{"type", "answer"}, {"id", id}};
  if (const auto why = result.find("why"); why != result.end())
    message["why"] = *why;
  else
    message["results"] = result.empty() ? json::array() : json::array({std::move(result)});
  send(message);
}

void ProgramSide::greet(const std::string& type, const json& message) {
  greeted_ = type == "hello" && wholeNumber(member(message, "version"), 1, kMaxFrame);
  if (greeted_) return;
  const std::string why =
      type == "hello" ? "this version is not supported" : "the first message must be hello";
  error(why);
  peer_.finish(why);
}

void ProgramSide::receiveMessage(const json& message, double now) {
  const std::string type = textMember(message, "type", kMaxCharacters).value_or("");
  if (!greeted_) return greet(type, message);
  if (type == "hello" || type == "answer" || type == "event" || type == "error") return;
  const json* const id = member(message, "id");
  if (!isId(id)) return error("a request needs an id: a number or a short text");
  try {
    carryOut(type, *id, message, now);
  } catch (const std::exception& e) { answer(*id, {{"why", std::string("it failed: ") + e.what()}}); }
}

void ProgramSide::carryOut(const std::string& type, const json& id, const json& message, double now) {
  if (ChangeRequests::knows(type))
    changes_.receiveRequest(type, id, message, now);
  else if (type == "get")
    answer(id, valuesOf(member(message, "names"), isTrue(member(message, "layers"))));
  else if (type == "describe")
    answer(id, {{"settings", descriptions()}});
  else if (type == "observe")
    observe(id, message, now);
  else if (type == "call")
    call(id, message, now);
  else
    answer(id, {{"why", "programs do not know the request '" + type + "'"}});
  passed(now);
}

json ProgramSide::valuesOf(const json* names, bool withLayers) {
  const bool all = !names || names->is_null() || (names->is_array() && names->empty());
  if (!all && !names->is_array()) return {{"why", "names must be a list"}};
  json found = json::object();
  for (const LiveSettings::Value& value : live_.values())
    if (all || std::find(names->begin(), names->end(), value.row->name) != names->end())
      found[std::string(value.row->name)] = described(value);
  if (withLayers) {
    const Layers layers = live_.layers();
    for (auto& [name, value] : found.items()) value["layers"] = layersOf(layers, *findSetting(name));
  }
  if (!all)
    for (const json& name : *names) {
      if (!name.is_string()) return {{"why", "names must be texts"}};
      if (const auto& text = name.get_ref<const std::string&>(); !found.contains(text))
        return {{"why", unknownSetting(text.substr(0, ChangeRequests::kMaxNameBytes))}};
    }
  return {{"values", std::move(found)}};
}

void ProgramSide::observe(const json& id, const json& message, double now) {
  json result = observed_.observeRequested(message, now);
  if (!result.contains("why")) images_.observe(observed_.thumbnails(), now);
  answer(id, std::move(result));
}

void ProgramSide::call(const json& id, const json& message, double now) {
  const auto name = textMember(message, "name", kMaxCharacters);
  const json* const given = member(message, "arguments");
  if (!name) return answer(id, {{"why", "name must be a short text"}});
  if (given && !given->is_object()) return answer(id, {{"why", "arguments must be an object"}});
  const json arguments = given ? *given : json::object();
  if (ImageRequests::knows(*name)) return images_.startCall(*name, id, arguments, now);
  calls_.startCall(*name, id, arguments, now);
}

void ProgramSide::passed(double now) {
  if (!greeted_) {
    if (now >= helloBy_) peer_.finish("the hub does not say hello");
    return;
  }
  changes_.passed(now);
  const bool slow = peer_.waiting() > kMuchWaiting;
  observed_.passed(changes_.history(), slow, now);
  calls_.passed(now);
  waker_.passed(now);
  images_.passed(slow, now);
}

double ProgramSide::nextDue(double now) const {
  return greeted_ ? std::min({changes_.nextDue(now), observed_.nextDue(), images_.nextDue(now),
                              calls_.nextDue(now), waker_.nextDue(now)})
                  : helloBy_;
}

}  // namespace gluray::control
