#include "saved/exr/exr_writer.h"

#include "base/files.h"
#include "base/printable.h"

#include <stdexcept>

#ifdef GLURAY_OPENEXR
#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <thread>

namespace gluray::saved {
namespace {

constexpr int kZipRows = 16;  // rows that are compressed together

/// A draft as OpenEXR writes it: the table of rows stands before them, and is known after them.
class DraftStream final : public Imf::OStream {
 public:
  explicit DraftStream(files::Draft& draft) : Imf::OStream("picture"), draft_(draft) {}
  void write(const char from[], int count) override {
    const std::string_view bytes(from, static_cast<size_t>(std::max(count, 0)));
    if (!draft_.writeAt(at_, bytes)) throw std::runtime_error(draft_.why());
    at_ += bytes.size();
  }
  uint64_t tellp() override { return at_; }
  void seekp(uint64_t at) override { at_ = at; }

 private:
  files::Draft& draft_;
  uint64_t at_ = 0;
};

/// Threads that compress rows, while it exists.
struct Compressors {
  const int count = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 32u));
  Compressors() { Imf::setGlobalThreadCount(count); }
  ~Compressors() { Imf::setGlobalThreadCount(0); }
  Compressors(const Compressors&) = delete;
  Compressors& operator=(const Compressors&) = delete;
};

Imf::Header headerOf(const ExrPicture& picture) {
  Imf::Header header(picture.width, picture.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::addChromaticities(header, Imf::Chromaticities());  // by default those of Rec. 709
  for (const auto& [name, text] : picture.texts) header.insert(name, Imf::StringAttribute(text));
  for (const ExrChannel& channel : picture.channels)
    header.channels().insert(channel.name, Imf::Channel(channel.half ? Imf::HALF : Imf::FLOAT));
  return header;
}

/// Some rows as they are stored: those of a channel one after the other, in its precision.
class Rows {
 public:
  Rows(const ExrPicture& picture, int count) : picture_(picture), count_(count) {
    values_.resize(static_cast<size_t>(picture.width) * picture.channels.size());
    for (const ExrChannel& channel : picture.channels)
      planes_.emplace_back(static_cast<size_t>(picture.width) * static_cast<size_t>(count) *
                           (channel.half ? sizeof(::half) : sizeof(float)));
  }
  /// Takes the rows from `y` on.
  void fill(int y) {
    first_ = y;
    for (int row = 0; row < std::min(count_, picture_.height - y); ++row) {
      picture_.row(y + row, values_.data());
      for (size_t c = 0; c < planes_.size(); ++c) keep(c, static_cast<size_t>(row));
    }
  }
  Imf::FrameBuffer buffer() {
    Imf::FrameBuffer buffer;
    for (size_t c = 0; c < planes_.size(); ++c) {
      const ExrChannel& channel = picture_.channels[c];
      const size_t size = channel.half ? sizeof(::half) : sizeof(float),
                   stride = size * static_cast<size_t>(picture_.width);
      // OpenEXR counts from row 0.
      char* const base = planes_[c].data() - static_cast<ptrdiff_t>(stride) * first_;
      buffer.insert(channel.name, Imf::Slice(channel.half ? Imf::HALF : Imf::FLOAT, base, size, stride));
    }
    return buffer;
  }

 private:
  void keep(size_t c, size_t row) {
    const auto width = static_cast<size_t>(picture_.width);
    const size_t channels = planes_.size();
    const auto fill = [&](auto* to) {
      for (size_t x = 0; x < width; ++x)
        to[row * width + x] = std::remove_reference_t<decltype(*to)>(values_[x * channels + c]);
    };
    if (picture_.channels[c].half)
      fill(reinterpret_cast<::half*>(planes_[c].data()));
    else
      fill(reinterpret_cast<float*>(planes_[c].data()));
  }

  const ExrPicture& picture_;
  int count_, first_ = 0;
  std::vector<float> values_;  // of a row
  std::vector<std::vector<char>> planes_;
};

void write(files::Draft& draft, const ExrPicture& picture) {
  const Compressors compressors;
  DraftStream stream(draft);
  Imf::OutputFile file(stream, headerOf(picture), compressors.count);
  const int rows = kZipRows * compressors.count;
  Rows some(picture, std::min(rows, picture.height));
  for (int y = 0; y < picture.height; y += rows) {
    some.fill(y);
    file.setFrameBuffer(some.buffer());
    file.writePixels(std::min(rows, picture.height - y));
  }
}

}  // namespace

bool canWriteExr() { return true; }

void writeExr(const std::string& path, const ExrPicture& picture) {
  files::Draft draft(path);
  std::string why = draft.why();
  try {
    if (why.empty()) write(draft, picture);
  } catch (const std::exception& e) { why = draft.why().empty() ? e.what() : draft.why(); }
  if (why.empty() && !draft.place()) why = draft.why();
  if (!why.empty()) throw std::runtime_error(printable(path) + " cannot be written: " + why);
}

}  // namespace gluray::saved

#else
namespace gluray::saved {

bool canWriteExr() { return false; }

void writeExr(const std::string& path, const ExrPicture&) {
  throw std::runtime_error(printable(path) + " cannot be written: this GLuRay was built without OpenEXR");
}

}  // namespace gluray::saved
#endif
