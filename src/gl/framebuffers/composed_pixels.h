// Recognises the composed image of an MPI program's ranks in a framebuffer. Pure functions, any thread.
#pragma once
#include <cstdint>
#include <vector>

namespace gluray::gl {

/// Whether a draw has composed the image that a rank shows over the framebuffer's earlier contents. Each
/// pixel of `after` must be that of `before`, or that of `shown` blended over it by `shown`'s alpha
/// (premultiplied colours, within one step of 255; exact if alpha is 255), and no surface that covers a whole
/// pixel may be missing. All images are RGBA8, red in the lowest byte, of equal size. `empty`: the pixel
/// value of `shown` where it has no surface.
bool isComposed(const std::vector<uint32_t>& before, const std::vector<uint32_t>& shown, uint32_t empty,
                const std::vector<uint32_t>& after);

}  // namespace gluray::gl
