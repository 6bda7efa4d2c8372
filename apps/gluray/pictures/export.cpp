#include "pictures/export.h"

#include "base/printable.h"
#include "pictures/engine_function.h"
#include "saved/program/render.h"
#include "say.h"

#include <nlohmann/json.hpp>
#include <png.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <stdexcept>

namespace gluray::launcher {
namespace {

using Export = int (*)(const GlurayExportRequest*, char*, unsigned long);

int encode(void*, int width, int height, int channels, const uint8_t* pixels,
           void (*take)(void*, const void*, unsigned long), void* into) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width), image.height = static_cast<png_uint_32>(height);
  image.format = channels == 4 ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
  image.flags = PNG_IMAGE_FLAG_FAST;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels, 0, nullptr)) return 0;
  take(into, bytes.data(), size);
  return 1;
}

void keepNote(void* user, const char* line) {
  static_cast<std::vector<std::string>*>(user)->emplace_back(line);
}

}  // namespace

std::vector<std::string> exportScene(const std::string& scene, const std::string& file) {
  std::vector<std::string> notes;
  const GlurayExportRequest request{.version = kGlurayRenderVersion,
                                    .scene = scene.c_str(),
                                    .file = file.c_str(),
                                    .user = &notes,
                                    .png = encode,
                                    .note = keepNote};
  std::array<char, 1024> why{};
  if (!engineFunction<Export>("glurayExport")(&request, why.data(), why.size()))
    throw std::runtime_error(why.data());
  return notes;
}

int exportSaved(const CommandLine& line) {
  const std::string& file = line.picture.file;
  if (!isOtherForm(file))
    return say(printable(file) + ": use a name that ends in .glb, .obj or .ply"), kUsageError;
  const std::vector<std::string> notes = exportScene(line.picture.scene, file);
  for (const std::string& note : notes) say(note);
  std::error_code error;
  const auto bytes = std::filesystem::file_size(file, error);
  if (line.json)
    std::cout << jsonText({{"file", file}, {"bytes", bytes}, {"notes", notes}}) << "\n";
  else
    std::cout << printable(file) << ", " << (bytes + 999999) / 1000000 << " MB\n";
  return 0;
}

}  // namespace gluray::launcher
