#include "cluster/messages/version.h"

namespace gluray::cluster {

// The number behind it rises with each change of messages or of the scene's types between two releases.
const char* version() { return GLURAY_VERSION " (10)"; }

}  // namespace gluray::cluster
