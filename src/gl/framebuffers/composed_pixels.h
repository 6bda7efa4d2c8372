// Recognises the composed image of an MPI program's ranks in a framebuffer. Pure functions, any thread.
#pragma once
#include <cstdint>
#include <vector>

namespace gluray::gl {

/// Whether a draw has composed the image that a rank shows over what the framebuffer held: each pixel of
/// `after` is that of `before` or that of `shown`, blended over it by `shown`'s alpha (premultiplied colours,
/// to one step of 255; exact where alpha is 255), and no surface that covers a pixel in full is missing. All
/// are RGBA8, red in the lowest byte, of equal size. `empty`: the pixel value of `shown` where it has no
/// surface.
bool isComposed(const std::vector<uint32_t>& before, const std::vector<uint32_t>& shown, uint32_t empty,
                const std::vector<uint32_t>& after);

}  // namespace gluray::gl
