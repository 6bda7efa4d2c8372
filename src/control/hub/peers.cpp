#include "control/hub/peers.h"

#include "control/messages/message.h"

#include <utility>

namespace gluray::control {

using nlohmann::json;

void Peers::add(uint64_t connection, PeerLink link, HubTime helloLimit) {
  Peer peer;
  peer.link = std::move(link);
  peer.helloLimit = helloLimit;
  peers_.insert_or_assign(connection, std::move(peer));
}

Peer* Peers::find(uint64_t connection) {
  const auto found = peers_.find(connection);
  return found == peers_.end() ? nullptr : &found->second;
}

bool Peers::send(uint64_t to, const json& message) {
  std::string line = lineOf(message);
  if (!whyUnfit(line).empty()) return false;
  send(to, std::make_shared<const std::string>(std::move(line)));
  return true;
}

void Peers::send(uint64_t to, const PeerLink::Line& line) {
  const Peer* peer = find(to);
  if (peer && !peer->finished) peer->link.send(line);
}

void Peers::answer(uint64_t to, const json& id, json&& body) {
  body["type"] = "answer";
  body["id"] = id;
  const std::string line = lineOf(body);
  const std::string why = whyUnfit(line);
  if (why.empty()) return send(to, std::make_shared<const std::string>(line));
  send(to, json{{"type", "answer"}, {"id", id}, {"why", "the answer cannot be sent: " + why}});
}

void Peers::complain(uint64_t to, const std::string& why) { send(to, json{{"type", "error"}, {"why", why}}); }

void Peers::expel(uint64_t connection, const std::string& why) {
  Peer* peer = find(connection);
  if (!peer || peer->finished) return;
  complain(connection, why);
  peer->finished = true;
  peer->link.finish(why);
}

size_t Peers::waiting(uint64_t connection) {
  const Peer* peer = find(connection);
  return peer ? peer->link.waiting() : 0;
}

}  // namespace gluray::control
