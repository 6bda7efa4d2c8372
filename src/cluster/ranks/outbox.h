// Messages to ranks from a worker's tracing threads; its main thread sends them. Any thread.
#pragma once
#include "control/descriptor.h"

#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace gluray::cluster {

class Outbox {
 public:
  struct Letter {
    int to = 0;
    std::vector<std::byte> message;
  };

  /// Throws std::system_error.
  Outbox();
  void push(int to, std::vector<std::byte> message);
  std::vector<Letter> takeLetters();
  /// Readable while something is in it.
  int descriptor() const { return event_.get(); }

 private:
  std::mutex mutex_;
  std::vector<Letter> letters_;
  control::Descriptor event_;
};

}  // namespace gluray::cluster
