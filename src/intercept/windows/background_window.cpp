#include "intercept/windows/background_window.h"

#include "base/guarded_write.h"
#include "frame/pixels/pixel_rows.h"
#include "intercept/window_systems/xcb.h"

#include <algorithm>
#include <exception>
#include <vector>

namespace gluray::intercept {
namespace {

class XcbBackgroundWindow final : public BackgroundWindow {
 public:
  XcbBackgroundWindow(const std::string& display, uint32_t window)
      : connection_(xcb().connect(display.c_str(), nullptr)), window_(window) {
    if (!xcb().failed(connection_)) socket_ = glurayOutputOf(xcb().descriptorOf(connection_));
  }
  /// If the program has closed the connection's descriptor, the connection is never freed: XCB would close
  /// the number again.
  ~XcbBackgroundWindow() override {
    if (socket_.descriptor < 0 || isConnected()) xcb().disconnect(connection_);
  }

  bool ready() {
    if (xcb().failed(connection_)) return false;
    const auto geometry = askGeometry();
    const auto attributes = replyTo(xcb().window, connection_, xcb().askWindow(connection_, window_));
    if (!geometry || !attributes || !hasPlainPixels(connection_, geometry->depth, attributes->visual))
      return false;
    depth_ = geometry->depth;
    context_ = xcb().newId(connection_);
    return succeeded(xcb().createGc(connection_, context_, window_, 0, nullptr));
  }

  bool read(WindowPixels& out) noexcept override {
    try {
      if (!isConnected()) return false;
      const auto geometry = askGeometry();
      if (!geometry || geometry->width == 0 || !xcb().askImage) return false;
      const auto cookie = xcb().askImage(connection_, XCB_IMAGE_FORMAT_Z_PIXMAP, window_, 0, 0,
                                         geometry->width, geometry->height, ~uint32_t{0});
      const auto image = replyTo(xcb().image, connection_, cookie);
      const size_t width = geometry->width, pixels = width * geometry->height;
      if (!image || static_cast<size_t>(xcb().imageLength(image.get())) < pixels * sizeof(uint32_t))
        return false;
      const auto* const top = reinterpret_cast<const uint32_t*>(xcb().imageBytes(image.get()));
      out.width = geometry->width, out.height = geometry->height;
      out.colors.resize(pixels);
      for (size_t row = 0; row < geometry->height; ++row)
        std::transform(top + row * width, top + (row + 1) * width,
                       out.colors.data() + (geometry->height - 1 - row) * width, frame::bgra);
      return true;
    } catch (const std::exception&) { return false; }
  }

  bool paint(const uint32_t* pixels, glm::ivec2 size) noexcept override {
    try {
      if (!isConnected()) return false;
      const auto geometry = askGeometry();
      return geometry && geometry->width == size.x && geometry->height == size.y && put(pixels, size);
    } catch (const std::exception&) { return false; }
  }

 private:
  /// Whether the descriptor still refers to the connection.
  bool isConnected() const { return glurayIsSame(&socket_); }

  ReplyPtr<xcb_get_geometry_reply_t> askGeometry() const {
    return replyTo(xcb().geometry, connection_, xcb().askGeometry(connection_, window_));
  }

  bool succeeded(xcb_void_cookie_t cookie) const {
    xcb_generic_error_t* const error = xcb().check(connection_, cookie);
    std::free(error);
    return !error;
  }

  /// Sends rows from top to bottom, as many per request as the server accepts.
  bool put(const uint32_t* pixels, glm::ivec2 size) {
    constexpr size_t kHeader = 64, kUnit = 4;  // bytes; requests are counted in units
    const auto width = static_cast<size_t>(size.x);
    const size_t most = xcb().longestRequest(connection_) * kUnit - kHeader;
    const int rows = static_cast<int>(std::min(most / (width * kUnit), static_cast<size_t>(size.y)));
    if (rows < 1) return false;
    rows_.resize(width * static_cast<size_t>(rows));
    bool done = true;
    for (int top = 0; top < size.y && done; top += rows) {
      const int count = std::min(rows, size.y - top);
      for (int row = 0; row < count; ++row) {
        const uint32_t* const from = pixels + width * static_cast<size_t>(size.y - 1 - top - row);
        std::transform(from, from + width, rows_.data() + width * static_cast<size_t>(row), frame::bgra);
      }
      done = isConnected() &&
             succeeded(xcb().putWords(connection_, XCB_IMAGE_FORMAT_Z_PIXMAP, window_, context_,
                                      static_cast<uint16_t>(size.x), static_cast<uint16_t>(count), 0,
                                      static_cast<int16_t>(top), 0, depth_,
                                      static_cast<uint32_t>(width * kUnit * static_cast<size_t>(count)),
                                      reinterpret_cast<const uint8_t*>(rows_.data())));
    }
    return done;
  }

  xcb_connection_t* connection_;
  GlurayOutput socket_ = glurayNoOutput();
  uint32_t window_;
  xcb_gcontext_t context_ = 0;
  uint8_t depth_ = 0;
  std::vector<uint32_t> rows_;  // reused memory
};

}  // namespace

std::unique_ptr<BackgroundWindow> BackgroundWindow::open(const std::string& display, uint32_t window) {
  if (!xcb().connectionOf || !xcb().putWords || !xcb().descriptorOf) return nullptr;
  auto opened = std::make_unique<XcbBackgroundWindow>(display, window);
  return opened->ready() ? std::move(opened) : nullptr;
}

}  // namespace gluray::intercept
