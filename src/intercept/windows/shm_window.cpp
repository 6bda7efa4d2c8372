#include "intercept/windows/shm_window.h"

#include "base/timeline.h"
#include "frame/pixels/pixel_rows.h"
#include "intercept/session/guarded.h"
#include "parallel/loops.h"

#include <sys/ipc.h>
#include <sys/shm.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace gluray::intercept {
namespace {

void fillRow(const gl::ShownImage& shown, int y, int width, uint32_t* out) {
  const Image& image = shown.image;
  const uint32_t background = image.missColor, back = frame::bgra(background);
  const int from = std::clamp(image.x, 0, width),
            to = std::clamp(image.x + image.width, from, std::max(from, width));
  if (y < image.y || y >= image.y + image.height || from == to) {
    std::fill_n(out, width, back);
    return;
  }
  std::fill(out, out + from, back);
  const size_t first = static_cast<size_t>(y - image.y) * static_cast<size_t>(image.width) +
                       static_cast<size_t>(from - image.x);
  frame::toWindow(&image.color[first], &image.depth[first], shown.farthest, background,
                  static_cast<size_t>(to - from), out + from);
  std::fill(out + to, out + width, back);
}

}  // namespace

void fillWindow(const gl::ShownImage& shown, glm::ivec2 size, uint32_t* pixels) {
  constexpr int kRows = 32;  // rows per task
  forEachPart(shown.threads, (size.y + kRows - 1) / kRows, [&](int part) {
    const int first = part * kRows, end = std::min(first + kRows, size.y);
    for (int row = first; row < end; ++row)
      fillRow(shown, size.y - 1 - row, size.x,
              pixels + static_cast<size_t>(row) * static_cast<size_t>(size.x));
  });
}

std::unique_ptr<ShmWindow> ShmWindow::create(_XDisplay* display, uintptr_t drawable) noexcept try {
  if (!display || !drawable || !xcb().canPut()) return nullptr;
  xcb_connection_t* const connection = xcb().connectionOf(display);
  if (!connection) return nullptr;
  const auto window = static_cast<xcb_window_t>(drawable);
  const auto attributes = replyTo(xcb().window, connection, xcb().askWindow(connection, window));
  const auto geometry = replyTo(xcb().geometry, connection, xcb().askGeometry(connection, window));
  const xcb_query_extension_reply_t* const shm = xcb().extension(connection, xcb().shmId);
  if (!attributes || !geometry || !shm || !shm->present) return nullptr;
  if (!hasPlainPixels(connection, geometry->depth, attributes->visual)) return nullptr;
  std::unique_ptr<ShmWindow> put(new ShmWindow(display, connection, window, geometry->depth));
  return put->makeContext() && put->reserve(1) ? std::move(put) : nullptr;
} catch (const std::exception&) { return nullptr; }

ShmWindow::~ShmWindow() { close(); }

void ShmWindow::close() noexcept {
  if (!closed_ || *closed_ || isForkedChild()) return release();
  if (std::exchange(asked_, false)) replyTo(xcb().geometry, connection_, geometry_);
  if (std::exchange(sent_, false)) succeeded(put_);
  if (pixels_) xcb().detach(connection_, segment_);
  if (context_) xcb().freeGc(connection_, std::exchange(context_, 0));
  release();
}

bool ShmWindow::succeeded(xcb_void_cookie_t cookie) const {
  xcb_generic_error_t* const error = xcb().check(connection_, cookie);
  std::free(error);
  return !error;
}

bool ShmWindow::makeContext() {
  context_ = xcb().newId(connection_);
  const uint32_t noExposures = 0;
  return succeeded(xcb().createGc(connection_, context_, window_, XCB_GC_GRAPHICS_EXPOSURES, &noExposures));
}

void ShmWindow::release() {
  if (pixels_) shmdt(pixels_);
  pixels_ = nullptr;
  bytes_ = 0;
  held_ = 0;
}

/// Makes room for an image. The shared memory exists while this process or the server is attached to it.
bool ShmWindow::reserve(size_t bytes) {
  if (bytes <= bytes_) return true;
  if (pixels_) xcb().detach(connection_, segment_);
  release();
  const int id = shmget(IPC_PRIVATE, bytes, IPC_CREAT | 0600);
  if (id < 0) return false;
  void* const memory = shmat(id, nullptr, 0);
  bool attached = false;
  if (memory != reinterpret_cast<void*>(-1)) {
    pixels_ = static_cast<uint32_t*>(memory);
    segment_ = xcb().newId(connection_);
    attached = succeeded(xcb().attach(connection_, segment_, static_cast<uint32_t>(id), 1));
  }
  shmctl(id, IPC_RMID, nullptr);
  if (!attached) return release(), false;
  bytes_ = bytes;
  return true;
}

void ShmWindow::askSize() noexcept {
  if (asked_ || !isOpen()) return;
  geometry_ = xcb().askGeometry(connection_, window_);
  xcb().flush(connection_);
  asked_ = true;
}

glm::ivec2 ShmWindow::size() noexcept {
  if (!isOpen()) return glm::ivec2(0);
  if (!asked_) geometry_ = xcb().askGeometry(connection_, window_);
  asked_ = false;
  const auto reply = replyTo(xcb().geometry, connection_, geometry_);
  const bool shown = !std::exchange(sent_, false) || succeeded(put_);
  return reply && shown ? glm::ivec2(reply->width, reply->height) : glm::ivec2(0);
}

bool ShmWindow::put(const gl::ShownImage& shown, glm::ivec2 size) noexcept try {
  const timeline::Span span("show");
  const size_t pixels = static_cast<size_t>(size.x) * static_cast<size_t>(size.y);
  if (std::exchange(sent_, false) && !succeeded(put_)) return false;  // waits until the server has read it
  if (pixels == 0 || !reserve(pixels * 4)) return false;
  if (held_ != shown.number || heldSize_ != size || heldFarthest_ != shown.farthest) {
    fillWindow(shown, size, pixels_);
    held_ = shown.number, heldSize_ = size, heldFarthest_ = shown.farthest;
  }
  return send(size);
} catch (const std::exception&) { return false; }

void ShmWindow::putAgain() noexcept {
  if (held_ != 0 && !sent_ && isOpen()) send(heldSize_);
}

bool ShmWindow::send(glm::ivec2 size) {
  const auto width = static_cast<uint16_t>(size.x), height = static_cast<uint16_t>(size.y);
  put_ = xcb().putImage(connection_, window_, context_, width, height, 0, 0, width, height, 0, 0, depth_,
                        XCB_IMAGE_FORMAT_Z_PIXMAP, 0, segment_, 0);
  sent_ = true;
  return xcb().flush(connection_) > 0;
}

}  // namespace gluray::intercept
