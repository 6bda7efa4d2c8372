// Serialises the settings of a snapshot that differ from their defaults: names and values as text, so that
// other versions of GLuRay can read them. Any thread.
#pragma once
#include "cluster/stream/byte_stream.h"
#include "settings/settings.h"

namespace gluray::cluster {

void writeSettings(ByteWriter& out, const Settings& settings);
/// Throws Malformed if a value is invalid.
Settings readSettings(ByteReader& in);

}  // namespace gluray::cluster
