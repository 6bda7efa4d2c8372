// Pictures of shown frames for the control thread. GL threads store them without waiting; without requests, a
// swap costs one atomic load.
#pragma once
#include "control/link/program/controlled_program.h"
#include "gl/batch/presenter.h"

#include <glm/glm.hpp>

#include <atomic>
#include <cstdint>
#include <memory>

namespace gluray::intercept {

inline std::atomic<control::Wanted> g_wantedPicture{control::Wanted::none};

/// Which frame is to be kept now. Any thread.
inline control::Wanted wantedPicture() noexcept { return g_wantedPicture.load(std::memory_order_relaxed); }

/// Control thread.
void wantWindowPicture(control::Wanted wanted) noexcept;
std::unique_ptr<control::KeptPicture> takeWindowPicture() noexcept;

/// How a frame is shown.
enum class ShownFrame {
  now,   // as the program ends it
  later  // it ended before (frame lag), or gets better: no answer to Wanted::next
};
/// Whether a frame that is shown so is to be kept.
bool isPictureWanted(ShownFrame shown) noexcept;
/// Room for the picture of a frame that is shown in a window of `size` pixels; its pixels are not set.
std::unique_ptr<control::KeptPicture> newWindowPicture(glm::ivec2 size, control::KeptPicture::Layout layout,
                                                       ShownFrame shown);
/// Keeps it for the control thread, in place of an earlier one.
void keepWindowPicture(std::unique_ptr<control::KeptPicture> picture) noexcept;

/// Call when a picture was shown without a swap in a window of `size` pixels. Keeps it if wanted.
void keepShownPicture(const gl::ShownPicture& picture, glm::ivec2 size, ShownFrame shown) noexcept;
/// Call when pixels were put into a window: RGBA8, bottom row first. Keeps them if wanted.
void keepPixels(const uint32_t* pixels, glm::ivec2 size) noexcept;

/// Pictures that were kept since the process began.
uint64_t keptPictures() noexcept;

}  // namespace gluray::intercept
