#include "render/lights/sky_files.h"

#include <stdexcept>

#ifdef GLURAY_OPENEXR
#include <ImfArray.h>
#include <ImfIO.h>
#include <ImfRgbaFile.h>

#include <algorithm>
#include <cstring>

namespace gluray::render {
namespace {

/// A file's content as OpenEXR reads it.
class MemoryStream final : public Imf::IStream {
 public:
  explicit MemoryStream(const std::string& bytes) : Imf::IStream("environment"), bytes_(bytes) {}
  bool read(char to[], int count) override {
    const auto n = static_cast<size_t>(std::max(count, 0));
    if (n > bytes_.size() - at_) throw std::runtime_error("the image ends early");
    std::memcpy(to, bytes_.data() + at_, n);
    at_ += n;
    return at_ < bytes_.size();
  }
  uint64_t tellg() override { return at_; }
  void seekg(uint64_t at) override { at_ = std::min(static_cast<size_t>(at), bytes_.size()); }

 private:
  const std::string& bytes_;
  size_t at_ = 0;
};

}  // namespace

SkyPixels readOpenExr(const std::string& bytes) {
  constexpr int64_t kMaxPixels = int64_t{1} << 25;
  MemoryStream stream(bytes);
  Imf::RgbaInputFile file(stream, 0);  // on this thread
  const auto window = file.dataWindow();
  const int64_t width = int64_t{window.max.x} - window.min.x + 1,
                height = int64_t{window.max.y} - window.min.y + 1;
  if (width <= 0 || height <= 0 || width > kMaxPixels || height > kMaxPixels / width)
    throw std::runtime_error("the image has more than 33 million pixels");
  Imf::Array<Imf::Rgba> row(static_cast<long>(width));
  SkyPixels image{static_cast<int>(width), static_cast<int>(height),
                  std::vector<glm::vec3>(static_cast<size_t>(width * height))};
  for (int64_t y = 0; y < height; ++y) {
    const auto line = static_cast<int>(window.min.y + y);
    file.setFrameBuffer(&row[0] - window.min.x, 1, 0);
    file.readPixels(line);
    for (int64_t x = 0; x < width; ++x) {
      const Imf::Rgba& p = row[static_cast<long>(x)];
      image.pixels[static_cast<size_t>(y * width + x)] = {float(p.r), float(p.g), float(p.b)};
    }
  }
  return image;
}

}  // namespace gluray::render

#else
namespace gluray::render {

SkyPixels readOpenExr(const std::string&) {
  throw std::runtime_error("this GLuRay was built without OpenEXR; Radiance images (.hdr) can be read");
}

}  // namespace gluray::render
#endif
