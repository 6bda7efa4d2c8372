#include "control/auth/handshake.h"

#include "control/messages/members.h"
#include "control/messages/parsed.h"

#include <asio/buffer.hpp>
#include <asio/read.hpp>
#include <asio/steady_timer.hpp>
#include <asio/write.hpp>

#include <array>
#include <memory>
#include <utility>

namespace gluray::control {
namespace {

using asio::error_code;
using nlohmann::json;
using std::chrono::milliseconds;

constexpr milliseconds kWrongProofPause{500};
constexpr const char* kOtherKey = "the hub does not have the same key; use a copy of its key file";

/// Reads and writes the lines of a handshake, and not a byte more: later bytes belong to the connection.
class HandshakeLines : public std::enable_shared_from_this<HandshakeLines> {
 public:
  HandshakeLines(HandshakeSocket socket, const Key& key)
      : socket_(std::move(socket)), timer_(socket_.get_executor()), key_(key) {}
  HandshakeLines(const HandshakeLines&) = delete;
  HandshakeLines& operator=(const HandshakeLines&) = delete;
  virtual ~HandshakeLines() = default;

 protected:
  enum class Failure { gone, wrong, late };
  virtual void failed(Failure failure) = 0;

  void limit(milliseconds patience) {
    timer_.expires_after(patience);
    timer_.async_wait([self = shared_from_this()](const error_code& error) {
      if (!error) self->fail(Failure::late);
    });
  }

  /// Reads a message of this type.
  void read(const char* type, std::function<void(const json&)> then) {
    asio::async_read(
        socket_, asio::buffer(&byte_, 1),
        [self = shared_from_this(), type, then = std::move(then)](const error_code& error, size_t) {
          if (self->over_) return;
          if (error) return self->fail(Failure::gone);
          self->take(type, then);
        });
  }

  void write(const json& message, std::function<void()> then) {
    const auto line = std::make_shared<const std::string>(lineOf(message));
    asio::async_write(
        socket_, asio::buffer(*line),
        [self = shared_from_this(), line, then = std::move(then)](const error_code& error, size_t) {
          if (self->over_) return;
          if (error) return self->fail(Failure::gone);
          then();
        });
  }

  void fail(Failure failure) {
    if (std::exchange(over_, true)) return;
    timer_.cancel();
    failed(failure);
  }

  bool isOver() const { return over_; }

  HandshakeSocket handOver() {
    over_ = true;
    timer_.cancel();
    return std::move(socket_);
  }

  HandshakeSocket socket_;
  asio::steady_timer timer_;
  const Key key_;
  std::string hubNonce_, peerNonce_;

 private:
  void take(const char* type, const std::function<void(const json&)>& then) {
    if (byte_ != '\n') {
      line_ += byte_;
      return line_.size() < kMaxHandshakeBytes ? read(type, then) : fail(Failure::wrong);
    }
    const Parsed parsed = parse(std::exchange(line_, {}));
    if (!parsed.why.empty() || parsed.message["type"] != type) return fail(Failure::wrong);
    then(parsed.message);
  }

  std::string line_;
  char byte_ = 0;
  bool over_ = false;
};

std::string textOr(const json& message, const char* name) {
  return textMember(message, name, kMaxCharacters).value_or("");
}

class HubSide : public HandshakeLines {
 public:
  using Done = std::function<void(HubProof&&)>;
  HubSide(HandshakeSocket socket, const Key& key, Done done, std::function<void()> ended)
      : HandshakeLines(std::move(socket), key), done_(std::move(done)), ended_(std::move(ended)) {}

  void cancel() {
    if (isOver())
      timer_.cancel();  // it waits only to close
    else
      fail(Failure::gone);
  }

  void start(milliseconds patience) {
    limit(patience);
    hubNonce_ = newNonce();
    if (hubNonce_.empty()) return fail(Failure::gone);
    write({{"type", "challenge"}, {"nonce", hubNonce_}},
          [this] { read("proof", [this](const json& proof) { check(proof); }); });
  }

 private:
  void check(const json& proof) {
    peerNonce_ = textOr(proof, "nonce");
    if (!isNonce(peerNonce_) ||
        !sameProof(textOr(proof, "mac"), proofOf(key_, Prover::peer, hubNonce_, peerNonce_)))
      return fail(Failure::wrong);
    write({{"type", "proof"}, {"mac", proofOf(key_, Prover::hub, hubNonce_, peerNonce_)}}, [this] {
      done_(HubProof{handOver(), false});
      ended_();
    });
  }

  void failed(Failure failure) override {
    done_(HubProof{std::nullopt, failure != Failure::gone});
    if (failure == Failure::gone) return close();
    timer_.expires_after(kWrongProofPause);
    timer_.async_wait([self = shared_from_this(), this](const error_code&) { close(); });
  }
  void close() {
    error_code ignored;
    socket_.close(ignored);
    ended_();
  }

  const Done done_;
  const std::function<void()> ended_;
};

class PeerSide : public HandshakeLines {
 public:
  using Done = std::function<void(PeerProof&&)>;
  PeerSide(HandshakeSocket socket, const Key& key, Done done)
      : HandshakeLines(std::move(socket), key), done_(std::move(done)) {}

  void start(milliseconds patience) {
    limit(patience);
    read("challenge", [this](const json& challenge) { prove(challenge); });
  }

 private:
  void prove(const json& challenge) {
    hubNonce_ = textOr(challenge, "nonce");
    peerNonce_ = newNonce();
    if (!isNonce(hubNonce_) || peerNonce_.empty()) return fail(Failure::wrong);
    proved_ = true;
    write({{"type", "proof"},
           {"nonce", peerNonce_},
           {"mac", proofOf(key_, Prover::peer, hubNonce_, peerNonce_)}},
          [this] { read("proof", [this](const json& proof) { check(proof); }); });
  }
  void check(const json& proof) {
    if (!sameProof(textOr(proof, "mac"), proofOf(key_, Prover::hub, hubNonce_, peerNonce_)))
      return fail(Failure::wrong);
    done_(PeerProof{handOver(), "", ConnectFailure::none});
  }
  void failed(Failure failure) override {
    error_code ignored;
    socket_.close(ignored);
    const char* why = failure == Failure::late   ? "the hub does not answer in time"
                      : proved_                  ? kOtherKey
                      : failure == Failure::gone ? "the hub refuses this machine; wait a minute"
                                                 : "no hub of GLuRay listens there";
    const auto kind = failure == Failure::late   ? ConnectFailure::unreachable
                      : proved_                  ? ConnectFailure::key
                      : failure == Failure::gone ? ConnectFailure::refused
                                                 : ConnectFailure::unreachable;
    done_(PeerProof{std::nullopt, why, kind});
  }

  const Done done_;
  bool proved_ = false;
};

}  // namespace

std::function<void()> proveAsHub(HandshakeSocket socket, const Key& key, milliseconds patience,
                                 std::function<void(HubProof&&)> done, std::function<void()> ended) {
  const auto side = std::make_shared<HubSide>(std::move(socket), key, std::move(done), std::move(ended));
  side->start(patience);
  return [weak = std::weak_ptr(side)] {
    if (const auto self = weak.lock()) self->cancel();
  };
}

void proveAsPeer(HandshakeSocket socket, const Key& key, milliseconds patience,
                 std::function<void(PeerProof&&)> done) {
  std::make_shared<PeerSide>(std::move(socket), key, std::move(done))->start(patience);
}

}  // namespace gluray::control
