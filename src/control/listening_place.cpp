#include "control/listening_place.h"

#include "control/runtime_directory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace gluray::control {
namespace {

constexpr int kBacklog = 256;

std::string whyOfSystem(const std::string& path) {
  return path + ": " + std::error_code(errno, std::generic_category()).message();
}

/// Removes a socket or a link. Other files are not GLuRay's.
std::string removeOldSocket(const std::string& path) {
  struct stat status {};
  if (lstat(path.c_str(), &status) != 0) return errno == ENOENT ? "" : whyOfSystem(path);
  if (!S_ISSOCK(status.st_mode) && !S_ISLNK(status.st_mode)) return path + " is no socket; remove it";
  return unlink(path.c_str()) == 0 ? "" : whyOfSystem(path);
}

}  // namespace

std::string ListeningPlace::lockPlace(const std::string& directory, bool& taken) {
  taken = false;
  if (std::string why = makeRuntimeDirectory(directory); !why.empty()) return why;
  directory_ = directory;
  const std::string path = this->path(".lock");
  const int lock = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0600);
  if (lock < 0) return errno == ELOOP ? path + " is a symbolic link; remove it" : whyOfSystem(path);
  struct stat status {};
  std::string why;
  if (fstat(lock, &status) != 0)
    why = whyOfSystem(path);
  else if (!S_ISREG(status.st_mode) || status.st_uid != geteuid())
    why = path + " is no file of yours; remove it";
  else if (flock(lock, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    taken = true, why = "another " + what_ + " runs already in " + directory;
  else if (flock(lock, LOCK_EX | LOCK_NB) != 0)
    why = whyOfSystem(path);
  if (!why.empty()) return close(lock), why;
  lock_ = lock;
  return "";
}

int ListeningPlace::listenHere(std::string& why) {
  const std::string path = this->path(".sock");
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path)
    return why = path + ": the path is too long for a socket; set GLURAY_RUNTIME to a shorter one", -1;
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  if (why = removeOldSocket(path); !why.empty()) return -1;
  const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  // The mode is independent of the umask, and never wider than this.
  if (socket < 0 || fchmod(socket, 0600) != 0 ||
      bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      chmod(path.c_str(), 0600) != 0 || listen(socket, kBacklog) != 0) {
    why = whyOfSystem(path);
    if (socket >= 0) close(socket);
    return -1;
  }
  listens_ = true;
  return socket;
}

void ListeningPlace::leave() {
  if (lock_ < 0) return;
  if (listens_) unlink(path(".sock").c_str());
  flock(lock_, LOCK_UN);  // also releases it for child processes that inherited the descriptor
  close(lock_);
  lock_ = -1;
  listens_ = false;
}

}  // namespace gluray::control
