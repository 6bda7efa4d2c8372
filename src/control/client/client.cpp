#include "control/client/client.h"

#include "control/messages/members.h"

#include <cmath>
#include <utility>

namespace gluray::control {
namespace {

using nlohmann::json;
using std::chrono::steady_clock;

constexpr int kClientVersion = 1;

std::string refusalOf(const json& message) {
  const std::string why = textIn(message, "why");
  return why.empty() ? "the hub refuses, and does not say why" : why;
}

bool holdsList(const json& message) {
  for (const char* name : {"results", "programs", "answers"})
    if (const auto found = message.find(name); found != message.end() && found->is_array()) return true;
  return false;
}

}  // namespace

Client::Client(asio::io_context& io) : io_(io), self_(std::make_shared<Client*>(this)) {}

Client::~Client() {
  *self_ = nullptr;
  if (connection_) connection_->close("the client ends");
}

bool Client::wait(double seconds, const std::function<bool()>& done) {
  const auto end = steady_clock::now() + std::chrono::microseconds(std::llround(seconds * 1e6));
  while (!done()) {
    if (steady_clock::now() >= end) return false;
    if (io_.stopped()) io_.restart();
    io_.run_one_until(end);
    if (io_.stopped()) return done();  // no handler is left that could change it
  }
  return true;
}

std::string Client::connect(const HubAddress& address, double seconds) {
  close("it connects again");
  whyClosed_.clear(), events_.clear(), greeted_ = reached_ = ended_ = false;
  connectToHub(
      io_, address,
      [self = self_, attempt = ++attempts_](std::shared_ptr<Connection> connection, const std::string& why) {
        Client* client = *self;
        if (!client || client->attempts_ != attempt || !client->whyClosed_.empty()) return;
        if (!connection) return client->close(why.empty() ? "the hub cannot be reached" : why);
        client->start(std::move(connection));
      });
  wait(seconds, [&] { return greeted_ || !whyClosed_.empty(); });
  if (!greeted_) close("the hub does not answer; end it, and start gluray hub");
  return whyClosed_;
}

void Client::start(std::shared_ptr<Connection> connection) {
  connection_ = std::move(connection);
  reached_ = true;
  const auto mine = [self = self_, which = connection_.get()] {
    return *self && (*self)->connection_.get() == which ? *self : nullptr;
  };
  connection_->start({[mine](json&& message) {
                        if (Client* client = mine()) client->receiveMessage(std::move(message));
                      },
                      [mine](const std::string& why) {
                        if (Client* client = mine())
                          client->ended_ = true, client->close("the connection to the hub ended: " + why);
                      },
                      {}});
  connection_->send(json{{"type", "hello"}, {"version", kClientVersion}, {"role", "client"}});
}

void Client::close(const std::string& why) {
  if (!whyClosed_.empty()) return;
  whyClosed_ = why;
  if (const auto connection = std::exchange(connection_, nullptr)) connection->close(why);
}

void Client::takeHello(const json& message) {
  const auto version = message.find("version");
  const bool versioned = version != message.end() && version->is_number_integer();
  if (textIn(message, "type") == "error") return close(refusalOf(message));
  if (textIn(message, "type") != "hello" || textIn(message, "role") != "hub" || !versioned ||
      version->get<int64_t>() < 1)
    return close("what listens there is no hub of GLuRay; end it, and start gluray hub");
  const auto age = message.find("age"), expected = message.find("expected");
  hubAge_ = age != message.end() && age->is_number() && *age >= 0 ? age->get<double>() : kOld;
  hubExpects_ = expected != message.end() && expected->is_number_integer() ? expected->get<int64_t>() : 0;
  hubListensOnTcp_ = isTrue(member(message, "tcp"));
  greeted_ = true;
}

void Client::receiveMessage(json&& message) {
  if (!greeted_) return takeHello(message);
  const std::string type = textIn(message, "type");
  if (type == "event") {
    if (events_.size() >= kMaxEvents) events_.pop_front();
    events_.push_back(std::move(message));
    return;
  }
  if (!waiting_) return;
  const auto id = message.find("id");
  const bool named = id != message.end();
  if (named && (!id->is_number_integer() || id->get<int64_t>() != asked_)) return;  // for an older request
  if (type == "error") {
    answer_ = {{}, refusalOf(message), true};
  } else if (type != "answer" || !named) {
    return;
  } else if (message.contains("why") || !holdsList(message)) {
    answer_ = {{}, message.contains("why") ? refusalOf(message) : "the hub's answer has no results", true};
  } else {
    answer_ = {std::move(message), "", true};
  }
  waiting_ = false;
}

Client::Answer Client::ask(json request, double seconds) {
  if (io_.stopped()) io_.restart();
  io_.poll();  // detects a connection that has ended
  if (!connection_) return {{}, whyClosed_, false};
  request["id"] = ++asked_;
  waiting_ = true;
  connection_->send(request);
  wait(seconds, [&] { return !waiting_ || !connection_; });
  if (!std::exchange(waiting_, false)) return std::exchange(answer_, {});
  if (!connection_) return {{}, whyClosed_, true};
  return {{}, "the hub does not answer; end it, and start gluray hub", true};
}

json Client::awaitEvent(double seconds) {
  interrupted_ = false;
  wait(seconds, [&] { return !events_.empty() || !connection_ || interrupted_; });
  if (events_.empty()) return {};
  json event = std::move(events_.front());
  events_.pop_front();
  return event;
}

}  // namespace gluray::control
