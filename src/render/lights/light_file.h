// Lights of a TOML file (docs/light/shadows.md has its format). Any thread.
#pragma once
#include "scene/light_source.h"

#include <glm/glm.hpp>

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::render {

struct FileLight {
  scene::LightSource light;
  bool onCamera = false;  // its space is eye space, otherwise world space
  bool operator==(const FileLight&) const = default;
};

/// "FILE:LINE: WHAT".
struct LightFileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws LightFileError. `file` names the text in errors.
std::vector<FileLight> parseLights(std::string_view text, const std::string& file);

/// Returns the lights of a file; reads the file again if it has changed. If the file is invalid, logs one
/// line and returns the last valid lights, or none. Null for an empty name.
std::shared_ptr<const std::vector<FileLight>> lightsOf(const std::string& file);

/// Transforms the light to eye space.
scene::LightSource placed(const FileLight&, const glm::dmat4& eyeFromWorld);

}  // namespace gluray::render
