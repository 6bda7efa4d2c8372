#include "intercept/windows/window_pictures.h"

#include "intercept/session/guarded.h"
#include "intercept/windows/shm_window.h"
#include "settings/live/settings_source.h"

#include <algorithm>
#include <utility>

namespace gluray::intercept {
namespace {

using control::KeptPicture, control::Wanted;

std::atomic<KeptPicture*> g_keptPicture{nullptr};
std::atomic<uint64_t> g_keptPictures{0};

}  // namespace

bool isPictureWanted(ShownFrame shown) noexcept {
  const Wanted wanted = wantedPicture();
  return wanted == Wanted::any || (wanted == Wanted::next && shown == ShownFrame::now);
}

std::unique_ptr<KeptPicture> newWindowPicture(glm::ivec2 size, KeptPicture::Layout layout, ShownFrame shown) {
  auto picture = std::make_unique<KeptPicture>();
  picture->width = size.x, picture->height = size.y, picture->layout = layout;
  picture->pixels.resize(static_cast<size_t>(size.x) * static_cast<size_t>(size.y));
  picture->frame = shown == ShownFrame::now ? settingsSource().frame() : 0;
  picture->next = shown == ShownFrame::now && wantedPicture() == Wanted::next;
  return picture;
}

void keepWindowPicture(std::unique_ptr<KeptPicture> picture) noexcept {
  delete g_keptPicture.exchange(picture.release());
  g_wantedPicture.store(Wanted::none, std::memory_order_relaxed);  // until the control thread asks again
  ++g_keptPictures;
}

void wantWindowPicture(Wanted wanted) noexcept { g_wantedPicture.store(wanted, std::memory_order_relaxed); }

std::unique_ptr<KeptPicture> takeWindowPicture() noexcept {
  return std::unique_ptr<KeptPicture>(g_keptPicture.exchange(nullptr));
}

uint64_t keptPictures() noexcept { return g_keptPictures; }

void keepShownPicture(const gl::ShownPicture& shown, glm::ivec2 size, ShownFrame when) noexcept {
  if (!isPictureWanted(when) || size.x <= 0 || size.y <= 0) return;
  guarded("cannot keep a picture", [&] {
    auto picture = newWindowPicture(size, KeptPicture::Layout::x, when);
    fillWindow(shown, size, picture->pixels.data());
    keepWindowPicture(std::move(picture));
  });
}

void keepPixels(const uint32_t* pixels, glm::ivec2 size) noexcept {
  if (!isPictureWanted(ShownFrame::later) || size.x <= 0 || size.y <= 0) return;
  guarded("cannot keep a picture", [&] {
    auto picture = newWindowPicture(size, KeptPicture::Layout::openGl, ShownFrame::later);
    picture->frame = settingsSource().begun().frame;  // the program draws nothing
    std::copy_n(pixels, picture->pixels.size(), picture->pixels.data());
    keepWindowPicture(std::move(picture));
  });
}

}  // namespace gluray::intercept
