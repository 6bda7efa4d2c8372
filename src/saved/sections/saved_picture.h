// Pictures of windows in saved scenes. Any thread.
#pragma once
#include "saved/sections/section_file.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gluray::saved {

/// The pixels of a window, red in the lowest byte, bottom row first.
struct SavedPicture {
  int width = 0, height = 0;
  std::vector<uint32_t> pixels;
};

void addPicture(const SavedPicture& picture, SectionWriter& out);
/// The picture in a section's content. Throws std::runtime_error if it is damaged.
SavedPicture pictureIn(std::span<const std::byte> content);

/// Adds the picture at the end of a scene's file, which is not whole meanwhile. Empty, or one line that says
/// why it could not be written.
std::string appendPicture(const std::string& path, const SavedPicture& picture);

}  // namespace gluray::saved
