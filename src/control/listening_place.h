// A listening socket in the runtime directory, with a lock that only one process can hold. On any one thread.
#pragma once
#include <string>
#include <utility>

namespace gluray::control {

class ListeningPlace {
 public:
  /// `stem`: of the files' names, STEM.lock and STEM.sock. `what`: for messages, "hub".
  ListeningPlace(std::string stem, std::string what) : stem_(std::move(stem)), what_(std::move(what)) {}
  ListeningPlace(const ListeningPlace&) = delete;
  ListeningPlace& operator=(const ListeningPlace&) = delete;
  ~ListeningPlace() { leave(); }

  /// Takes the lock. Returns why not; empty: it is held. `taken`: another process holds it.
  std::string lockPlace(const std::string& directory, bool& taken);
  /// Removes the socket of an earlier process and listens. The descriptor, which does not block and which
  /// child processes do not get, is the caller's; -1 and `why`. Only while the lock is held.
  int listenHere(std::string& why);
  /// Removes the socket and gives the lock back.
  void leave();

 private:
  std::string path(const char* ending) const { return directory_ + "/" + stem_ + ending; }

  const std::string stem_, what_;
  std::string directory_;
  int lock_ = -1;
  bool listens_ = false;
};

}  // namespace gluray::control
