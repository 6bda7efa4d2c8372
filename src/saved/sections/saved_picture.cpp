#include "saved/sections/saved_picture.h"

#include <array>
#include <cstring>
#include <exception>
#include <stdexcept>

namespace gluray::saved {

using Size = std::array<uint64_t, 2>;

void addPicture(const SavedPicture& picture, SectionWriter& out) {
  const Size size = {static_cast<uint64_t>(picture.width), static_cast<uint64_t>(picture.height)};
  const auto pixels = std::as_bytes(std::span(picture.pixels));
  out.add(Kind::picture, 0, {}, sizeof size + pixels.size(), [&](const SectionWriter::Write& write) {
    write(std::as_bytes(std::span(size)));
    write(pixels);
  });
}

SavedPicture pictureIn(std::span<const std::byte> content) {
  constexpr uint64_t kMost = 1 << 16;
  Size size{};
  const bool sized = content.size() >= sizeof size;
  if (sized) std::memcpy(size.data(), content.data(), sizeof size);
  if (!sized || size[0] > kMost || size[1] > kMost ||
      content.size() - sizeof size != sizeof(uint32_t) * size[0] * size[1])
    throw std::runtime_error("it is damaged: save it again");
  SavedPicture picture{static_cast<int>(size[0]), static_cast<int>(size[1]), {}};
  picture.pixels.resize(size[0] * size[1]);
  const auto pixels = std::as_writable_bytes(std::span(picture.pixels));
  if (!pixels.empty()) std::memcpy(pixels.data(), content.data() + sizeof size, pixels.size());
  return picture;
}

std::string appendPicture(const std::string& path, const SavedPicture& picture) {
  try {
    SectionWriter out(path, SectionWriter::Append{});
    addPicture(picture, out);
    return out.finish() ? "" : out.why();
  } catch (const std::exception& e) { return e.what(); }
}

}  // namespace gluray::saved
