// Images of shown frames, for the control thread. GL threads store them without waiting. Without requests, a
// swap costs one atomic load.
#pragma once
#include "control/link/program/controlled_program.h"
#include "gl/batch/presenter.h"

#include <glm/glm.hpp>

#include <atomic>
#include <cstdint>
#include <memory>

namespace gluray::intercept {

inline std::atomic<control::Wanted> g_wantedImage{control::Wanted::none};

/// Which frame to keep now. Any thread.
inline control::Wanted wantedImage() noexcept { return g_wantedImage.load(std::memory_order_relaxed); }

/// Requests an image. Control thread.
void wantWindowImage(control::Wanted wanted) noexcept;
/// Returns the kept image; null if there is none. Control thread.
std::unique_ptr<control::KeptImage> takeWindowImage() noexcept;

/// How a frame is shown.
enum class ShownFrame {
  now,   // as the program ends it
  later  // ended earlier (frame lag), or refined: not for Wanted::next
};
/// Whether to keep a frame that is shown in this way.
bool isImageWanted(ShownFrame shown) noexcept;
/// Memory for the image of a frame that is shown in a window of `size` pixels; its pixels are not set.
std::unique_ptr<control::KeptImage> newWindowImage(glm::ivec2 size, control::KeptImage::Layout layout,
                                                   ShownFrame shown);
/// Keeps the image for the control thread; it replaces an earlier one.
void keepWindowImage(std::unique_ptr<control::KeptImage> image) noexcept;

/// Call when an image was shown without a swap in a window of `size` pixels. Keeps it if requested.
void keepShownImage(const gl::ShownImage& image, glm::ivec2 size, ShownFrame shown) noexcept;
/// Call when pixels were put into a window: RGBA8, bottom row first. Keeps them if requested.
void keepPixels(const uint32_t* pixels, glm::ivec2 size) noexcept;

/// Number of images kept since the process began.
uint64_t keptImages() noexcept;

}  // namespace gluray::intercept
