// Views of a saved scene from other sides. Any thread.
#pragma once
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <vector>

namespace gluray::saved {

/// The batches as a camera sees them that has gone around them by so many degrees, about the upward axis of
/// the first one's world (setting lights.up), to the right. Batches of one camera turn about the middle of
/// all their surfaces, others about their own, such as orientation markers. Lights stay at the camera. The
/// planes that cut off what is too near or too far make room for what comes nearer. What the real OpenGL drew
/// is forgotten.
std::vector<scene::SnapshotPtr> turned(const std::vector<scene::SnapshotPtr>& batches, double degrees);

}  // namespace gluray::saved
