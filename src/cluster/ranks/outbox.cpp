#include "cluster/ranks/outbox.h"

#include <sys/eventfd.h>

#include <cerrno>
#include <cstdint>
#include <system_error>

namespace gluray::cluster {

Outbox::Outbox() : event_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (event_.get() < 0) throw std::system_error(errno, std::generic_category(), "cannot make an event");
}

void Outbox::push(int to, std::vector<std::byte> message) {
  const std::lock_guard lock(mutex_);
  letters_.push_back({to, std::move(message)});
  if (letters_.size() == 1) eventfd_write(event_.get(), 1);
}

std::vector<Outbox::Letter> Outbox::takeLetters() {
  const std::lock_guard lock(mutex_);
  eventfd_t count = 0;
  if (!letters_.empty()) eventfd_read(event_.get(), &count);
  return std::exchange(letters_, {});
}

}  // namespace gluray::cluster
