#include "control/hub/programs.h"

#include "control/messages/members.h"

#include <algorithm>
#include <limits>

namespace gluray::control {
namespace {

using nlohmann::json;

constexpr size_t kMaxNameCharacters = 255;
constexpr int kMaxInt = std::numeric_limits<int>::max();

/// An integer; `otherwise` if it is missing.
std::optional<int> intMember(const json& message, const char* name, int least, int most, int otherwise) {
  const json* value = member(message, name);
  if (!value) return otherwise;
  const auto number = wholeNumber(value, least, most);
  if (!number) return std::nullopt;
  return static_cast<int>(*number);
}

}  // namespace

std::variant<ProgramHello, std::string> programHello(const json& message) {
  const auto pid = wholeNumber(member(message, "pid"), 1, kMaxInt);
  if (!pid) return "pid: a whole number above 0";
  const auto host = textMember(message, "host", kMaxNameCharacters);
  const auto name = textMember(message, "name", kMaxNameCharacters);
  const auto job = textMember(message, "job", kMaxNameCharacters, "");
  if (!host || !name || !job) return "host, name and job: texts of at most 255 characters";
  const auto ranks = intMember(message, "ranks", 1, kMaxRanks, 1);
  if (!ranks) return "ranks: a whole number from 1 to " + std::to_string(kMaxRanks);
  const auto rank = intMember(message, "rank", 0, *ranks - 1, 0);
  if (!rank) return "rank: a whole number from 0 to ranks - 1";
  const auto version = wholeNumber(member(message, "version"), 1, kMaxFrame);
  const int common = static_cast<int>(std::min<int64_t>(version.value_or(1), kProtocolVersion));
  const json* const since = member(message, "since");
  if (since && !(since->is_number() && *since >= 0 && *since <= kMaxFrame))
    return "since: seconds since 1970";
  return ProgramHello{common, static_cast<int>(*pid),          *host, *name, *job, *rank,
                      *ranks, since ? since->get<double>() : 0};
}

uint64_t Program::speaker() const {
  const auto first = members.find(0);
  return first == members.end() ? 0 : first->second.connection;
}

json Program::row() const {
  const ProgramHello& first = members.begin()->second.hello;
  return {{"program", number}, {"pid", first.pid}, {"host", first.host},       {"name", first.name},
          {"ranks", ranks},    {"since", since},   {"version", first.version}, {"connected", members.size()}};
}

Program& Programs::add(uint64_t connection, const ProgramHello& hello, double since) {
  bool inJob = !hello.job.empty();
  auto entry = programs_.end();
  if (inJob) {
    entry = std::find_if(programs_.begin(), programs_.end(),
                         [&](const auto& other) { return other.second.job == hello.job; });
    inJob = entry == programs_.end() ||
            (entry->second.ranks == hello.ranks && !entry->second.members.contains(hello.rank));
  }
  if (entry == programs_.end() || !inJob) {
    Program made;
    made.number = ++last_;
    made.since = hello.since > 0 ? hello.since : since;
    if (inJob) made.job = hello.job, made.ranks = hello.ranks;
    entry = programs_.emplace(made.number, std::move(made)).first;
  }
  // Outside a job, a program speaks for itself whatever its rank is.
  entry->second.members.emplace(inJob ? hello.rank : 0, Program::Member{connection, hello});
  numbers_[connection] = entry->first;
  return entry->second;
}

Programs::Removed Programs::remove(uint64_t connection) {
  const auto found = numbers_.find(connection);
  if (found == numbers_.end()) return {};
  Removed removed{found->second, false, false};
  numbers_.erase(found);
  Program& program = programs_.at(removed.number);
  removed.wasSpeaker = program.speaker() == connection;
  std::erase_if(program.members, [&](const auto& rank) { return rank.second.connection == connection; });
  removed.gone = program.members.empty();
  if (removed.gone) programs_.erase(removed.number);
  return removed;
}

Program* Programs::find(uint64_t number) {
  const auto found = programs_.find(number);
  return found == programs_.end() ? nullptr : &found->second;
}

Program* Programs::ofConnection(uint64_t connection) {
  const auto found = numbers_.find(connection);
  return found == numbers_.end() ? nullptr : find(found->second);
}

json Programs::rows() const {
  json rows = json::array();
  for (const auto& [number, program] : programs_) rows.push_back(program.row());
  return rows;
}

bool Programs::hasProcess(const std::string& host, int pid) const {
  for (const auto& [number, program] : programs_)
    for (const auto& [rank, one] : program.members)
      if (one.hello.pid == pid && one.hello.host == host) return true;
  return false;
}

}  // namespace gluray::control
