#include "control/hub/hub_core.h"

#include "control/messages/members.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

namespace gluray::control {
namespace {

using nlohmann::json;

/// Text that no other hub has.
std::string uniqueText(const HubCore::Self& self) {
  return self.host + " " + std::to_string(self.pid) + " " + std::to_string(self.secondsAtZero);
}

/// Seconds since 1970, rounded to milliseconds.
double calendarTime(double secondsAtZero, HubTime now) {
  constexpr double kMillis = 1000;
  const double seconds = secondsAtZero + std::chrono::duration<double>(now.time_since_epoch()).count();
  return std::round(seconds * kMillis) / kMillis;
}

}  // namespace

HubCore::HubCore(Self self)
    : self_(std::move(self)),
      questions_(peers_),
      changes_(programs_, questions_, uniqueText(self_)),
      observers_(peers_, programs_, questions_),
      requests_(programs_, questions_, changes_, observers_) {}

void HubCore::connected(uint64_t connection, PeerLink link, HubTime now, const Beginning& beginning) {
  questions_.setNow(now);
  peers_.add(connection, std::move(link), now + kHelloPatience);
  peers_.send(connection, json{{"type", "hello"},
                               {"version", kProtocolVersion},
                               {"role", "hub"},
                               {"pid", self_.pid},
                               {"host", self_.host},
                               {"expected", beginning.expected},
                               {"age", beginning.age},
                               {"tcp", beginning.tcp}});
}

void HubCore::received(uint64_t connection, const json& message, HubTime now) {
  questions_.setNow(now);
  Peer* peer = peers_.find(connection);
  if (!peer || peer->finished) return;
  const auto type = textMember(message, "type", kMaxCharacters);
  if (peer->role == Role::unknown) {
    hello(connection, *peer, message);
  } else if (type == "hello") {
    peers_.complain(connection, "hello comes once");
  } else if (peer->role == Role::client) {
    fromClient(connection, *peer, message);
  } else {
    fromProgram(connection, type.value_or(""), message);
  }
  due();
}

void HubCore::hello(uint64_t connection, Peer& peer, const json& message) {
  const json* type = member(message, "type");
  if (!type || *type != "hello") return peers_.expel(connection, "the first message must be hello");
  if (!wholeNumber(member(message, "version"), 1, kMaxFrame))
    return peers_.expel(connection, "hello: version: a whole number from 1");
  const auto role = textMember(message, "role", kMaxCharacters);
  if (role == "client") return void(peer.role = Role::client);
  if (role != "program") return peers_.expel(connection, "hello: role: program or client");
  const auto read = programHello(message);
  if (const auto* why = std::get_if<std::string>(&read)) return peers_.expel(connection, "hello: " + *why);
  peer.role = Role::program;
  const Program& program = programs_.add(connection, std::get<ProgramHello>(read),
                                         calendarTime(self_.secondsAtZero, questions_.now()));
  observers_.listChanged();
  if (program.speaker() == connection) observers_.speakerCame(program.number);
}

void HubCore::fromProgram(uint64_t connection, const std::string& type, const json& message) {
  if (type == "answer") return questions_.answered(connection, message);
  if (type == "error") return;  // an answer to it could be answered in turn
  if (type != "event")
    return peers_.complain(connection, "a program sends hello, answer, event and error only");
  const Program* program = programs_.ofConnection(connection);
  if (program && program->speaker() == connection) observers_.event(*program, message);
}

void HubCore::fromClient(uint64_t connection, Peer& peer, const json& message) {
  const json* type = member(message, "type");
  if (type && *type == "error") return;
  const json* named = member(message, "id");
  if (!isId(named))
    return peers_.complain(connection, "a request needs an id: a number, or a text of at most 64 characters");
  const json id = *named;
  const std::string text = id.dump();
  if (peer.ids.contains(text))
    return peers_.complain(connection, "a request with this id waits for its answer");
  if (peer.ids.size() >= kMaxRequests)
    return peers_.answer(connection, id, failure("256 requests wait for answers; wait for some of them"));
  peer.ids.insert(text);
  requests_.carryOut(connection, message, [this, connection, id, text](json&& body) {
    if (Peer* asking = peers_.find(connection)) asking->ids.erase(text);
    peers_.answer(connection, id, std::move(body));
  });
}

void HubCore::disconnected(uint64_t connection, HubTime now) {
  questions_.setNow(now);
  const Peer* peer = peers_.find(connection);
  if (!peer) return;
  const Role role = peer->role;
  peers_.remove(connection);
  if (role == Role::client) observers_.clientEnded(connection);
  if (role == Role::program) {
    const Programs::Removed removed = programs_.remove(connection);
    observers_.listChanged();
    if (removed.gone) observers_.programEnded(removed.number), changes_.ended(removed.number);
    questions_.ended(connection);
  }
  due();
}

void HubCore::drained(uint64_t connection, HubTime now) {
  questions_.setNow(now);
  observers_.drained(connection);
}

void HubCore::passed(HubTime now) {
  questions_.setNow(now);
  due();
}

size_t HubCore::clients() const {
  return static_cast<size_t>(std::count_if(peers_.all().begin(), peers_.all().end(), [](const auto& peer) {
    return peer.second.role != Role::program;
  }));
}

void HubCore::due() {
  std::vector<uint64_t> silent;
  for (const auto& [connection, peer] : peers_.all())
    if (peer.role == Role::unknown && !peer.finished && peer.helloLimit <= questions_.now())
      silent.push_back(connection);
  for (const uint64_t connection : silent) peers_.expel(connection, "no hello came within 5 s");
  changes_.passed();  // before overdue answers let further changes begin
  questions_.passed();
  observers_.passed();
}

HubTime HubCore::nextDue() {
  HubTime next = std::min({questions_.nextDue(), changes_.nextDue(), observers_.nextDue()});
  for (const auto& [connection, peer] : peers_.all())
    if (peer.role == Role::unknown && !peer.finished) next = std::min(next, peer.helloLimit);
  return next;
}

}  // namespace gluray::control
