// Reasons why a connection to the hub failed, for retries. Any thread.
#pragma once

namespace gluray::control {

enum class ConnectFailure {
  none,         // connected
  unreachable,  // nothing listens or answers there; a hub may start later
  settings,     // the address or the key file is wrong; retries fail until they change
  key,          // the hub has another key; three failures block this machine for a minute
  refused,      // the hub blocks this machine for a minute
};

}  // namespace gluray::control
