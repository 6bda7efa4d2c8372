// Reasons of failed connections to the hub, for retries. Any thread.
#pragma once

namespace gluray::control {

enum class ConnectFailure {
  none,         // there is one
  unreachable,  // nothing listens or answers there: it may come
  settings,     // the address or the key file is wrong: it will not come before they change
  key,          // the hub has another key; after three attempts it refuses this machine for a minute
  refused,      // the hub refuses this machine for a minute
};

}  // namespace gluray::control
