// Any thread.
#pragma once

namespace gluray::cluster {

/// Protocol version, equal in compatible programs and workers. Other versions are never compatible, because a
/// worker of another version traces different images.
const char* version();

}  // namespace gluray::cluster
