// Images of shown frames for the control thread. GL threads store them without waiting; without requests, a
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

/// Which frame is to be kept now. Any thread.
inline control::Wanted wantedImage() noexcept { return g_wantedImage.load(std::memory_order_relaxed); }

/// Control thread.
void wantWindowImage(control::Wanted wanted) noexcept;
std::unique_ptr<control::KeptImage> takeWindowImage() noexcept;

/// How a frame is shown.
enum class ShownFrame {
  now,   // as the program ends it
  later  // it ended before (frame lag), or gets better: no answer to Wanted::next
};
/// Whether a frame that is shown so is to be kept.
bool isImageWanted(ShownFrame shown) noexcept;
/// Room for the image of a frame that is shown in a window of `size` pixels; its pixels are not set.
std::unique_ptr<control::KeptImage> newWindowImage(glm::ivec2 size, control::KeptImage::Layout layout,
                                                   ShownFrame shown);
/// Keeps it for the control thread, in place of an earlier one.
void keepWindowImage(std::unique_ptr<control::KeptImage> image) noexcept;

/// Call when an image was shown without a swap in a window of `size` pixels. Keeps it if wanted.
void keepShownImage(const gl::ShownImage& image, glm::ivec2 size, ShownFrame shown) noexcept;
/// Call when pixels were put into a window: RGBA8, bottom row first. Keeps them if wanted.
void keepPixels(const uint32_t* pixels, glm::ivec2 size) noexcept;

/// Images that were kept since the process began.
uint64_t keptImages() noexcept;

}  // namespace gluray::intercept
