// The hub on TCP: only peers with the key are accepted. Uses 127.0.0.1 and any free port.
#include "control/auth/handshake.h"
#include "control/auth/key.h"
#include "control/auth/refusals.h"
#include "control/auth/waiting_peers.h"
#include "control/connection/connect_tcp.h"
#include "control/testing/server_fixture.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>

#include <algorithm>
#include <fstream>

namespace gluray::control::test {
namespace {

namespace fs = std::filesystem;

struct HubTcp : HubServerTest {
  void SetUp() override {
    options_.listen = "127.0.0.1:0";
    options_.keyFile = folder_ / "key";
    ASSERT_EQ(writeNewKey(options_.keyFile), "");
    key = readKey(options_.keyFile).key;
  }
  /// Connects from this address of the loopback network.
  int connectTcp(in_addr_t from) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(from);
    const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    EXPECT_EQ(bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    address.sin_port = htons(static_cast<uint16_t>(hub_.port()));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
      return ::close(socket), -1;
    sockets_.push_back(socket);
    return socket;
  }
  /// Proves knowledge of the key, after the challenge.
  void proves(int socket) {
    const json challenge = nextMessage(socket);
    ASSERT_EQ(challenge["type"], "challenge");
    give(socket, proof(challenge["nonce"]));
    EXPECT_EQ(nextMessage(socket)["type"], "proof");
    EXPECT_EQ(nextMessage(socket)["role"], "hub");
  }
  int connectTcp() {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<uint16_t>(hub_.port()));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return connectTo(reinterpret_cast<const sockaddr*>(&address), sizeof address, AF_INET);
  }
  json proof(const std::string& hubNonce) const {
    const std::string nonce = newNonce();
    return {{"type", "proof"}, {"nonce", nonce}, {"mac", proofOf(key, Prover::peer, hubNonce, nonce)}};
  }
  /// Why connectToHub() fails; empty if it succeeds and the hub's hello is the first message.
  std::string connectAsProgram(const std::string& keyFile) {
    std::string why = "never called";
    std::shared_ptr<Connection> connection;
    bool called = false;
    connectToHub(io_, {"", "127.0.0.1:" + std::to_string(std::max(hub_.port(), 1)), keyFile},
                 [&](std::shared_ptr<Connection> made, const std::string& reason) {
                   called = true, connection = std::move(made), why = reason;
                 });
    EXPECT_FALSE(called) << "not before it returns";
    EXPECT_TRUE(until([&] { return called; }));
    EXPECT_EQ(connection == nullptr, !why.empty());
    if (!connection) return why;
    std::vector<json> got;
    connection->start(
        {[&](json&& message) { got.push_back(std::move(message)); }, [](const std::string&) {}, {}});
    EXPECT_TRUE(until([&] { return !got.empty(); }));
    EXPECT_EQ(got.empty() ? json{} : got[0]["role"], "hub");
    connection->close("");
    return "";
  }
  Key key{};
};

TEST_F(HubTcp, ThoseWithTheKeyAreHeard) {
  start();
  ASSERT_GT(hub_.port(), 0);
  EXPECT_EQ(connectAsProgram(options_.keyFile), "");
  const int socket = connectTcp();
  const json challenge = nextMessage(socket);
  EXPECT_EQ(challenge["type"], "challenge");
  const json sent = proof(challenge["nonce"]);
  // The hello is in one packet with the proof: nothing of it may be lost.
  giveBytes(socket, lineOf(sent) + lineOf(json{{"type", "hello"}, {"version", 1}, {"role", "client"}}) +
                        lineOf(json{{"type", "list"}, {"id", 1}}));
  const json answer = nextMessage(socket);
  EXPECT_EQ(answer, (json{{"type", "proof"},
                          {"mac", proofOf(key, Prover::hub, challenge["nonce"].get<std::string>(),
                                          sent["nonce"].get<std::string>())}}));
  EXPECT_EQ(nextMessage(socket)["type"], "hello");
  EXPECT_EQ(nextMessage(socket)["id"], 1);
}

TEST_F(HubTcp, AHubMayStartAgainWithoutTcp) {
  EXPECT_EQ(hub_.expected(), 0u);
  start();
  EXPECT_NE(hub_.start(options_), "");
  EXPECT_GT(hub_.port(), 0) << "it still runs";
  hub_.stop();
  options_.listen.clear();
  start();
  EXPECT_EQ(hub_.port(), 0);
  client();
}

TEST_F(HubTcp, AnotherKeyIsFound) {
  start();
  ASSERT_EQ(writeNewKey(folder_ / "other"), "");
  EXPECT_NE(connectAsProgram(folder_ / "other").find("same key"), std::string::npos);
  EXPECT_EQ(connectAsProgram(options_.keyFile), "");
}

TEST_F(HubTcp, FailuresCanBeToldApart) {
  start();
  const auto failure = [&](const std::string& host, const std::string& keyFile) {
    std::optional<ConnectFailure> got;
    connectToHub(
        io_, {"", host, keyFile},
        [&](const std::shared_ptr<Connection>&, const std::string&, ConnectFailure why) { got = why; });
    EXPECT_TRUE(until([&] { return got.has_value(); }));
    return got.value_or(ConnectFailure::none);
  };
  const std::string here = "127.0.0.1:" + std::to_string(hub_.port());
  ASSERT_EQ(writeNewKey(folder_ / "other"), "");
  EXPECT_EQ(failure(here, options_.keyFile), ConnectFailure::none);
  EXPECT_EQ(failure("here", options_.keyFile), ConnectFailure::settings);
  EXPECT_EQ(failure(here, folder_ / "none"), ConnectFailure::settings);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(failure(here, folder_ / "other"), ConnectFailure::key);
  EXPECT_EQ(failure(here, options_.keyFile), ConnectFailure::refused);
  EXPECT_EQ(failure("127.0.0.1:1", options_.keyFile), ConnectFailure::unreachable);
}

TEST_F(HubTcp, ADeadConnectionIsFoundAlsoWhileDataWaits) {
  start();
  const int socket = connectTcp();
  keepAlive(socket);
  unsigned int time = 0;
  socklen_t size = sizeof time;
  ASSERT_EQ(getsockopt(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, &time, &size), 0);
  EXPECT_EQ(time, 60000u);
}

TEST_F(HubTcp, AProofIsGoodOnce) {
  start();
  const int first = connectTcp();
  const json sent = proof(nextMessage(first)["nonce"]);
  give(first, sent);
  EXPECT_EQ(nextMessage(first)["type"], "proof");
  const int second = connectTcp();
  EXPECT_EQ(nextMessage(second)["type"], "challenge");
  give(second, sent);
  std::vector<json> said;
  EXPECT_TRUE(closes(second, &said));
  EXPECT_TRUE(said.empty());
}

TEST_F(HubTcp, TheHubsOwnProofIsNoPeersProof) {
  start();
  const int socket = connectTcp();
  const std::string nonce = nextMessage(socket)["nonce"].get<std::string>();
  give(socket, json{{"type", "proof"}, {"nonce", nonce}, {"mac", proofOf(key, Prover::hub, nonce, nonce)}});
  EXPECT_TRUE(closes(socket));
}

TEST_F(HubTcp, WhoeverGoesInTheMiddleIsForgiven) {
  start();
  for (int i = 0; i < 10; ++i) {
    const int socket = connectTcp();
    EXPECT_EQ(nextMessage(socket)["type"], "challenge");
    giveBytes(socket, R"({"type": "pro)");
    close(socket);
    sockets_.pop_back();
  }
  EXPECT_EQ(connectAsProgram(options_.keyFile), "");
}

TEST_F(HubTcp, SilentConnectionsOfOneAddressKeepNobodyOut) {
  constexpr in_addr_t kFirst = INADDR_LOOPBACK, kSecond = INADDR_LOOPBACK + 1;
  start();
  std::vector<int> silent;
  for (size_t i = 0; i < WaitingPeers::kMaxPerNetwork + 16; ++i) {
    silent.push_back(connectTcp(kSecond));
    ASSERT_GE(silent.back(), 0);
    ASSERT_EQ(nextMessage(silent.back())["type"], "challenge") << i;
  }
  proves(connectTcp(kFirst));
  proves(connectTcp(kSecond));
  for (size_t i = 0; i <= 16; ++i) EXPECT_TRUE(closes(silent[i])) << i;
  char byte = 0;
  for (size_t i = 17; i < silent.size(); ++i)
    EXPECT_EQ(recv(silent[i], &byte, 1, MSG_DONTWAIT), -1) << i << " may still prove";
  proves(connectTcp(kSecond));
}

TEST_F(HubTcp, SilentConnectionsOfManyAddressesKeepNobodyOut) {
  start();
  std::vector<int> silent;
  for (size_t i = 0; i < WaitingPeers::kMax + 16; ++i) {
    silent.push_back(connectTcp(static_cast<in_addr_t>(INADDR_LOOPBACK + 2 + i % 8)));
    ASSERT_GE(silent.back(), 0);
    ASSERT_EQ(nextMessage(silent.back())["type"], "challenge") << i;
  }
  proves(connectTcp(INADDR_LOOPBACK));
  EXPECT_TRUE(closes(silent[0]));
}

TEST_F(HubTcp, AfterThreeWrongProofsAnAddressIsRefused) {
  start();
  const std::vector<std::string> wrong{"{\"type\":\"hello\"}\n", std::string(300, 'x'),
                                       lineOf({{"type", "proof"}, {"nonce", 1}, {"mac", nullptr}})};
  for (const std::string& bytes : wrong) {
    const int socket = connectTcp();
    EXPECT_EQ(nextMessage(socket)["type"], "challenge");
    giveBytes(socket, bytes);
    EXPECT_TRUE(closes(socket));
  }
  std::vector<json> said;
  EXPECT_TRUE(closes(connectTcp(), &said));
  EXPECT_TRUE(said.empty()) << "it does not even get a challenge";
  EXPECT_NE(connectAsProgram(options_.keyFile).find("refuses"), std::string::npos);
}

TEST_F(HubTcp, MistakesAreOneLine) {
  for (const char* listen :
       {"127.0.0.1", "127.0.0.1:", "127.0.0.1:x", ":1", "127.0.0.1:65536", "127.0.0.1:-1", "::1:1"}) {
    options_.listen = listen;
    EXPECT_NE(hub_.start(options_), "") << listen;
    EXPECT_EQ(hub_.port(), 0);
  }
  options_.listen = "127.0.0.1:0";
  options_.keyFile = folder_ / "none";
  EXPECT_NE(hub_.start(options_).find("--new-key"), std::string::npos);
  EXPECT_FALSE(fs::exists(path())) << "it listens nowhere";
  EXPECT_NE(connectAsProgram(folder_ / "none").find("--new-key"), std::string::npos);
  std::ofstream(folder_ / "short") << "x";
  chmod((folder_ / "short").c_str(), 0600);
  EXPECT_NE(readKey(folder_ / "short").why.find("shorter"), std::string::npos);
  EXPECT_NE(readKey(folder_).why.find("regular"), std::string::npos);
  EXPECT_NE(readKey("").why, "");
  chmod((folder_ / "key").c_str(), 0640);
  EXPECT_NE(readKey(folder_ / "key").why.find("chmod 600"), std::string::npos);
  EXPECT_NE(writeNewKey(folder_ / "key").find("use another name"), std::string::npos);
}

TEST(HostAndPort, Reads) {
  const auto two = [](const std::string& text) {
    const auto read = hostAndPort(text);
    return read ? read->host + " " + std::to_string(read->port) : "none";
  };
  EXPECT_EQ(two("node7:7000"), "node7 7000");
  EXPECT_EQ(two("[::1]:0"), "::1 0");
  for (const char* wrong :
       {"", ":", "node7", "::1", "a:b:1", "[::1]", "[]:1", "a: 1", "a:1 ", "a:+1", "a:99999999999"})
    EXPECT_EQ(two(wrong), "none") << wrong;
}

TEST(Proofs, AreThoseOfTheProtocol) {
  Key key{};
  for (size_t i = 0; i < key.size(); ++i) key[i] = static_cast<unsigned char>(i);
  const std::string n1(64, 'a'), n2(64, 'b');
  EXPECT_EQ(proofOf(key, Prover::peer, n1, n2),
            "29d4a9eff7e047f241e81636245013bbd2c63fdb175285fe7379d399d8b04fc9");
  EXPECT_EQ(proofOf(key, Prover::hub, n1, n2),
            "5cefb0b05ec0a598d84796844829abd05d37d03d8df922ef8d227e73eec401c8");
  EXPECT_FALSE(sameProof("", "x"));
  EXPECT_TRUE(isNonce(newNonce()));
  EXPECT_NE(newNonce(), newNonce());
  EXPECT_FALSE(isNonce(std::string(64, 'A')));
  EXPECT_FALSE(isNonce(std::string(63, 'a')));
}

TEST(Refusals, AreForAMinuteAndBounded) {
  using namespace std::chrono_literals;
  Refusals refusals;
  Refusals::Time now{1000s};
  for (int i = 0; i < 3; ++i) refusals.failed("a", now += 29s);
  EXPECT_TRUE(refusals.refused("a", now));
  EXPECT_FALSE(refusals.refused("b", now));
  EXPECT_TRUE(refusals.refused("a", now + 59s));
  EXPECT_FALSE(refusals.refused("a", now += 60s));
  for (int i = 0; i < 10; ++i) refusals.failed("c", now += 30s);
  EXPECT_FALSE(refusals.refused("c", now)) << "no three within a minute";
  for (int i = 0; i < 5000; ++i) refusals.failed(std::to_string(i), now);
  EXPECT_LE(refusals.addresses(), Refusals::kMaxAddresses);
}

}  // namespace
}  // namespace gluray::control::test
