// Makes the environment of the settings. Called once a frame, before tiles are traced.
#pragma once
#include "render/lights/environment.h"
#include "settings/settings.h"

#include <memory>

namespace gluray::render {

/// Makes the environment in the eye space of a view. The last image stays in memory while its file does not
/// change. If a file cannot be read, logs one line and uses the last valid image, or a constant
/// environment.
std::shared_ptr<const Environment> makeEnvironment(const Settings&, const glm::dmat4& eyeFromWorld);

/// Rotation from eye space to sky space, in which y is up; includes the environment's rotation.
glm::mat3 skyFromEye(const Settings&, const glm::dmat4& eyeFromWorld);

}  // namespace gluray::render
