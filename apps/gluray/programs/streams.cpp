#include "programs/streams.h"

#include "base/guarded_write.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

namespace gluray::launcher {
namespace {

std::string identityOf(int number) {
  const int flags = fcntl(number, F_GETFD);
  const GlurayOutput output = glurayOutputOf(number);
  if (flags < 0 || (flags & FD_CLOEXEC) || output.descriptor < 0) return "-";
  char text[40];
  std::snprintf(text, sizeof text, "%llx.%llx", output.device, output.inode);
  return text;
}

}  // namespace

void fillClosedStreams() {
  for (int number = STDIN_FILENO; number <= STDERR_FILENO; ++number)
    if (fcntl(number, F_GETFD) < 0 && open("/dev/null", O_RDWR | O_CLOEXEC) != number) return;
}

std::string streamIdentities() { return identityOf(STDOUT_FILENO) + " " + identityOf(STDERR_FILENO); }

}  // namespace gluray::launcher
