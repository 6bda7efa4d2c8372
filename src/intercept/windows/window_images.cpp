#include "intercept/windows/window_images.h"

#include "intercept/session/guarded.h"
#include "intercept/windows/shm_window.h"
#include "settings/live/settings_source.h"

#include <algorithm>
#include <utility>

namespace gluray::intercept {
namespace {

using control::KeptImage, control::Wanted;

std::atomic<KeptImage*> g_keptImage{nullptr};
std::atomic<uint64_t> g_keptImages{0};

}  // namespace

bool isImageWanted(ShownFrame shown) noexcept {
  const Wanted wanted = wantedImage();
  return wanted == Wanted::any || (wanted == Wanted::next && shown == ShownFrame::now);
}

std::unique_ptr<KeptImage> newWindowImage(glm::ivec2 size, KeptImage::Layout layout, ShownFrame shown) {
  auto image = std::make_unique<KeptImage>();
  image->width = size.x, image->height = size.y, image->layout = layout;
  image->pixels.resize(static_cast<size_t>(size.x) * static_cast<size_t>(size.y));
  image->frame = shown == ShownFrame::now ? settingsSource().frame() : 0;
  image->next = shown == ShownFrame::now && wantedImage() == Wanted::next;
  return image;
}

void keepWindowImage(std::unique_ptr<KeptImage> image) noexcept {
  delete g_keptImage.exchange(image.release());
  g_wantedImage.store(Wanted::none, std::memory_order_relaxed);  // until the next request
  ++g_keptImages;
}

void wantWindowImage(Wanted wanted) noexcept { g_wantedImage.store(wanted, std::memory_order_relaxed); }

std::unique_ptr<KeptImage> takeWindowImage() noexcept {
  return std::unique_ptr<KeptImage>(g_keptImage.exchange(nullptr));
}

uint64_t keptImages() noexcept { return g_keptImages; }

void keepShownImage(const gl::ShownImage& shown, glm::ivec2 size, ShownFrame when) noexcept {
  if (!isImageWanted(when) || size.x <= 0 || size.y <= 0) return;
  guarded("cannot keep an image", [&] {
    auto image = newWindowImage(size, KeptImage::Layout::x, when);
    fillWindow(shown, size, image->pixels.data());
    keepWindowImage(std::move(image));
  });
}

void keepPixels(const uint32_t* pixels, glm::ivec2 size) noexcept {
  if (!isImageWanted(ShownFrame::later) || size.x <= 0 || size.y <= 0) return;
  guarded("cannot keep an image", [&] {
    auto image = newWindowImage(size, KeptImage::Layout::openGl, ShownFrame::later);
    image->frame = settingsSource().begun().frame;  // the program is idle
    std::copy_n(pixels, image->pixels.size(), image->pixels.data());
    keepWindowImage(std::move(image));
  });
}

}  // namespace gluray::intercept
