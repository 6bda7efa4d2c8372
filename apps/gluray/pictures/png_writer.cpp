#include "pictures/png_writer.h"

#include "base/printable.h"

#include <png.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <new>
#include <stdexcept>
#include <system_error>

namespace gluray::launcher {
namespace {

/// Straight alpha, or none.
void toBytes(const std::vector<uint32_t>& pixels, bool alpha, std::vector<uint8_t>& bytes) {
  bytes.clear();
  for (const uint32_t pixel : pixels) {
    const uint32_t a = pixel >> 24;
    for (int shift = 0; shift < 24; shift += 8) {
      const uint32_t value = pixel >> shift & 255u;
      bytes.push_back(
          static_cast<uint8_t>(!alpha || a == 0 ? value : std::min(255u, (value * 255 + a / 2) / a)));
    }
    if (alpha) bytes.push_back(static_cast<uint8_t>(a));
  }
}

/// libpng's structures, freed with this. Its errors jump back into step().
class Png {
 public:
  Png() {
    if (!info_) throw std::bad_alloc();
  }
  Png(const Png&) = delete;
  Png& operator=(const Png&) = delete;
  ~Png() { png_destroy_write_struct(&png_, &info_); }
  /// Calls libpng; `call` holds nothing that would have to be destroyed. Throws std::runtime_error.
  template <class Call>
  void step(const Call& call) {
    if (!jumps(call)) throw std::runtime_error(why_);
  }

 private:
  template <class Call>
  bool jumps(const Call& call) {
    if (setjmp(png_jmpbuf(png_))) return false;
    call(png_, info_);
    return true;
  }
  static void keep(png_structp png, png_const_charp why) {
    std::snprintf(static_cast<Png*>(png_get_error_ptr(png))->why_, kMost, "%s", why);
    png_longjmp(png, 1);
  }
  static void ignore(png_structp, png_const_charp) {}

  static constexpr size_t kMost = 128;
  char why_[kMost] = "";
  png_structp png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, this, keep, ignore);
  png_infop info_ = png_ ? png_create_info_struct(png_) : nullptr;
};

void write(std::FILE* out, const PngPicture& picture) {
  std::vector<png_text> texts;
  for (const auto& [keyword, value] : picture.texts) {
    png_text& text = texts.emplace_back();
    text.compression = PNG_ITXT_COMPRESSION_NONE;
    text.key = const_cast<char*>(keyword.c_str()), text.text = const_cast<char*>(value.c_str());
  }
  Png png;
  png.step([&](png_structp p, png_infop info) {
    png_init_io(p, out);
    png_set_IHDR(p, info, static_cast<png_uint_32>(picture.width), static_cast<png_uint_32>(picture.height),
                 8, picture.alpha ? PNG_COLOR_TYPE_RGBA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(p, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_text(p, info, texts.data(), static_cast<int>(texts.size()));
    png_write_info(p, info);
  });
  std::vector<uint32_t> pixels;
  std::vector<uint8_t> bytes;
  for (int y = 0; y < picture.height; ++y) {
    picture.row(y, pixels);
    toBytes(pixels, picture.alpha, bytes);
    png.step([&](png_structp p, png_infop) { png_write_row(p, bytes.data()); });
  }
  png.step([](png_structp p, png_infop info) { png_write_end(p, info); });
}

}  // namespace

void writePng(const std::string& file, const PngPicture& picture) {
  const std::string part = file + ".part-" + std::to_string(getpid());
  const auto fail = [&](const std::string& why) {
    ::unlink(part.c_str());
    throw std::runtime_error(printable(file) + " cannot be written: " + why);
  };
  ::unlink(part.c_str());  // of a process that was killed and had our number
  std::FILE* const out = std::fopen(part.c_str(), "wbx");
  if (!out) fail(std::generic_category().message(errno));
  std::string why;
  errno = 0;
  try {
    write(out, picture);
  } catch (const std::exception& e) { why = errno != 0 ? std::generic_category().message(errno) : e.what(); }
  if (std::fclose(out) != 0 && why.empty()) why = std::generic_category().message(errno);
  if (why.empty() && std::rename(part.c_str(), file.c_str()) != 0)
    why = std::generic_category().message(errno);
  if (!why.empty()) fail(why);
}

}  // namespace gluray::launcher
