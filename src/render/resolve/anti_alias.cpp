#include "render/resolve/anti_alias.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/resolve/anti_alias.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// Highway includes the following once per instruction set.
#include "render/resolve/fxaa_filter.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Luminosity of a row's pixels, with the order of operations of software OpenGLs, because rounding decides
/// between equal contrasts.
HWY_ATTR void luminosityOfRow(const uint32_t* pixels, size_t count, float* out) {
  const hn::ScalableTag<float> d;
  const hn::RebindToUnsigned<decltype(d)> du;
  const hn::RebindToSigned<decltype(d)> di;
  const auto byteMask = hn::Set(du, 255u);
  const auto unit = hn::Set(d, 1.0f / 255), r = hn::Set(d, 0.299f), g = hn::Set(d, 0.587f),
             b = hn::Set(d, 0.114f);
  const size_t step = hn::Lanes(d);
  size_t i = 0;
  for (; i + step <= count; i += step) {
    const auto p = hn::LoadU(du, pixels + i);
    const auto channel = [&](auto v) HWY_ATTR {
      return hn::Mul(hn::ConvertTo(d, hn::BitCast(di, hn::And(v, byteMask))), unit);
    };
    const auto sum = hn::Add(
        hn::Add(hn::Mul(channel(hn::ShiftRight<16>(p)), b), hn::Mul(channel(hn::ShiftRight<8>(p)), g)),
        hn::Mul(channel(p), r));
    hn::StoreU(sum, d, out + i);
  }
  for (; i < count; ++i) {
    const uint32_t p = pixels[i];
    const auto channel = [](uint32_t v) { return static_cast<float>(v & 255) * (1.0f / 255); };
    out[i] = (channel(p >> 16) * 0.114f + channel(p >> 8) * 0.587f) + channel(p) * 0.299f;
  }
}

/// A row's luminosity and that of the rows below and above.
struct Rows {
  const float *below, *row, *above;
  size_t width;
};

/// Collects the columns in [from, to) whose contrast with the four neighbours reaches the thresholds; returns
/// their number. `columns` has room for one vector more than to - from.
HWY_ATTR size_t columnsOfContrast(const scene::Fxaa& settings, const Rows& rows, size_t from, size_t to,
                                  int32_t* columns) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  const size_t step = hn::Lanes(d);
  const auto lane = hn::Iota(di, 0);
  size_t found = 0;
  for (size_t i = from; i < to;) {
    if (i > 0 && i + step <= to && i + step < rows.width) {
      const auto c = hn::LoadU(d, rows.row + i), n = hn::LoadU(d, rows.below + i),
                 s = hn::LoadU(d, rows.above + i), w = hn::LoadU(d, rows.row + i - 1),
                 e = hn::LoadU(d, rows.row + i + 1);
      const auto least = leastOf(c, n, s, w, e), most = mostOf(c, n, s, w, e);
      const auto threshold =
          hn::Max(hn::Set(d, settings.hardContrast), hn::Mul(hn::Set(d, settings.relativeContrast), most));
      const auto reached = hn::RebindMask(di, hn::Ge(hn::Sub(most, least), threshold));
      // Stores a whole vector: CompressStore, which stores no more than it must, is slow on AMD's Zen 4.
      const auto column = hn::Add(lane, hn::Set(di, static_cast<int32_t>(i)));
      hn::StoreU(hn::Compress(column, reached), di, columns + found);
      found += hn::CountTrue(di, reached);
      i += step;
    } else {
      const float neighbours[] = {rows.row[i], rows.below[i], rows.above[i], rows.row[i > 0 ? i - 1 : 0],
                                  rows.row[std::min(i + 1, rows.width - 1)]};
      const auto [least, most] = std::minmax_element(std::begin(neighbours), std::end(neighbours));
      if (*most - *least >= std::max(settings.hardContrast, settings.relativeContrast * *most))
        columns[found++] = static_cast<int32_t>(i);
      ++i;
    }
  }
  return found;
}

/// Filters a row into `out`.
HWY_ATTR void filterRow(const scene::Fxaa& settings, const FxaaImage& image, int y, uint32_t* out) {
  constexpr size_t kAtOnce = 512, kMaxLanes = HWY_MAX_BYTES / sizeof(float);
  const auto width = static_cast<size_t>(image.width), lanes = hn::Lanes(Filter::D());
  const float* row = image.luminosity + static_cast<size_t>(y) * width;
  const Rows rows = {y > 0 ? row - width : row, row, y + 1 < image.height ? row + width : row, width};
  std::copy_n(image.pixels + static_cast<size_t>(y) * width, width, out);
  const Filter filter(settings, image);
  int32_t columns[kAtOnce + kMaxLanes];
  uint32_t colors[kMaxLanes];
  for (size_t from = 0; from < width; from += kAtOnce) {
    const size_t count = columnsOfContrast(settings, rows, from, std::min(from + kAtOnce, width), columns);
    if (count > 0) std::fill_n(columns + count, lanes, columns[count - 1]);  // pads the last vector
    for (size_t i = 0; i < count; i += lanes) {
      filter.run(columns + i, y, colors);
      for (size_t lane = 0; lane < std::min(lanes, count - i); ++lane) out[columns[i + lane]] = colors[lane];
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::render {

HWY_EXPORT(luminosityOfRow);
HWY_EXPORT(filterRow);

void fxaa(const scene::Fxaa& settings, const uint32_t* in, int width, int height, uint32_t* out,
          FxaaMemory& memory) {
  const auto w = static_cast<size_t>(width), h = static_cast<size_t>(height);
  if (memory.luminosity.size() < w * h) memory.luminosity.resize(w * h);
  float* luminosity = memory.luminosity.data();
  const FxaaImage image = {in, luminosity, width, height};
  constexpr size_t kRows = 16;
  tbb::parallel_for(tbb::blocked_range<size_t>(0, h, kRows), [&](const auto& rows) {
    for (size_t y = rows.begin(); y != rows.end(); ++y)
      HWY_DYNAMIC_DISPATCH(luminosityOfRow)(in + y * w, w, luminosity + y * w);
  });
  tbb::parallel_for(tbb::blocked_range<size_t>(0, h, kRows), [&](const auto& rows) {
    for (size_t y = rows.begin(); y != rows.end(); ++y)
      HWY_DYNAMIC_DISPATCH(filterRow)(settings, image, static_cast<int>(y), out + y * w);
  });
}

}  // namespace gluray::render
#endif
