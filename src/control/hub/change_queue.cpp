#include "control/hub/change_queue.h"

#include "base/hash.h"
#include "control/hub/job_change.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace gluray::control {
namespace {

using nlohmann::json;

constexpr const char* kNoTurn =
    "its turn did not come within 3 s: the program has not answered earlier requests";

/// Whether a `set` can be merged with one that waits.
bool sameGesture(const ChangeRequest& a, const ChangeRequest& b) {
  return a.type == "set" && b.type == "set" && a.client == b.client && !a.gesture.empty() &&
         a.gesture == b.gesture;
}

/// Why a program cannot be changed now; empty if it can.
std::string whyNotReady(const Program* program) {
  if (!program) return "it has ended";
  if (program->complete()) return "";
  return "only " + std::to_string(program->members.size()) + " of the job's " +
         std::to_string(program->ranks) + " ranks are connected";
}

}  // namespace

void ChangeQueue::add(uint64_t program, ChangeRequest request, Questions::Done done) {
  Line& line = lines_[program];
  Part part{std::move(request.values), questions_.now() + kSetPatience, std::move(done)};
  if (!line.waiting.empty() && !line.waiting.back().alone &&
      sameGesture(line.waiting.back().request, request)) {
    line.waiting.back().parts.push_back(std::move(part));
  } else {
    Change change{std::move(request), {}, false};
    change.parts.push_back(std::move(part));
    line.waiting.push_back(std::move(change));
  }
  if (!line.current) begin(program);
}

json ChangeQueue::messageOf(const Change& change) const {
  json message{{"type", change.request.type}};
  if (change.request.type != "set") return message;
  json& values = message["values"] = json::object();
  for (const Part& part : change.parts) values.update(part.values);
  if (!change.request.gesture.empty()) message["gesture"] = gestureName(change.request);
  return message;
}

std::string ChangeQueue::gestureName(const ChangeRequest& request) const {
  const std::string text = self_ + " " + std::to_string(request.client) + " " + request.gesture;
  const Hash128 hash = hashBytes(text.data(), text.size());
  char name[40];
  std::snprintf(name, sizeof name, "%016llx%016llx", static_cast<unsigned long long>(hash.high),
                static_cast<unsigned long long>(hash.low));
  return name;
}

void ChangeQueue::begin(uint64_t program) {
  while (true) {
    const auto found = lines_.find(program);
    if (found == lines_.end() || found->second.current) return;
    Line& line = found->second;
    if (line.waiting.empty()) return void(lines_.erase(found));
    Change change = std::move(line.waiting.front());
    line.waiting.pop_front();
    const Program* entry = programs_.find(program);
    if (const std::string why = whyNotReady(entry); why.empty()) {
      line.current = std::move(change);
      return send(*entry);
    } else {
      for (const Part& part : change.parts) part.done(failure(why));
    }
  }
}

void ChangeQueue::send(const Program& entry) {
  const auto done = [this, program = entry.number](json&& result) { finished(program, std::move(result)); };
  const json message = messageOf(*lines_.at(entry.number).current);
  if (entry.ranks == 1) return void(questions_.ask(entry.speaker(), message, kSetPatience, done));
  std::map<int, uint64_t> ranks;
  for (const auto& [rank, one] : entry.members) ranks[rank] = one.connection;
  changeJob(questions_, ranks, message, done);
}

void ChangeQueue::finished(uint64_t program, json&& result) {
  const auto found = lines_.find(program);
  if (found == lines_.end() || !found->second.current) return;
  Change change = std::move(*found->second.current);
  found->second.current.reset();
  const bool split = !whyOf(result).empty() && change.parts.size() > 1;
  if (split) {
    // One of the merged requests may be wrong: each is sent alone, in order. Requests that have waited too
    // long fail, and not for the error of another request.
    std::vector<Part> parts = std::exchange(change.parts, {});
    for (size_t i = parts.size(); i-- > 0;) {
      if (parts[i].limit <= questions_.now()) {
        change.parts.insert(change.parts.begin(), std::move(parts[i]));
        continue;
      }
      Change single{change.request, {}, true};
      single.parts.push_back(std::move(parts[i]));
      found->second.waiting.push_front(std::move(single));
    }
  }
  if (split) result = failure(kNoTurn);
  begin(program);
  for (const Part& part : change.parts) part.done(json(result));
}

// Waiting requests are ordered by their newest parts, so the first one's time limit is the first to pass.
void ChangeQueue::passed() {
  std::vector<Part> late;
  for (auto& [program, line] : lines_)
    while (!line.waiting.empty() && line.waiting.front().parts.back().limit <= questions_.now()) {
      for (Part& part : line.waiting.front().parts) late.push_back(std::move(part));
      line.waiting.pop_front();
    }
  for (const Part& part : late) part.done(failure(kNoTurn));
}

HubTime ChangeQueue::nextDue() const {
  HubTime next = HubTime::max();
  for (const auto& [program, line] : lines_)
    if (!line.waiting.empty()) next = std::min(next, line.waiting.front().parts.back().limit);
  return next;
}

void ChangeQueue::ended(uint64_t program) {
  const auto found = lines_.find(program);
  if (found == lines_.end()) return;
  const std::deque<Change> waiting = std::exchange(found->second.waiting, {});
  if (!found->second.current) lines_.erase(found);
  for (const Change& change : waiting)
    for (const Part& part : change.parts) part.done(failure("it has ended"));
}

}  // namespace gluray::control
