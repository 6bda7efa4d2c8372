#include "control/hub/requests.h"

#include "control/messages/members.h"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

namespace gluray::control {
namespace {

using nlohmann::json;

constexpr const char* kHowToName = "program: use a number, a list of numbers, or \"all\"";

/// Results of several programs, in the order of the client's request.
struct Gathered {
  json results = json::array();
  size_t missing = 0;
  Requests::Done done;

  void take(size_t at, uint64_t program, json&& result) {
    result["program"] = program;
    results[at] = std::move(result);
    if (--missing == 0) done(json{{"results", std::move(results)}});
  }
};

std::shared_ptr<Gathered> gather(size_t count, Requests::Done&& done) {
  auto gathered = std::make_shared<Gathered>();
  gathered->results = json(count, json::object());
  gathered->missing = count;
  gathered->done = std::move(done);
  return gathered;
}

json noResults() { return json{{"results", json::array()}}; }

bool areTexts(const json& list) {
  return list.is_array() &&
         std::all_of(list.begin(), list.end(), [](const json& word) { return word.is_string(); });
}

/// The error in a request that is forwarded to programs; empty if it is valid.
std::string mistakeIn(const std::string& type, const json& request) {
  const json* values = member(request, "values");
  const json* gesture = member(request, "gesture");
  if (type == "set" && (!values || !values->is_object()))
    return "values: use an object with names and values";
  if (type == "set" && gesture && !isText(gesture)) return "gesture: use a text of at most 64 characters";
  const json* names = member(request, "names");
  if (type == "get" && names && !areTexts(*names)) return "names: use a list of names";
  const json* layers = member(request, "layers");
  if (type == "get" && layers && !layers->is_boolean()) return "layers: use true or false";
  const json* arguments = member(request, "arguments");
  if (type == "call" && !isText(member(request, "name"))) return "name: use a text of at most 64 characters";
  if (type == "call" && arguments && !arguments->is_object()) return "arguments: use an object";
  return "";
}

/// The request without the members that only the hub needs.
json forProgram(const std::string& type, const json& request) {
  json message{{"type", type}};
  for (const char* name : {"names", "layers", "name", "arguments"})
    if (const json* value = member(request, name)) message[name] = *value;
  if (type == "call" && !message.contains("arguments")) message["arguments"] = json::object();
  return message;
}

bool oneOf(const std::string& type, std::initializer_list<const char*> types) {
  return std::find(types.begin(), types.end(), type) != types.end();
}

}  // namespace

Requests::Chosen Requests::chosen(const json& request) {
  Chosen chosen;
  const json* named = member(request, "program");
  if (named && *named == "all") {
    chosen.all = true;
    for (const auto& [number, program] : programs_.all()) chosen.programs.push_back(number);
    return chosen;
  }
  if (!named || !(named->is_array() || named->is_number())) return chosen.why = kHowToName, chosen;
  const json list = named->is_array() ? *named : json::array({*named});
  std::set<uint64_t> seen;
  for (const json& each : list) {
    if (!each.is_number()) return chosen.why = kHowToName, chosen;
    const auto number = wholeNumber(&each, 1, kMaxFrame);
    if (!number || !programs_.find(static_cast<uint64_t>(*number)))
      return chosen.why = "no program has number " + each.dump() + "; gluray list shows them", chosen;
    if (seen.insert(static_cast<uint64_t>(*number)).second)
      chosen.programs.push_back(static_cast<uint64_t>(*number));
  }
  return chosen;
}

void Requests::carryOut(uint64_t client, const json& request, Done done) {
  const json* type = member(request, "type");
  if (!type || !type->is_string()) return done(failure("the request has no type"));
  const auto& name = type->get_ref<const std::string&>();
  if (name == "list") return done(json{{"programs", programs_.rows()}});
  if (name == "batch") return batch(client, request, std::move(done));
  if (!oneOf(name, {"get", "describe", "call", "set", "undo", "redo", "observe"}))
    return done(failure(
        "no request has type " +
        (isText(type) ? type->dump(-1, ' ', false, json::error_handler_t::replace) : "of that length")));
  carryOutFor(client, name, request, std::move(done));
}

void Requests::carryOutFor(uint64_t client, const std::string& type, const json& request, Done done) {
  const Chosen named = chosen(request);
  if (!named.why.empty()) return done(failure(named.why));
  if (const std::string why = mistakeIn(type, request); !why.empty()) return done(failure(why));
  if (type == "observe") return observe(client, request, named, done);
  if (named.programs.empty()) return done(noResults());
  if (oneOf(type, {"set", "undo", "redo"})) return change(client, type, request, named, std::move(done));
  passOn(forProgram(type, request), named, std::move(done));
}

void Requests::change(uint64_t client, const std::string& type, const json& request, const Chosen& chosen,
                      Done done) {
  ChangeRequest asked{type, client, "", json::object()};
  if (type == "set") asked.values = *member(request, "values");
  if (type == "set") asked.gesture = textMember(request, "gesture", kMaxCharacters, "").value_or("");
  const auto gathered = gather(chosen.programs.size(), std::move(done));
  for (size_t i = 0; i < chosen.programs.size(); ++i) {
    const uint64_t program = chosen.programs[i];
    changes_.add(program, asked,
                 [gathered, i, program](json&& result) { gathered->take(i, program, std::move(result)); });
  }
}

void Requests::passOn(json message, const Chosen& chosen, Done done) {
  const auto gathered = gather(chosen.programs.size(), std::move(done));
  for (size_t i = 0; i < chosen.programs.size(); ++i) {
    const uint64_t number = chosen.programs[i];
    const Program* program = programs_.find(number);
    const uint64_t speaker = program ? program->speaker() : 0;
    const auto take = [gathered, i, number](json&& result) { gathered->take(i, number, std::move(result)); };
    if (speaker != 0)
      questions_.ask(speaker, message, kPatience, take);
    else
      take(failure("rank 0 of the job is not connected"));
  }
}

void Requests::observe(uint64_t client, const json& request, const Chosen& chosen, const Done& done) {
  const json* what = member(request, "what");
  Wish wish;
  bool list = false, known = what && what->is_array();
  for (size_t i = 0; known && i < what->size(); ++i) {
    const json& word = (*what)[i];
    wish.state = wish.state || word == "state";
    wish.settings = wish.settings || word == "settings";
    wish.thumbnail = wish.thumbnail || word == "thumbnail";
    list = list || word == "programs";
    known =
        word.is_string() && oneOf(word.get<std::string>(), {"state", "settings", "thumbnail", "programs"});
  }
  if (!known) return done(failure("what: use a list of state, settings, programs, thumbnail"));
  wish.every = 1;
  if (const json* every = member(request, "every")) {
    if (!every->is_number() ||
        !(every->get<double>() >= kMinInterval && every->get<double>() <= kMaxInterval))
      return done(failure("every: use a number of seconds from 0.05 to 3600"));
    wish.every = every->get<double>();
  }
  if (wish.thumbnail) wish.size = kUsualSize;
  if (const json* size = member(request, "size")) {
    const auto pixels = wholeNumber(size, kMinSize, kMaxSize);
    if (!pixels) return done(failure("size: use a number of pixels from 16 to 512"));
    if (wish.thumbnail) wish.size = static_cast<int>(*pixels);
  }
  done(noResults());
  if (chosen.all) return observers_.observeAll(client, wish, list);
  observers_.observe(client, chosen.programs, wish, list);
}

namespace {

/// The requests of a batch, carried out one after the other.
struct Batch : std::enable_shared_from_this<Batch> {
  Requests* requests = nullptr;
  uint64_t client = 0;
  json list, answers = json::array();
  Requests::Done done;
  bool inside = false, answered = false;

  /// Uses a loop, not recursion, for requests that are answered at once.
  void next() {
    if (inside) return;
    inside = true;
    for (answered = true; answered && answers.size() < list.size();) {
      answered = false;
      const json& request = list[answers.size()];
      const json* type = member(request, "type");
      const auto take = [self = shared_from_this()](json&& body) {
        self->answers.push_back(std::move(body));
        self->answered = true;
        self->next();
      };
      if (type && *type == "batch")
        take(failure("a batch within a batch"));
      else
        requests->carryOut(client, request, take);
    }
    inside = false;
    if (answers.size() < list.size()) return;
    if (const auto last = std::exchange(done, nullptr)) last(json{{"answers", std::move(answers)}});
  }
};

}  // namespace

void Requests::batch(uint64_t client, const json& request, Done done) {
  const json* list = member(request, "requests");
  if (!list || !list->is_array() || list->size() > kMaxBatchSize)
    return done(failure("requests: use a list of at most 256 requests"));
  const auto batch = std::make_shared<Batch>();
  batch->requests = this;
  batch->client = client;
  batch->list = *list;
  batch->done = std::move(done);
  batch->next();
}

}  // namespace gluray::control
