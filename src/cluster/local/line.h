// The connection between a program and a worker of its machine: messages with a type and, if wanted, a file
// descriptor, over a socket of the Unix domain. It breaks when the host program closes the socket's
// descriptor, and then leaves alone whatever has its number. One thread at each end.
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

  /// Blocks while the other end reads slowly, `timeoutMs` at most. False: the other end is gone or too slow;
  /// the line is then of no more use. `attached`: -1: none.
  bool send(uint16_t type, std::span<const std::byte> body, int attached, int timeoutMs);

  /// The next message, if the whole of it has arrived. Never blocks.
  std::optional<Message> receive();
  /// Waits for it; none also where it has not arrived in time.
  std::optional<Message> receive(int timeoutMs);
  /// The other end is gone, or says what is no message: nothing more arrives.
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
  /// Reads what is there, up to `size` bytes in all. True: `got` equals `size`.
  bool receiveMore(std::byte* bytes, size_t size, size_t& got);

  Descriptor socket_;
  bool broken_ = false;
  // Of the message that arrives.
  Head head_;
  size_t headBytes_ = 0, bodyBytes_ = 0;
  Message message_;
};

}  // namespace gluray::cluster
