#include "control/hub/observers.h"

#include "control/messages/members.h"
#include "control/messages/message.h"

#include <algorithm>
#include <utility>

namespace gluray::control {
namespace {

using nlohmann::json;

constexpr double kListEvery = 0.05;  // seconds between two events `programs`
constexpr std::chrono::milliseconds kListPause{50};

json wordsOf(const Wish& wish) {
  json words = json::array();
  if (wish.state) words.push_back("state");
  if (wish.settings) words.push_back("settings");
  if (wish.thumbnail) words.push_back("thumbnail");
  return words;
}

}  // namespace

void Wish::add(const Wish& other) {
  if (other.empty()) return;
  state = state || other.state;
  settings = settings || other.settings;
  thumbnail = thumbnail || other.thumbnail;
  size = std::max(size, other.size);
  every = std::min(every, other.every);
}

Wish Observers::Client::wishOf(uint64_t program) const {
  const auto own = wishes.find(program);
  if (own != wishes.end()) return own->second;
  return all.value_or(Wish{});
}

Wish Observers::together(uint64_t program) const {
  Wish wish;
  for (const auto& [connection, client] : clients_) wish.add(client.wishOf(program));
  return wish;
}

void Observers::observe(uint64_t client, const std::vector<uint64_t>& programs, const Wish& wish, bool list) {
  Client& state = clients_[client];
  for (const uint64_t program : programs) state.wishes[program] = wish;
  if (list && !state.list) state.list = true, sendList(client, state, listLine());
  for (const uint64_t program : programs) wished(program, client);
}

void Observers::observeAll(uint64_t client, const Wish& wish, bool list) {
  Client& state = clients_[client];
  state.wishes.clear();
  state.all = wish;
  state.list = list;
  if (list)
    sendList(client, state, listLine());
  else
    state.newest.forget(0);
  for (const auto& [number, program] : programs_.all()) wished(number, client);
}

/// What a client wants of a program may have changed.
void Observers::wished(uint64_t program, uint64_t client) {
  Client& state = clients_[client];
  state.told.erase(program);
  const Wish wish = state.wishOf(program);
  if (!wish.state) state.newest.forget({program, "state"});
  if (!wish.thumbnail) state.newest.forget({program, "thumbnail"});
  if (wish.settings) return ask(program, {client});
  const auto last = asked_.find(program);
  if (last == asked_.end() ? !wish.empty() : !(last->second == together(program))) return ask(program, {});
  // The program sends no thumbnail because of this client.
  if (const auto known = thumbnails_.find(program); wish.thumbnail && known != thumbnails_.end())
    state.newest.offer({program, "thumbnail"}, known->second, wish.every, questions_.now(), slow(client),
                       [&](const PeerLink::Line& each) { peers_.send(client, each); });
}

/// Asks the program for what all want. Then the first event with all settings follows, for `clients`.
void Observers::ask(uint64_t program, std::vector<uint64_t> clients) {
  const Program* entry = programs_.find(program);
  if (!entry || entry->speaker() == 0) return;
  const Wish wish = together(program);
  asked_[program] = wish;
  if (!wish.thumbnail) thumbnails_.erase(program);
  json message{{"type", "observe"}, {"what", wordsOf(wish)}};
  if (!wish.empty()) message["every"] = wish.every;
  if (wish.size > 0) message["size"] = wish.size;
  questions_.askForever(entry->speaker(), std::move(message),
                        [this, program, clients = std::move(clients)](json&&) {
                          if (!programs_.find(program)) return;
                          for (const uint64_t client : clients)
                            if (const auto found = clients_.find(client); found != clients_.end())
                              found->second.told.insert(program);
                        });
}

void Observers::speakerCame(uint64_t program) {
  std::vector<uint64_t> clients;
  for (auto& [connection, client] : clients_) {
    client.told.erase(program);
    if (client.wishOf(program).settings) clients.push_back(connection);
  }
  if (!together(program).empty()) ask(program, std::move(clients));
}

void Observers::event(const Program& program, const json& message) {
  const auto what = textMember(message, "what", kMostCharacters);
  if (!what || (*what != "state" && *what != "settings" && *what != "thumbnail")) return;
  json copy = message;
  copy["program"] = program.number;
  std::string text = lineOf(copy);
  if (!whyUnfit(text).empty()) return;
  const auto line = std::make_shared<const std::string>(std::move(text));
  if (*what == "thumbnail" && together(program.number).thumbnail) thumbnails_[program.number] = line;
  for (auto& [number, client] : clients_) {
    const uint64_t connection = number;
    const Wish wish = client.wishOf(program.number);
    if (*what == "settings") {
      if (wish.settings && client.told.contains(program.number)) peers_.send(connection, line);
    } else if (*what == "state" ? wish.state : wish.thumbnail) {
      client.newest.offer({program.number, *what}, line, wish.every, questions_.now(), slow(connection),
                          [&](const PeerLink::Line& each) { peers_.send(connection, each); });
    }
  }
}

void Observers::programEnded(uint64_t program) {
  asked_.erase(program), thumbnails_.erase(program);
  for (auto& [connection, client] : clients_) {
    client.wishes.erase(program);
    client.told.erase(program);
    client.newest.forget(program);
  }
}

void Observers::clientEnded(uint64_t client) {
  if (clients_.erase(client) == 0) return;
  for (const auto& [number, program] : programs_.all())
    if (const auto last = asked_.find(number); last != asked_.end() && !(last->second == together(number)))
      ask(number, {});
}

void Observers::listChanged() {
  for (const auto& [connection, client] : clients_) listChanged_ = listChanged_ || client.list;
}

PeerLink::Line Observers::listLine() const {
  std::string text = lineOf({{"type", "event"}, {"what", "programs"}, {"programs", programs_.rows()}});
  return whyUnfit(text).empty() ? std::make_shared<const std::string>(std::move(text)) : nullptr;
}

void Observers::sendList(uint64_t client, Client& state, const PeerLink::Line& line) {
  if (line)
    state.newest.offer({0, "programs"}, line, kListEvery, questions_.now(), slow(client),
                       [&](const PeerLink::Line& each) { peers_.send(client, each); });
}

void Observers::sendLists() {
  listChanged_ = false;
  listDue_ = questions_.now() + kListPause;
  PeerLink::Line line;
  for (auto& [connection, client] : clients_)
    if (client.list) sendList(connection, client, line ? line : line = listLine());
}

void Observers::drained(uint64_t client) {
  const auto found = clients_.find(client);
  if (found == clients_.end()) return;
  found->second.newest.flush(
      questions_.now(), [&] { return slow(client); },
      [&](const PeerLink::Line& line) { peers_.send(client, line); });
}

void Observers::passed() {
  if (listChanged_ && listDue_ <= questions_.now()) sendLists();
  for (auto& [connection, client] : clients_) drained(connection);
}

HubTime Observers::next() const {
  HubTime next = listChanged_ ? listDue_ : HubTime::max();
  for (const auto& [connection, client] : clients_)
    if (peers_.waiting(connection) <= kBehind) next = std::min(next, client.newest.next());
  return next;
}

}  // namespace gluray::control
