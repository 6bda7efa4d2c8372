// The environment that settings ask for. Called once a frame, before tiles are traced.
#pragma once
#include "render/lights/environment.h"
#include "settings/settings.h"

#include <memory>

namespace gluray::render {

/// In the eye space of a view. Pictures are read once and kept while their file stays the same; only the last
/// one is. Where a file cannot be read, the last one that could stays, or a constant environment, and one
/// line is logged.
std::shared_ptr<const Environment> makeEnvironment(const Settings&, const glm::dmat4& eyeFromWorld);

/// The rotation from eye space to the sky's: y is up, the environment's rotation is applied.
glm::mat3 skyFromEye(const Settings&, const glm::dmat4& eyeFromWorld);

}  // namespace gluray::render
