#include "render/lights/sky_files.h"

#include "base/files.h"

#include <stdexcept>

namespace gluray::render {

SkyPixels readSkyPixels(const std::string& path) {
  constexpr size_t kMaxBytes = size_t{1} << 29;
  const files::Content content = files::read(path, kMaxBytes);
  if (!content.why.empty()) throw std::runtime_error(content.why);
  if (content.text.starts_with("#?")) return readRadiance(content.text);
  if (content.text.starts_with("\x76\x2f\x31\x01")) return readOpenExr(content.text);
  throw std::runtime_error("it is neither a Radiance nor an OpenEXR image");
}

}  // namespace gluray::render
