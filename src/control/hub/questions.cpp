#include "control/hub/questions.h"

#include "control/messages/members.h"

#include <cstdio>
#include <limits>
#include <vector>

namespace gluray::control {
namespace {

using nlohmann::json;

/// The result in a program's answer.
json resultOf(const json& answer) {
  if (const json* why = member(answer, "why")) {
    if (why->is_string()) return failure(why->get<std::string>());
  } else if (const json* results = member(answer, "results")) {
    if (results->is_array() && results->empty()) return json::object();
    if (results->is_array() && results->size() == 1 && results->front().is_object()) return results->front();
  }
  return failure("the program's answer is not one of this protocol");
}

std::string patienceText(std::chrono::milliseconds patience) {
  char text[64];
  std::snprintf(text, sizeof text, "it did not answer within %g s",
                static_cast<double>(patience.count()) / 1000);
  return text;
}

}  // namespace

json failure(const std::string& why) { return json{{"why", why}}; }

std::string whyOf(const json& result) {
  const json* why = member(result, "why");
  if (!why) return "";
  return why->is_string() ? why->get<std::string>() : "the program's answer is not one of this protocol";
}

uint64_t Questions::ask(uint64_t program, json message, std::chrono::milliseconds patience, Done done) {
  return add(program, std::move(message), now_ + patience, patienceText(patience), std::move(done));
}

uint64_t Questions::askForever(uint64_t program, json message, Done done) {
  return add(program, std::move(message), HubTime::max(), "", std::move(done));
}

uint64_t Questions::add(uint64_t program, json&& message, HubTime limit, std::string why, Done&& done) {
  const uint64_t id = ++last_;
  message["id"] = id;
  if (!peers_.find(program)) limit = now_, why = "it has ended";
  // The next passed() reports the failure.
  if (!peers_.send(program, message)) limit = now_, why = "the request is too long for one message";
  questions_.emplace(id, Question{program, limit, std::move(why), std::move(done)});
  if (limit != HubTime::max()) limits_.emplace(limit, id);
  return id;
}

void Questions::tell(uint64_t program, json message) {
  message["id"] = ++last_;
  peers_.send(program, message);
}

void Questions::end(uint64_t id, json&& result) {
  const auto found = questions_.find(id);
  if (found == questions_.end()) return;
  limits_.erase({found->second.limit, id});
  const Done done = std::move(found->second.done);
  questions_.erase(found);
  done(std::move(result));
}

void Questions::answered(uint64_t program, const json& message) {
  const auto id = wholeNumber(member(message, "id"), 1, std::numeric_limits<int64_t>::max());
  if (!id) return;
  const auto found = questions_.find(static_cast<uint64_t>(*id));
  if (found == questions_.end() || found->second.program != program) return;
  end(found->first, resultOf(message));
}

void Questions::ended(uint64_t program) {
  std::vector<uint64_t> ids;
  for (const auto& [id, question] : questions_)
    if (question.program == program) ids.push_back(id);
  for (const uint64_t id : ids) end(id, failure("it has ended"));
}

void Questions::passed() {
  while (!limits_.empty() && limits_.begin()->first <= now_) {
    const uint64_t id = limits_.begin()->second;
    end(id, failure(questions_.at(id).why));
  }
}

}  // namespace gluray::control
