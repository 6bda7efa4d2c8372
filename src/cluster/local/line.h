// The connection between a program and a worker of its machine: messages with a type and, if wanted, a file
// descriptor, over a socket of the Unix domain. It breaks if the host program closes the socket's descriptor,
// and does not touch another file with the same number. One thread at each end.
#pragma once
#include "cluster/local/sealed_memory.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gluray::cluster {

struct Message {
  uint16_t type = 0;
  std::vector<std::byte> body;
  Descriptor attached;  // none: negative
};

class Line {
 public:
  static constexpr size_t kMaxBytes = size_t{1} << 30;  // of a message

  explicit Line(Descriptor socket) : socket_(std::move(socket)) {}

  /// Blocks while the other end reads slowly, at most `timeoutMs`. Returns false if the other end is gone or
  /// too slow; the connection is then unusable. `attached`: -1: none.
  bool send(uint16_t type, std::span<const std::byte> body, int attached, int timeoutMs);

  /// Returns the next message if it has arrived completely. Never blocks.
  std::optional<Message> receive();
  /// Waits for the next message; none on a timeout.
  std::optional<Message> receive(int timeoutMs);
  /// Whether the other end is gone or has sent an invalid message: nothing more arrives.
  bool isBroken() const { return broken_; }
  int descriptor() const { return socket_.get(); }

 private:
  struct Head {
    uint32_t magic = kMagic;
    uint16_t type = 0, attached = 0;
    uint64_t bytes = 0;
    static constexpr uint32_t kMagic = 0x7952'4c47;  // "GLRy"; in another byte order it is another number
  };

  bool ready(short events, int64_t deadlineMs) const;
  bool sendAll(const std::byte* bytes, size_t size, int attached, int64_t deadlineMs);
  /// Reads available bytes, up to `size` in total. Returns whether `got` equals `size`.
  bool receiveMore(std::byte* bytes, size_t size, size_t& got);

  Descriptor socket_;
  bool broken_ = false;
  // Header of the incoming message.
  Head head_;
  size_t headBytes_ = 0, bodyBytes_ = 0;
  Message message_;
};

}  // namespace gluray::cluster
