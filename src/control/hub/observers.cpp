#include "control/hub/observers.h"

#include "control/messages/members.h"
#include "control/messages/message.h"

#include <algorithm>
#include <utility>

namespace gluray::control {
namespace {

using nlohmann::json;

constexpr std::chrono::milliseconds kListPause{50};  // between two events `programs`

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

Wish Observers::combinedWish(uint64_t program) const {
  Wish wish;
  for (const auto& [connection, client] : clients_) wish.add(client.wishOf(program));
  return wish;
}

void Observers::observe(uint64_t client, const std::vector<uint64_t>& programs, const Wish& wish, bool list) {
  Client& state = clients_[client];
  for (const uint64_t program : programs) state.wishes[program] = wish;
  if (list && !state.list) state.list = true, listIsDue(client, state);
  for (const uint64_t program : programs) wished(program, client);
}

void Observers::observeAll(uint64_t client, const Wish& wish, bool list) {
  Client& state = clients_[client];
  state.wishes.clear();
  state.all = wish;
  state.list = list;
  state.listDue = false;
  if (list) listIsDue(client, state);
  for (const auto& [number, program] : programs_.all()) wished(number, client);
}

/// Updates a client's wish for a program.
void Observers::wished(uint64_t program, uint64_t client) {
  Client& state = clients_[client];
  state.told.erase(program);
  const Wish wish = state.wishOf(program);
  if (!wish.state) state.newest.forget({program, "state"});
  if (!wish.thumbnail) state.newest.forget({program, "thumbnail"});
  if (wish.settings) return ask(program, {client});
  const auto last = asked_.find(program);
  if (last == asked_.end() ? !wish.empty() : !(last->second == combinedWish(program)))
    return ask(program, {});
  // The program does not send a new thumbnail for this client.
  if (const auto known = thumbnails_.find(program); wish.thumbnail && known != thumbnails_.end())
    state.newest.offer({program, "thumbnail"}, known->second, wish.every, questions_.now(), slow(client),
                       [&](uint64_t of, const PeerLink::Line& each) { sendEvent(client, state, of, each); });
}

/// Subscribes to the program for the combined wish. The first event with all settings then goes to `clients`.
void Observers::ask(uint64_t program, std::vector<uint64_t> clients) {
  const Program* entry = programs_.find(program);
  if (!entry || entry->speaker() == 0) return;
  const Wish wish = combinedWish(program);
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
  if (!combinedWish(program).empty()) ask(program, std::move(clients));
}

void Observers::event(const Program& program, const json& message) {
  const auto what = textMember(message, "what", kMaxCharacters);
  if (!what || (*what != "state" && *what != "settings" && *what != "thumbnail")) return;
  json copy = message;
  copy["program"] = program.number;
  std::string text = lineOf(copy);
  if (!whyUnfit(text).empty()) return;
  const auto line = std::make_shared<const std::string>(std::move(text));
  if (*what == "thumbnail" && combinedWish(program.number).thumbnail) thumbnails_[program.number] = line;
  for (auto& [number, client] : clients_) {
    const uint64_t connection = number;
    Client& observer = client;
    const Wish wish = client.wishOf(program.number);
    if (*what == "settings") {
      if (wish.settings && client.told.contains(program.number))
        sendEvent(connection, client, program.number, line);
    } else if (*what == "state" ? wish.state : wish.thumbnail) {
      client.newest.offer(
          {program.number, *what}, line, wish.every, questions_.now(), slow(connection),
          [&](uint64_t of, const PeerLink::Line& each) { sendEvent(connection, observer, of, each); });
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
    if (const auto last = asked_.find(number);
        last != asked_.end() && !(last->second == combinedWish(number)))
      ask(number, {});
}

void Observers::listChanged() {
  listLine_ = nullptr;
  for (auto& [connection, client] : clients_) client.listDue = client.list;
}

void Observers::listIsDue(uint64_t client, Client& state) {
  state.listDue = true;
  if (!slow(client) && state.listAt <= questions_.now()) sendList(client, state);
}

/// Sends the current list.
void Observers::sendList(uint64_t client, Client& state) {
  state.listDue = false;
  state.listAt = questions_.now() + kListPause;
  if (!programs_.all().empty()) state.listed = std::max(state.listed, programs_.all().rbegin()->first);
  if (!listLine_) {
    std::string text = lineOf({{"type", "event"}, {"what", "programs"}, {"programs", programs_.rows()}});
    if (!whyUnfit(text).empty()) return;
    listLine_ = std::make_shared<const std::string>(std::move(text));
  }
  peers_.send(client, listLine_);
}

/// Sends an event. If the client's list lacks the program, sends the list first.
void Observers::sendEvent(uint64_t client, Client& state, uint64_t program, const PeerLink::Line& line) {
  if (state.listDue && program > state.listed) sendList(client, state);
  peers_.send(client, line);
}

void Observers::drained(uint64_t client) {
  const auto found = clients_.find(client);
  if (found == clients_.end() || slow(client)) return;
  Client& state = found->second;
  if (state.listDue && state.listAt <= questions_.now()) sendList(client, state);
  state.newest.flush(
      questions_.now(), [&] { return slow(client); },
      [&](uint64_t program, const PeerLink::Line& line) { sendEvent(client, state, program, line); });
}

void Observers::passed() {
  for (auto& [connection, client] : clients_) drained(connection);
}

HubTime Observers::nextDue() const {
  HubTime next = HubTime::max();
  for (const auto& [connection, client] : clients_) {
    if (peers_.waiting(connection) > kBehind) continue;
    next = std::min(next, client.newest.nextDue());
    if (client.listDue) next = std::min(next, client.listAt);
  }
  return next;
}

}  // namespace gluray::control
