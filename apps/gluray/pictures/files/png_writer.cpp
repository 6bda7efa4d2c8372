#include "pictures/files/png_writer.h"

#include "base/files.h"
#include "base/printable.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <new>
#include <stdexcept>

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

/// The same of 16 bits, the high byte first.
void toWords(const std::vector<float>& values, bool alpha, std::vector<uint8_t>& bytes) {
  bytes.clear();
  const auto add = [&](float value) {
    const auto word = static_cast<uint32_t>(std::lround(value > 0 ? std::min(value, 1.0f) * 65535.0f : 0.0f));
    bytes.push_back(static_cast<uint8_t>(word >> 8)), bytes.push_back(static_cast<uint8_t>(word));
  };
  for (size_t i = 0; i + 3 < values.size(); i += 4) {
    const float a = alpha && values[i + 3] > 0 ? std::min(values[i + 3], 1.0f) : 1;
    for (size_t c = 0; c < 3; ++c) add(values[i + c] / a);
    if (alpha) add(values[i + 3]);
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

void append(png_structp png, png_bytep bytes, size_t count) {
  auto& draft = *static_cast<files::Draft*>(png_get_io_ptr(png));
  if (!draft.write({reinterpret_cast<const char*>(bytes), count})) png_error(png, draft.why().c_str());
}
void flush(png_structp) {}

void write(files::Draft& draft, const PngPicture& picture) {
  std::vector<png_text> texts;
  for (const auto& [keyword, value] : picture.texts) {
    png_text& text = texts.emplace_back();
    text.compression = PNG_ITXT_COMPRESSION_NONE;
    text.key = const_cast<char*>(keyword.c_str()), text.text = const_cast<char*>(value.c_str());
  }
  Png png;
  png.step([&](png_structp p, png_infop info) {
    png_set_write_fn(p, &draft, append, flush);
    png_set_IHDR(p, info, static_cast<png_uint_32>(picture.width), static_cast<png_uint_32>(picture.height),
                 picture.depth, picture.alpha ? PNG_COLOR_TYPE_RGBA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(p, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_text(p, info, texts.data(), static_cast<int>(texts.size()));
    png_write_info(p, info);
  });
  std::vector<uint32_t> pixels;
  std::vector<float> values;
  std::vector<uint8_t> bytes;
  for (int y = 0; y < picture.height; ++y) {
    if (picture.depth == 16) {
      picture.wideRow(y, values);
      toWords(values, picture.alpha, bytes);
    } else {
      picture.row(y, pixels);
      toBytes(pixels, picture.alpha, bytes);
    }
    png.step([&](png_structp p, png_infop) { png_write_row(p, bytes.data()); });
  }
  png.step([](png_structp p, png_infop info) { png_write_end(p, info); });
}

}  // namespace

void writePng(const std::string& file, const PngPicture& picture) {
  files::Draft draft(file);
  std::string why = draft.why();
  try {
    if (why.empty()) write(draft, picture);
  } catch (const std::exception& e) { why = e.what(); }
  if (why.empty() && !draft.place()) why = draft.why();
  if (!why.empty()) throw std::runtime_error(printable(file) + " cannot be written: " + why);
}

}  // namespace gluray::launcher
