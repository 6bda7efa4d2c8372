#include "dist/local/line.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>

namespace gluray::dist {
namespace {

struct Head {
  uint32_t magic = kMagic;
  uint16_t type = 0, attached = 0;
  uint64_t bytes = 0;
  static constexpr uint32_t kMagic = 0x7952'4c47;  // "GLRy"; in another byte order it is another number
};

int64_t nowMs() {
  return std::chrono::duration_cast<std::chrono::milliseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

bool mayGoOn(ssize_t result) {
  return result < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
}

}  // namespace

bool Line::ready(short events, int64_t deadlineMs) const {
  for (;;) {
    pollfd waits{socket_.get(), events, 0};
    const int64_t left = std::clamp<int64_t>(deadlineMs - nowMs(), 0, 1 << 30);
    const int found = poll(&waits, 1, static_cast<int>(left));
    if (found > 0) return (waits.revents & events) != 0;
    if (found == 0 || errno != EINTR) return false;
  }
}

bool Line::sendAll(const std::byte* bytes, size_t size, int attached, int64_t deadlineMs) {
  while (size > 0) {
    iovec part{const_cast<std::byte*>(bytes), size};
    msghdr message{};
    message.msg_iov = &part, message.msg_iovlen = 1;
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> room{};
    if (attached >= 0) {
      message.msg_control = room.data(), message.msg_controllen = room.size();
      cmsghdr* const head = CMSG_FIRSTHDR(&message);
      head->cmsg_level = SOL_SOCKET, head->cmsg_type = SCM_RIGHTS, head->cmsg_len = CMSG_LEN(sizeof(int));
      std::memcpy(CMSG_DATA(head), &attached, sizeof attached);
    }
    const ssize_t sent = sendmsg(socket_.get(), &message, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent > 0) {
      bytes += sent, size -= static_cast<size_t>(sent), attached = -1;
    } else if (!mayGoOn(sent) || !ready(POLLOUT, deadlineMs)) {
      return false;
    }
  }
  return true;
}

bool Line::receiveAll(std::byte* bytes, size_t size, Descriptor* attached, int64_t deadlineMs) {
  while (size > 0) {
    iovec part{bytes, size};
    msghdr message{};
    message.msg_iov = &part, message.msg_iovlen = 1;
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> room{};
    message.msg_control = room.data(), message.msg_controllen = room.size();
    const ssize_t got = recvmsg(socket_.get(), &message, MSG_DONTWAIT | MSG_CMSG_CLOEXEC);
    if (got == 0) return false;
    if (got < 0) {
      if (!mayGoOn(got) || !ready(POLLIN, deadlineMs)) return false;
      continue;
    }
    for (cmsghdr* head = CMSG_FIRSTHDR(&message); head; head = CMSG_NXTHDR(&message, head))
      if (head->cmsg_level == SOL_SOCKET && head->cmsg_type == SCM_RIGHTS) {
        int number = -1;
        std::memcpy(&number, CMSG_DATA(head), sizeof number);
        Descriptor one(number);  // closed unless it is wanted
        if (attached) *attached = std::move(one);
      }
    bytes += got, size -= static_cast<size_t>(got);
  }
  return true;
}

bool Line::send(uint16_t type, std::span<const std::byte> body, int attached, int timeoutMs) {
  if (body.size() > kMostBytes) return false;
  Head head;
  head.type = type, head.attached = attached >= 0, head.bytes = body.size();
  const int64_t deadline = nowMs() + timeoutMs;
  return sendAll(reinterpret_cast<const std::byte*>(&head), sizeof head, attached, deadline) &&
         sendAll(body.data(), body.size(), -1, deadline);
}

std::optional<Message> Line::receive(int timeoutMs) {
  Head head;
  Message message;
  const int64_t deadline = nowMs() + timeoutMs;
  if (!receiveAll(reinterpret_cast<std::byte*>(&head), sizeof head, &message.attached, deadline)) return {};
  if (head.magic != Head::kMagic || head.bytes > kMostBytes || (head.attached == 1) != bool{message.attached})
    return {};
  message.type = head.type;
  // Grows with what arrives: the other end may promise more than it sends.
  constexpr size_t kStep = size_t{1} << 22;
  for (size_t left = head.bytes; left > 0;) {
    const size_t step = std::min(left, kStep), before = message.body.size();
    message.body.resize(before + step);
    if (!receiveAll(message.body.data() + before, step, nullptr, deadline)) return {};
    left -= step;
  }
  return message;
}

bool Line::hasMore() const { return ready(POLLIN, 0); }

}  // namespace gluray::dist
