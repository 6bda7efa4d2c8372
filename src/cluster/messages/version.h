// Any thread.
#pragma once

namespace gluray::cluster {

/// Equal in programs and workers that understand each other. There are no older versions that are understood:
/// a worker of another version traces other pictures.
const char* version();

}  // namespace gluray::cluster
