// The identity of what a saved scene shows. Any thread.
#pragma once
#include "saved/scene/saved_scene.h"

#include <string>

namespace gluray::saved {

/// A hash of all that pictures of the scene are made from: surfaces, lights, cameras, settings, and what the
/// window showed; 32 hexadecimal digits. Scenes that a program saves twice without a change have the same
/// one, however many frames it has shown between. Throws std::bad_alloc.
std::string hashOf(const SavedScene& scene);

}  // namespace gluray::saved
