// The hub on a Unix socket: who may connect, files in its way, and many programs.
#include "control/hub/server/hub_server.h"

#include "control/testing/server_fixture.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <fstream>

namespace gluray::control::test {
namespace {

namespace fs = std::filesystem;

constexpr uid_t kOtherUser = 65534;

TEST_F(HubServerTest, ListensForTheUserAlone) {
  const mode_t before = umask(0);
  start();
  umask(before);
  struct stat status {};
  ASSERT_EQ(lstat(path().c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777, 0600u);
  hub_.stop();
  umask(0777);
  start();
  umask(before);
  ASSERT_EQ(lstat(path().c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777, 0600u);
  const int socket = client();
  hub_.stop();
  EXPECT_TRUE(closes(socket));
  EXPECT_FALSE(fs::exists(path()));
}

TEST_F(HubServerTest, ASecondHubSaysSo) {
  start();
  EXPECT_FALSE(hub_.otherHubRuns());
  HubServer second(io_);
  EXPECT_NE(second.start(options_).find("another hub"), std::string::npos);
  EXPECT_TRUE(second.otherHubRuns());
  EXPECT_TRUE(fs::exists(path())) << "the socket of the first one stays";
  second.stop();
  hub_.stop();
  EXPECT_EQ(second.start(options_), "");
  EXPECT_FALSE(second.otherHubRuns());
}

TEST_F(HubServerTest, WhatStandsInItsPlaceIsRemovedOrRefused) {
  start();
  hub_.stop();
  std::ofstream(folder_ / "precious") << "x";
  const auto socketAt = [&] {
    struct stat status {};
    return lstat(path().c_str(), &status) == 0 && S_ISSOCK(status.st_mode);
  };
  // The socket of a hub that was killed.
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path().c_str(), sizeof address.sun_path - 1);
  const int stale = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  ASSERT_EQ(bind(stale, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  close(stale);
  EXPECT_EQ(hub_.start(options_), "");
  hub_.stop();
  fs::create_symlink(folder_ / "precious", path());
  EXPECT_EQ(hub_.start(options_), "");
  EXPECT_TRUE(socketAt());
  hub_.stop();
  EXPECT_TRUE(fs::exists(folder_ / "precious"));
  std::ofstream(path()) << "x";
  EXPECT_NE(hub_.start(options_).find("no socket"), std::string::npos);
  EXPECT_TRUE(fs::exists(path()));
  fs::remove(path());
  fs::create_directory(path());
  EXPECT_NE(hub_.start(options_), "");
  fs::remove(path());
  fs::remove(fs::path(options_.directory) / "hub.lock");
  fs::create_symlink(folder_ / "precious", fs::path(options_.directory) / "hub.lock");
  EXPECT_NE(hub_.start(options_).find("symbolic link"), std::string::npos);
  EXPECT_FALSE(hub_.otherHubRuns());
  options_.directory = folder_ / std::string(150, 'x');
  EXPECT_NE(hub_.start(options_).find("too long"), std::string::npos);
}

TEST_F(HubServerTest, MessagesMayBeSplitAndJoined) {
  start();
  const int socket = client();
  giveBytes(socket, R"({"type":"list","id":1}
{"type":"list","id":2}
{"type":"li)");
  EXPECT_EQ(nextMessage(socket)["id"], 1);
  EXPECT_EQ(nextMessage(socket)["id"], 2);
  for (const char c : std::string("st\",\"id\":3}\n"))
    giveBytes(socket, std::string(1, c)), io_.restart(), io_.poll();
  EXPECT_EQ(nextMessage(socket)["id"], 3);
}

TEST_F(HubServerTest, LinesThatAreTooLongOrWrongEndAConnection) {
  start();
  const int other = client();
  for (const std::string& bytes : {std::string("{}\n"), std::string("\xff\n"), std::string(20, '[') + "\n"}) {
    const int socket = client();
    giveBytes(socket, bytes);
    std::vector<json> said;
    EXPECT_TRUE(closes(socket, &said));
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0]["type"], "error");
  }
  const int socket = client();
  fcntl(socket, F_SETFL, O_NONBLOCK);
  const std::string piece(10000, 'x');
  EXPECT_TRUE(
      until([&] { return send(socket, piece.data(), piece.size(), MSG_NOSIGNAL) < 0 && errno != EAGAIN; }));
  give(other, json{{"type", "list"}, {"id", 1}});
  EXPECT_EQ(nextMessage(other)["programs"], json::array());
}

TEST_F(HubServerTest, AConnectionWithoutHelloIsClosed) {
  start();
  const int socket = connectHere();
  std::vector<json> said;
  EXPECT_TRUE(closes(socket, &said));  // after 5 s
  ASSERT_EQ(said.size(), 2u);
  EXPECT_EQ(said[1]["why"], "no hello came within 5 s");
}

TEST_F(HubServerTest, AnotherUserIsTurnedAway) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can be another user";
  start();
  const int mine = client();
  // As if the directory were accessible to others: the socket itself checks the user.
  for (fs::path open = options_.directory; open != open.root_path() && fs::exists(open);
       open = open.parent_path())
    if (chmod(open.c_str(), 0755) != 0) break;
  chmod(path().c_str(), 0666);
  const pid_t child = fork();
  if (child == 0) {
    if (setgid(kOtherUser) != 0 || setuid(kOtherUser) != 0) _exit(2);
    const int socket = connectHere();
    char bytes[100];
    _exit(socket < 0 ? 3 : read(socket, bytes, sizeof bytes) == 0 ? 0 : 1);
  }
  int status = 0;
  EXPECT_TRUE(until([&] { return waitpid(child, &status, WNOHANG) == child; }));
  EXPECT_EQ(WEXITSTATUS(status), 0) << "1: it was served, 3: it could not connect at all";
  give(mine, json{{"type", "list"}, {"id", 1}});
  EXPECT_EQ(nextMessage(mine)["id"], 1);
}

TEST_F(HubServerTest, TwoHundredProgramsAnswerOneRequest) {
  start();
  std::vector<int> programs;
  for (int i = 0; i < 200; ++i) {
    programs.push_back(connectHere());
    give(programs.back(), json{{"type", "hello"},
                               {"version", 1},
                               {"role", "program"},
                               {"pid", 1000 + i},
                               {"host", "h"},
                               {"name", "p"}});
  }
  EXPECT_TRUE(until([&] { return hub_.programs() == 200; }));
  const int asking = client();
  give(asking, json{{"type", "set"}, {"id", 1}, {"program", "all"}, {"values", {{"ao", true}}}});
  for (const int program : programs) {
    EXPECT_EQ(nextMessage(program)["type"], "hello");
    const json set = nextMessage(program);
    EXPECT_EQ(set["values"], (json{{"ao", true}}));
    give(program, json{{"type", "answer"}, {"id", set["id"]}, {"results", {{{"frame", 1}}}}});
  }
  EXPECT_EQ(nextMessage(asking)["results"].size(), 200u);
  close(programs[7]);
  sockets_.erase(std::find(sockets_.begin(), sockets_.end(), programs[7]));
  EXPECT_TRUE(until([&] { return hub_.programs() == 199; }));
}

TEST_F(HubServerTest, WithoutDescriptorsItWaitsAndGoesOn) {
  start();
  client();
  rlimit before{};
  getrlimit(RLIMIT_NOFILE, &before);
  const int waiting = connectHere();
  const int lowest = dup(waiting);
  close(lowest);
  const rlimit none{static_cast<rlim_t>(lowest), before.rlim_max};
  setrlimit(RLIMIT_NOFILE, &none);
  io_.restart();
  size_t rounds = 0;
  const auto end = std::chrono::steady_clock::now() + 1s;
  while (std::chrono::steady_clock::now() < end) rounds += io_.run_one_for(100ms);
  setrlimit(RLIMIT_NOFILE, &before);
  EXPECT_LT(rounds, 50u) << "it must not spin";
  EXPECT_EQ(nextMessage(waiting)["type"], "hello");
}

TEST_F(HubServerTest, AllowsManyConnections) {
  rlimit before{}, after{};
  getrlimit(RLIMIT_NOFILE, &before);
  rlimit low = before;
  low.rlim_cur = std::min<rlim_t>(256, before.rlim_max);
  setrlimit(RLIMIT_NOFILE, &low);
  start();
  getrlimit(RLIMIT_NOFILE, &after);
  EXPECT_EQ(after.rlim_cur, std::min<rlim_t>(4096, before.rlim_max));
  setrlimit(RLIMIT_NOFILE, &before);
}

TEST_F(HubServerTest, ConnectToHubFindsIt) {
  std::string why;
  std::shared_ptr<Connection> connection;
  bool called = false;
  const auto connect = [&] {
    called = false;
    connectToHub(io_, {options_.directory, "", ""},
                 [&](std::shared_ptr<Connection> made, const std::string& reason) {
                   called = true, connection = std::move(made), why = reason;
                 });
    EXPECT_TRUE(until([&] { return called; }));
  };
  connect();
  EXPECT_FALSE(connection);
  EXPECT_NE(why, "");
  start();
  connect();
  ASSERT_TRUE(connection) << why;
  std::vector<json> got;
  connection->start(
      {[&](json&& message) { got.push_back(std::move(message)); }, [](const std::string&) {}, {}});
  EXPECT_TRUE(until([&] { return !got.empty(); }));
  EXPECT_EQ(got[0]["role"], "hub");
  connection->close("");
}

}  // namespace
}  // namespace gluray::control::test
