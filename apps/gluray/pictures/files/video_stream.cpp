#include "pictures/files/video_stream.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <csignal>
#include <numeric>
#include <stdexcept>
#include <system_error>

namespace gluray::launcher {
namespace {

using Channels = std::array<double, 3>;  // red, green, blue: 0 to 255

// ITU-R BT.709-6, section 3.
constexpr double kRed = 0.2126, kGreen = 0.7152, kBlue = 0.0722;

double lumaOf(const Channels& c) { return kRed * c[0] + kGreen * c[1] + kBlue * c[2]; }

char byteOf(double value) { return static_cast<char>(static_cast<uint8_t>(std::lround(value))); }

Channels channelsOf(uint32_t pixel) {
  return {static_cast<double>(pixel & 255), static_cast<double>(pixel >> 8 & 255),
          static_cast<double>(pixel >> 16 & 255)};
}

constexpr int kMostRate = 1000;

bool readWhole(const char*& at, const char* end, int& value) {
  const auto read = std::from_chars(at, end, value);
  at = read.ptr;
  return read.ec == std::errc();
}

}  // namespace

std::string readFrameRate(const std::string& text, FrameRate& rate) {
  const char* at = text.data();
  const char* const end = at + text.size();
  FrameRate read;
  bool good = readWhole(at, end, read.number) && read.number >= 0;
  if (good && at != end && *at == '/') {
    good = readWhole(++at, end, read.divisor);
  } else if (good && at != end && *at == '.') {
    for (++at; good && at != end && *at >= '0' && *at <= '9' && read.divisor < 1000; ++at)
      read.number = read.number * 10 + (*at - '0'), read.divisor *= 10;
  }
  good = good && at == end && read.divisor > 0 && read.number > 0 && read.number / read.divisor <= kMostRate;
  if (!good) return "--fps " + text + ": use a number of frames a second, such as 25, 29.97 or 24000/1001";
  const int common = std::gcd(read.number, read.divisor);
  rate = {read.number / common, read.divisor / common};
  return "";
}

std::string videoHead(int width, int height, const FrameRate& rate) {
  return "YUV4MPEG2 W" + std::to_string(width) + " H" + std::to_string(height) + " F" +
         std::to_string(rate.number) + ':' + std::to_string(rate.divisor) +
         " Ip A1:1 C420jpeg XYSCSS=420JPEG XCOLORRANGE=LIMITED\n";
}

void addVideoFrame(const std::vector<uint32_t>& pixels, int width, int height, std::string& to) {
  const auto at = [&](int x, int y) {
    const int column = std::min(x, width - 1), row = std::min(y, height - 1);
    return channelsOf(
        pixels[static_cast<size_t>(row) * static_cast<size_t>(width) + static_cast<size_t>(column)]);
  };
  const int wide = width + width % 2, high = height + height % 2;
  to += "FRAME\n";
  for (int y = 0; y < high; ++y)
    for (int x = 0; x < wide; ++x) to += byteOf(16 + 219 * lumaOf(at(x, y)) / 255);
  const auto addChroma = [&](size_t channel, double share) {
    for (int y = 0; y < high; y += 2)
      for (int x = 0; x < wide; x += 2) {
        Channels mean{};
        for (const Channels& v : {at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)})
          for (size_t c = 0; c < 3; ++c) mean[c] += v[c] / 4;
        to += byteOf(128 + 224 * (mean[channel] - lumaOf(mean)) / (2 * (1 - share)) / 255);
      }
  };
  addChroma(2, kBlue), addChroma(0, kRed);
}

VideoStream::VideoStream(const FrameRate& rate) : rate_(rate) {
  if (::isatty(STDOUT_FILENO))
    throw std::runtime_error("--y4m: standard output is a terminal; use a pipe to an encoder, or a file");
  std::signal(SIGPIPE, SIG_IGN);
}

void VideoStream::begin(int width, int height) {
  width_ = width, height_ = height;
  if (frames_ == 0) write(videoHead(width + width % 2, height + height % 2, rate_));
  pixels_.clear();
  pixels_.reserve(static_cast<size_t>(width) * static_cast<size_t>(height));
}

void VideoStream::add(int count, const uint32_t* pixels) {
  pixels_.insert(pixels_.end(), pixels, pixels + static_cast<ptrdiff_t>(count) * width_);
}

void VideoStream::end() {
  bytes_.clear();
  addVideoFrame(pixels_, width_, height_, bytes_);
  write(bytes_);
  ++frames_;
}

void VideoStream::write(const std::string& bytes) const {
  for (size_t done = 0; done < bytes.size();) {
    const ssize_t some = ::write(STDOUT_FILENO, bytes.data() + done, bytes.size() - done);
    if (some < 0 && errno == EINTR) continue;
    if (some >= 0) {
      done += static_cast<size_t>(some);
      continue;
    }
    const std::string why = errno == EPIPE ? "nobody reads standard output any more"
                                           : "standard output: " + std::generic_category().message(errno);
    throw std::runtime_error(why + "; it has " + std::to_string(frames_) + " pictures of the film");
  }
}

}  // namespace gluray::launcher
