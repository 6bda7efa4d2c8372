#include "model/calls.h"

#include "control/messages/members.h"

#include <algorithm>
#include <utility>

namespace gluray::panel {
namespace {

using control::member, control::textIn;
using nlohmann::json;

constexpr size_t kMaxReasonBytes = 400;  // bytes that are shown

std::string whyIn(const json& object) { return textIn(object, "why").substr(0, kMaxReasonBytes); }

/// Of an answer with one result.
CallAnswer answerOf(const json& answer) {
  if (std::string why = whyIn(answer); !why.empty()) return {nullptr, std::move(why)};
  const json* const results = member(answer, "results");
  if (!results || !results->is_array() || results->size() != 1 || !results->front().is_object())
    return {nullptr, "the program's answer cannot be read"};
  const json& result = results->front();
  if (std::string why = whyIn(result); !why.empty()) return {nullptr, std::move(why)};
  const json* const value = member(result, "value");
  return {value ? *value : result, ""};  // of a set: its frame and values
}

std::vector<CallAnswer> answersOf(const json& answer) {
  const json* const answers = member(answer, "answers");
  if (!answers || !answers->is_array()) return {answerOf(answer)};
  std::vector<CallAnswer> all;
  for (const json& one : *answers)
    all.push_back(one.is_object() ? answerOf(one) : CallAnswer{nullptr, "the answer cannot be read"});
  return all;
}

}  // namespace

void Calls::wait(uint64_t id, int program, QObject* receiver, BatchTaker then, bool changes) {
  waiting_[id] = {program, receiver, std::move(then), changes};
}

bool Calls::anyChanges() const {
  return std::any_of(waiting_.begin(), waiting_.end(), [](const auto& call) { return call.second.changes; });
}

bool Calls::receiveAnswer(uint64_t id, const json& answer) {
  const auto found = waiting_.find(id);
  if (found == waiting_.end()) return false;
  const Waiting call = std::move(found->second);
  waiting_.erase(found);  // before it is called: takers make calls of their own
  if (call.receiver) call.then(answersOf(answer));
  return true;
}

void Calls::endOthers(const std::vector<int>& programs, const std::string& why) {
  std::vector<Waiting> ended;
  for (auto call = waiting_.begin(); call != waiting_.end();) {
    const bool stays = std::find(programs.begin(), programs.end(), call->second.program) != programs.end();
    if (!stays) ended.push_back(std::move(call->second));
    call = stays ? std::next(call) : waiting_.erase(call);
  }
  for (const Waiting& call : ended)
    if (call.receiver) call.then({{nullptr, why}});
}

}  // namespace gluray::panel
