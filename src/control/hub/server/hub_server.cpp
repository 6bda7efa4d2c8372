#include "control/hub/server/hub_server.h"

#include "control/auth/handshake.h"
#include "control/auth/refusals.h"
#include "control/connection/connect.h"
#include "control/connection/connect_tcp.h"
#include "control/connection/connection.h"
#include "control/hub/hub_core.h"
#include "control/hub/server/listener.h"
#include "control/hub/server/program_files.h"
#include "control/hub/server/unproven_connections.h"
#include "control/listening_place.h"
#include "control/local_socket.h"

#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <exception>
#include <iterator>
#include <map>
#include <utility>

namespace gluray::control {
namespace {

using std::chrono::steady_clock;

constexpr size_t kMaxConnections = 1024;
constexpr std::chrono::milliseconds kProofPatience{5000};
constexpr rlim_t kDescriptors = 4096;  // more than the maximum of connections
constexpr std::chrono::milliseconds kSoonest{1};
// Delays before each repetition. A program whose frame began just before the hub listened looks for a hub in
// its next frame; a program that lost its hub waits up to two seconds.
constexpr std::chrono::milliseconds kWakeAgain[] = {
    std::chrono::milliseconds(150), std::chrono::milliseconds(350), std::chrono::milliseconds(2500)};
constexpr std::chrono::milliseconds kYoung{1000}, kCountAgain{20};

HubCore::Self thisHub() {
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);
  const auto calendar = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch());
  const auto steady = std::chrono::duration<double>(steady_clock::now().time_since_epoch());
  return {host.data(), getpid(), (calendar - steady).count()};
}

void allowManyConnections() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= kDescriptors) return;
  limit.rlim_cur = std::min(limit.rlim_max, kDescriptors);  // RLIM_INFINITY is the highest number
  setrlimit(RLIMIT_NOFILE, &limit);
}

}  // namespace

class HubServer::Parts : public std::enable_shared_from_this<Parts> {
 public:
  explicit Parts(asio::io_context& io) : io_(io), timer_(io), waking_(io), core_(thisHub()) {}

  std::string start(const HubOptions& options);
  void stop();

  bool otherHub = false;
  int tcpPort = 0;
  std::string directory;
  const HubCore& core() const { return core_; }
  size_t expected() const;

 private:
  std::string listen(const HubOptions& options);
  /// Wakes programs that are not connected, repeatedly. `times`: number of times so far.
  void wake(size_t times);
  void acceptHere(Connection::Socket socket);
  void acceptTcp(HandshakeSocket socket, const std::string& address);
  void take(Connection::Socket socket);
  void ended(uint64_t number);
  HubCore::Beginning beginning();
  /// Calls the core, and calls passed() again when something is due.
  template <class Call>
  void withCore(Call call);
  void rest();
  /// Makes room for one more connection, if that only requires closing unauthenticated ones.
  bool hasRoom();

  asio::io_context& io_;
  asio::steady_timer timer_, waking_;
  std::function<void(const std::string&, unsigned long)> wake_;
  HubTime timerAt_ = HubTime::max();
  HubTime began_{}, counted_ = HubTime::min();  // `counted_`: when `expected_` was counted
  size_t expected_ = 0;
  HubCore core_;
  ListeningPlace place_{"hub", "hub"};
  Refusals refusals_;
  Key key_{};
  std::shared_ptr<Listener> here_, tcp_;
  std::map<uint64_t, std::shared_ptr<Connection>> connections_;
  uint64_t last_ = 0;
  UnprovenConnections unproven_;
  bool running_ = false;
};

std::string HubServer::Parts::listen(const HubOptions& options) {
  directory = options.directory;
  here_ = tcp_ = nullptr;
  tcpPort = 0;
  if (std::string why = place_.lockPlace(directory, otherHub); !why.empty()) return why;
  std::string why;
  Descriptor tcp;
  if (!options.listen.empty()) {
    const KeyOrWhy key = readKey(options.keyFile);
    if (!key.why.empty()) return key.why;
    key_ = key.key;
    tcp = Descriptor(listenOnTcp(options.listen, tcpPort, why));
    if (tcp.get() < 0) return why;
  }
  Descriptor here(place_.listenHere(why));
  if (here.get() < 0) return why;
  here_ = std::make_shared<Listener>(
      io_, std::move(here),
      [this](Connection::Socket socket, const std::string&) { acceptHere(std::move(socket)); });
  if (tcp.get() >= 0)
    tcp_ = std::make_shared<Listener>(io_, std::move(tcp),
                                      [this](HandshakeSocket socket, const std::string& address) {
                                        acceptTcp(std::move(socket), address);
                                      });
  return "";
}

std::string HubServer::Parts::start(const HubOptions& options) {
  if (running_) return "this hub runs already";
  allowManyConnections();
  std::string why;
  try {
    why = listen(options);
  } catch (const std::exception& error) { why = std::string("the hub cannot listen: ") + error.what(); }
  if (!why.empty()) {
    tcpPort = 0;
    place_.leave();
    return why;
  }
  running_ = true;
  began_ = steady_clock::now();
  counted_ = HubTime::min();
  here_->start();
  if (tcp_) tcp_->start();
  wake_ = options.wake;
  if (wake_) wake(0);
  return "";
}

void HubServer::Parts::wake(size_t times) {
  for (const ProgramFile& file : programFiles(directory))
    if (file.window != 0 && !core_.hasProcess(file.pid)) wake_(file.display, file.window);
  if (times >= std::size(kWakeAgain)) return;
  waking_.expires_after(kWakeAgain[times]);
  waking_.async_wait([weak = weak_from_this(), times](const asio::error_code& error) {
    const auto self = weak.lock();
    if (!error && self && self->running_) self->wake(times + 1);
  });
}

void HubServer::Parts::stop() {
  if (!std::exchange(running_, false)) return;
  here_->stop();
  if (tcp_) tcp_->stop();
  timer_.cancel();
  waking_.cancel();
  for (const auto& [number, connection] : std::exchange(connections_, {})) connection->close("the hub ends");
  place_.leave();
  tcpPort = 0;
}

void HubServer::Parts::acceptHere(Connection::Socket socket) {
  if (running_ && sameUser(socket.native_handle()) && hasRoom()) take(std::move(socket));
}

bool HubServer::Parts::hasRoom() {
  if (connections_.size() >= kMaxConnections) return false;
  if (connections_.size() + unproven_.size() >= kMaxConnections) unproven_.closeOne();
  return true;
}

void HubServer::Parts::acceptTcp(HandshakeSocket socket, const std::string& address) {
  if (!running_ || refusals_.refused(address, steady_clock::now()) || !hasRoom()) return;
  unproven_.makeRoomFor(address);
  keepAlive(socket.native_handle());
  const uint64_t number = unproven_.join(address);
  // Counted while the handshake keeps this object, however the handshake ends.
  const std::shared_ptr<void> counted(
      nullptr, [self = shared_from_this(), number](void*) { self->unproven_.leave(number); });
  auto close = proveAsHub(
      std::move(socket), key_, kProofPatience,
      [self = shared_from_this(), address](HubProof&& proof) {
        if (proof.wrong) self->refusals_.failed(address, steady_clock::now());
        if (proof.socket && self->running_) self->take(std::move(*proof.socket));
      },
      [counted] {});
  unproven_.setClose(number, std::move(close));
}

void HubServer::Parts::take(Connection::Socket socket) {
  const uint64_t number = ++last_;
  const auto connection = std::make_shared<Connection>(std::move(socket), kMaxMessages);
  connections_[number] = connection;
  const std::weak_ptr<Parts> weak = weak_from_this();
  PeerLink link;
  link.send = [connection](const PeerLink::Line& line) { connection->send(line); };
  link.waiting = [connection] { return connection->waiting(); };
  link.finish = [connection](const std::string& why) { connection->finish(why); };
  withCore([&] { core_.connected(number, std::move(link), steady_clock::now(), beginning()); });
  try {
    connection->start({[weak, number](nlohmann::json&& message) {
                         if (const auto self = weak.lock())
                           self->withCore(
                               [&] { self->core_.received(number, message, steady_clock::now()); });
                       },
                       // The core itself may have closed it: reports it later.
                       [weak, number, &io = io_](const std::string&) {
                         asio::post(io, [weak, number] {
                           if (const auto self = weak.lock()) self->ended(number);
                         });
                       },
                       [weak, number] {
                         if (const auto self = weak.lock())
                           self->withCore([&] { self->core_.drained(number, steady_clock::now()); });
                       }});
  } catch (const std::exception& error) {  // out of memory
    connection->close(error.what());
    ended(number);
  }
}

/// Reads the programs' files rarely: many clients may connect at once.
HubCore::Beginning HubServer::Parts::beginning() {
  const HubTime now = steady_clock::now();
  const auto age = now - began_;
  if (counted_ == HubTime::min() || now - counted_ >= (age < kYoung ? kCountAgain : kYoung))
    expected_ = expected(), counted_ = now;
  return {expected_, std::chrono::duration<double>(age).count(), tcp_ != nullptr};
}

size_t HubServer::Parts::expected() const {
  size_t count = 0;
  if (directory.empty()) return count;  // not started
  for (const ProgramFile& file : programFiles(directory)) count += !core_.hasProcess(file.pid);
  return count;
}

void HubServer::Parts::ended(uint64_t number) {
  connections_.erase(number);
  withCore([&] { core_.disconnected(number, steady_clock::now()); });
}

template <class Call>
void HubServer::Parts::withCore(Call call) {
  try {
    call();
  } catch (const std::exception&) {  // out of memory: loses the message, but not the hub
  }
  try {
    rest();
  } catch (const std::exception&) {  // no memory for a timer: the next message sets it
    timerAt_ = HubTime::max();
  }
}

void HubServer::Parts::rest() {
  const HubTime next = core_.nextDue();
  if (!running_ || next == timerAt_) return;
  timerAt_ = next;
  timer_.cancel();
  if (next == HubTime::max()) return;
  // Not before the next iteration of the io_context, so that overdue work does not block its sockets.
  timer_.expires_at(std::max(next, steady_clock::now() + kSoonest));
  timer_.async_wait([weak = weak_from_this()](const asio::error_code& error) {
    const auto self = weak.lock();
    if (error || !self || !self->running_) return;
    self->timerAt_ = HubTime::max();
    self->withCore([&] { self->core_.passed(steady_clock::now()); });
  });
}

HubServer::HubServer(asio::io_context& io) : parts_(std::make_shared<Parts>(io)) {}
HubServer::~HubServer() { parts_->stop(); }

std::string HubServer::start(const HubOptions& options) { return parts_->start(options); }
void HubServer::stop() { parts_->stop(); }
bool HubServer::otherHubRuns() const { return parts_->otherHub; }
int HubServer::port() const { return parts_->tcpPort; }
size_t HubServer::programs() const { return parts_->core().programs(); }
size_t HubServer::clients() const { return parts_->core().clients(); }
size_t HubServer::expected() const { return parts_->expected(); }

}  // namespace gluray::control
