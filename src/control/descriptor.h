// An owned descriptor, closed by the destructor unless the host program has closed it and reused its number.
// Any thread.
#pragma once
#include "base/guarded_write.h"

#include <unistd.h>

#include <utility>

namespace gluray::control {

class Descriptor {
 public:
  explicit Descriptor(int descriptor = -1) : file_(glurayOutputOf(descriptor)) {}
  Descriptor(Descriptor&& other) noexcept : file_(std::exchange(other.file_, glurayNoOutput())) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
  }
  ~Descriptor() {
    if (isOurs()) ::close(file_.descriptor);
  }
  int get() const { return file_.descriptor; }
  /// Whether the descriptor still refers to the same file.
  bool isOurs() const { return glurayIsSame(&file_); }
  int release() { return std::exchange(file_, glurayNoOutput()).descriptor; }

 private:
  GlurayOutput file_;
};

}  // namespace gluray::control
