// Finds the pixels that still have their clear values (setting `background`). Used by PendingBatch, GL
// thread.
#pragma once
#include "scene/backdrop.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace gluray::gl {

/// `colors`: the framebuffer's, RGBA8, red in the lowest byte. Alpha counts where the framebuffer stores any,
/// that is where some pixel's is not 1. None where fewer than half of the pixels hold the clear colour: the
/// program has a background of its own. Throws std::bad_alloc.
std::optional<scene::Backdrop> backdropWhere(const std::vector<uint32_t>& colors,
                                             const glm::vec4& clearColor);

}  // namespace gluray::gl
