// The hub's place in the runtime directory: the lock that only one hub holds, and the socket. On any one
// thread.
#pragma once
#include <string>

namespace gluray::control {

class HubPlace {
 public:
  HubPlace() = default;
  HubPlace(const HubPlace&) = delete;
  HubPlace& operator=(const HubPlace&) = delete;
  ~HubPlace() { leave(); }

  /// Takes the lock. Returns why not; empty: it is held. `otherHub`: another hub holds it.
  std::string take(const std::string& directory, bool& otherHub);
  /// Removes the socket of an earlier hub and listens. The descriptor, which does not block and which child
  /// processes do not get, is the caller's; -1 and `why`. Only while the lock is held.
  int listenHere(std::string& why);
  /// Removes the socket and gives the lock back.
  void leave();

 private:
  std::string directory_;
  int lock_ = -1;
  bool listens_ = false;
};

}  // namespace gluray::control
