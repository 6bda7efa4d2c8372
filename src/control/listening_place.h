// A listening socket in the runtime directory, with a lock that only one process can hold. Not thread-safe.
#pragma once
#include <string>
#include <utility>

namespace gluray::control {

class ListeningPlace {
 public:
  /// `stem`: the files are named STEM.lock and STEM.sock. `what`: name for messages, such as "hub".
  ListeningPlace(std::string stem, std::string what) : stem_(std::move(stem)), what_(std::move(what)) {}
  ListeningPlace(const ListeningPlace&) = delete;
  ListeningPlace& operator=(const ListeningPlace&) = delete;
  ~ListeningPlace() { leave(); }

  /// Takes the lock. Returns an error message; empty if the lock is held. `taken`: another process holds it.
  std::string lockPlace(const std::string& directory, bool& taken);
  /// Removes the socket of an earlier process and listens. Returns a non-blocking, close-on-exec descriptor,
  /// which the caller owns, or -1 with an error message in `why`. Only while the lock is held.
  int listenHere(std::string& why);
  /// Removes the socket and releases the lock.
  void leave();

 private:
  std::string path(const char* ending) const { return directory_ + "/" + stem_ + ending; }

  const std::string stem_, what_;
  std::string directory_;
  int lock_ = -1;
  bool listens_ = false;
};

}  // namespace gluray::control
