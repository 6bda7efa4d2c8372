// The connection between a program and a worker of its machine: messages with a type and, if wanted, a file
// descriptor, over a socket of the Unix domain. One thread at each end.
#pragma once
#include "dist/local/sealed_memory.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gluray::dist {

struct Message {
  uint16_t type = 0;
  std::vector<std::byte> body;
  Descriptor attached;  // none: empty
};

class Line {
 public:
  static constexpr size_t kMostBytes = size_t{1} << 30;  // of a message

  explicit Line(Descriptor socket) : socket_(std::move(socket)) {}

  /// Blocks while the other end reads slowly, `timeoutMs` at most. False: the other end is gone or too slow;
  /// the line is then of no more use. `attached`: -1: none.
  bool send(uint16_t type, std::span<const std::byte> body, int attached, int timeoutMs);

  /// The next message; none: the other end is gone, says nothing whole in time, or says what is no message.
  std::optional<Message> receive(int timeoutMs);

  /// Whether something waits to be read.
  bool hasMore() const;
  int descriptor() const { return socket_.get(); }

 private:
  bool ready(short events, int64_t deadlineMs) const;
  bool sendAll(const std::byte* bytes, size_t size, int attached, int64_t deadlineMs);
  bool receiveAll(std::byte* bytes, size_t size, Descriptor* attached, int64_t deadlineMs);

  Descriptor socket_;
};

}  // namespace gluray::dist
