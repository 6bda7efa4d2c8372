// A hub with fake peers that record what they receive, for tests.
#pragma once
#include "control/hub/hub_core.h"
#include "control/messages/members.h"
#include "control/messages/parsed.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gluray::control::test {

using nlohmann::json;
using std::chrono::milliseconds;

/// One end of a connection, which records what the hub has sent to it.
struct FakePeer {
  uint64_t connection = 0;
  std::vector<json> got;
  size_t waiting = 0;    // reported to the hub
  std::string finished;  // reason why the hub closed it

  /// Removes and returns the messages of a type.
  std::vector<json> takeMessages(const std::string& type) {
    std::vector<json> found, rest;
    for (json& message : got) (message["type"] == type ? found : rest).push_back(std::move(message));
    got = std::move(rest);
    return found;
  }
  /// The only message of a type, which is removed.
  json one(const std::string& type) {
    const std::vector<json> found = takeMessages(type);
    EXPECT_EQ(found.size(), 1u) << type << " to " << connection << ": " << json(found) << " of " << json(got);
    return found.size() == 1 ? found[0] : json{};
  }
};

class HubCoreTest : public testing::Test {
 protected:
  FakePeer& connect() {
    auto peer = std::make_shared<FakePeer>();
    peer->connection = ++last_;
    peers_[last_] = peer;
    PeerLink link;
    link.send = [peer](const PeerLink::Line& line) {
      const Parsed parsed = parse(std::string_view(*line).substr(0, line->size() - 1));
      EXPECT_EQ(parsed.why, "") << *line;
      peer->got.push_back(parsed.message);
    };
    link.waiting = [peer] { return peer->waiting; };
    link.finish = [peer](const std::string& why) { peer->finished = why; };
    hub_.connected(last_, std::move(link), now_);
    return *peer;
  }
  void give(const FakePeer& from, const json& message) { hub_.received(from.connection, message, now_); }
  void end(const FakePeer& peer) { hub_.disconnected(peer.connection, now_); }
  void wait(milliseconds time) { now_ += time, hub_.passed(now_); }

  FakePeer& client() {
    FakePeer& peer = connect();
    give(peer, {{"type", "hello"}, {"version", 1}, {"role", "client"}});
    peer.got.clear();
    return peer;
  }
  /// A connected program; if `job` is not empty, a rank of an MPI job.
  FakePeer& program(const std::string& job = "", int rank = 0, int ranks = 1) {
    FakePeer& peer = connect();
    give(peer, {{"type", "hello"},
                {"version", 1},
                {"role", "program"},
                {"pid", 100 + peer.connection},
                {"host", "node7"},
                {"name", "glxgears"},
                {"rank", rank},
                {"ranks", ranks},
                {"job", job}});
    EXPECT_EQ(peer.finished, "");
    peer.takeMessages("hello");
    return peer;
  }
  /// Makes the program answer a request of the hub.
  void answer(const FakePeer& program, const json& request, const json& result) {
    give(program, {{"type", "answer"}, {"id", request.value("id", 0)}, {"results", json::array({result})}});
  }
  /// The answer to a client's request; the test fails if it has not come.
  json answered(FakePeer& client, const json& id = 1) {
    const json answer = client.one("answer");
    EXPECT_EQ(answer.value("id", json{}), id);
    return answer;
  }
  /// The first result in that answer.
  json result(FakePeer& client, const json& id = 1) {
    const json answer = answered(client, id);
    if (!answer.contains("results") || answer["results"].empty()) return answer;
    return answer["results"][0];
  }

  HubTime now_{std::chrono::seconds(1000)};
  HubCore hub_{HubCore::Self{"node7", 4100, 1764000000}};
  std::map<uint64_t, std::shared_ptr<FakePeer>> peers_;
  uint64_t last_ = 0;
};

/// Test suite in hub_core_test.cpp and answers_test.cpp.
struct HubCoreRequests : HubCoreTest {};

}  // namespace gluray::control::test
