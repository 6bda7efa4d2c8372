#include "cluster/local/line.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

namespace gluray::cluster {
namespace {

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

bool Line::receiveMore(std::byte* bytes, size_t size, size_t& got) {
  while (got < size) {
    iovec part{bytes + got, size - got};
    msghdr message{};
    message.msg_iov = &part, message.msg_iovlen = 1;
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> room{};
    message.msg_control = room.data(), message.msg_controllen = room.size();
    const ssize_t count = recvmsg(socket_.get(), &message, MSG_DONTWAIT | MSG_CMSG_CLOEXEC);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      broken_ = count == 0 || !mayGoOn(count);
      return false;
    }
    for (cmsghdr* head = CMSG_FIRSTHDR(&message); head; head = CMSG_NXTHDR(&message, head))
      if (head->cmsg_level == SOL_SOCKET && head->cmsg_type == SCM_RIGHTS) {
        int number = -1;
        std::memcpy(&number, CMSG_DATA(head), sizeof number);
        message_.attached = Descriptor(number);  // one a message; more are closed
      }
    got += static_cast<size_t>(count);
  }
  return true;
}

bool Line::send(uint16_t type, std::span<const std::byte> body, int attached, int timeoutMs) {
  if (body.size() > kMaxBytes || !socket_.isOurs()) return false;
  Head head;
  head.type = type, head.attached = attached >= 0, head.bytes = body.size();
  const int64_t deadline = nowMs() + timeoutMs;
  return sendAll(reinterpret_cast<const std::byte*>(&head), sizeof head, attached, deadline) &&
         sendAll(body.data(), body.size(), -1, deadline);
}

std::optional<Message> Line::receive() {
  broken_ = broken_ || !socket_.isOurs();
  if (broken_ || !receiveMore(reinterpret_cast<std::byte*>(&head_), sizeof head_, headBytes_)) return {};
  if (head_.magic != Head::kMagic || head_.bytes > kMaxBytes ||
      (head_.attached == 1) != (message_.attached.get() >= 0)) {
    broken_ = true;
    return {};
  }
  // Grows with what arrives: the other end may promise more than it sends.
  constexpr size_t kStep = size_t{1} << 22;
  while (bodyBytes_ < head_.bytes) {
    const size_t wanted = std::min<size_t>(head_.bytes, (bodyBytes_ / kStep + 1) * kStep);
    message_.body.resize(wanted);
    if (!receiveMore(message_.body.data(), wanted, bodyBytes_)) return {};
  }
  message_.type = head_.type;
  headBytes_ = bodyBytes_ = 0;
  return std::exchange(message_, Message());
}

std::optional<Message> Line::receive(int timeoutMs) {
  const int64_t deadline = nowMs() + timeoutMs;
  for (;;) {  // each time it looks whether the socket is ours: the host may close it meanwhile
    if (auto message = receive()) return message;
    if (broken_ || !ready(POLLIN, deadline)) return {};
  }
}

}  // namespace gluray::cluster
