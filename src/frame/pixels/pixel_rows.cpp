#include "frame/pixels/pixel_rows.h"

#include <algorithm>
#include <bit>
#include <cmath>

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "frame/pixels/pixel_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gluray::frame {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

HWY_ATTR size_t firstHit(const float* depth, size_t count) {
  const hn::ScalableTag<float> d;
  const auto farthest = hn::Set(d, 1.0f);
  const size_t step = hn::Lanes(d);
  size_t i = 0;
  for (; i + step <= count; i += step) {
    const intptr_t at = hn::FindFirstTrue(d, hn::Le(hn::LoadU(d, depth + i), farthest));
    if (at >= 0) return i + static_cast<size_t>(at);
  }
  while (i < count && !(depth[i] <= 1.0f)) ++i;
  return i;
}

HWY_ATTR size_t endOfHits(const float* depth, size_t count) {
  const hn::ScalableTag<float> d;
  const auto farthest = hn::Set(d, 1.0f);
  const size_t step = hn::Lanes(d);
  while (count >= step && hn::AllFalse(d, hn::Le(hn::LoadU(d, depth + count - step), farthest)))
    count -= step;
  while (count > 0 && !(depth[count - 1] <= 1.0f)) --count;
  return count;
}

HWY_ATTR void toDepth24(const float* depth, size_t count, uint32_t* to) {
  const hn::ScalableTag<float> d;
  const hn::RebindToUnsigned<decltype(d)> du;
  const auto farthest = hn::Set(d, 1.0f), largest = hn::Set(d, 16777215.0f);
  const size_t step = hn::Lanes(d);
  size_t i = 0;
  for (; i + step <= count; i += step) {
    const auto scaled = hn::Mul(hn::Min(hn::LoadU(d, depth + i), farthest), largest);
    hn::StoreU(hn::ShiftLeft<8>(hn::BitCast(du, hn::NearestInt(scaled))), du, to + i);
  }
  for (; i < count; ++i)
    to[i] = static_cast<uint32_t>(std::lrintf(std::min(depth[i], 1.0f) * 16777215.0f)) << 8;
}

HWY_ATTR void toDepthFloat(const float* depth, size_t count, uint32_t* to) {
  const hn::ScalableTag<float> d;
  const hn::RebindToUnsigned<decltype(d)> du;
  const auto farthest = hn::Set(d, 1.0f);
  const size_t step = hn::Lanes(d);
  size_t i = 0;
  for (; i + step <= count; i += step)
    hn::StoreU(hn::BitCast(du, hn::Min(hn::LoadU(d, depth + i), farthest)), du, to + i);
  for (; i < count; ++i) to[i] = std::bit_cast<uint32_t>(std::min(depth[i], 1.0f));
}

HWY_ATTR void toWindow(const uint32_t* color, const float* depth, float farthest, uint32_t background,
                       size_t count, uint32_t* to) {
  const hn::ScalableTag<float> d;
  const hn::RebindToUnsigned<decltype(d)> du;
  const auto limit = hn::Set(d, farthest);
  const auto behind = hn::Set(du, background), greens = hn::Set(du, 0xff00ff00u), low = hn::Set(du, 0xffu);
  const size_t step = hn::Lanes(d);
  size_t i = 0;
  for (; i + step <= count; i += step) {
    const auto seen = hn::RebindMask(du, hn::Le(hn::LoadU(d, depth + i), limit));
    const auto rgba = hn::IfThenElse(seen, hn::LoadU(du, color + i), behind);
    const auto red = hn::ShiftLeft<16>(hn::And(rgba, low)), blue = hn::And(hn::ShiftRight<16>(rgba), low);
    hn::StoreU(hn::Or(hn::And(rgba, greens), hn::Or(red, blue)), du, to + i);
  }
  for (; i < count; ++i) to[i] = bgra(depth[i] <= farthest ? color[i] : background);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::frame
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::frame {

HWY_EXPORT(firstHit);
HWY_EXPORT(endOfHits);
HWY_EXPORT(toDepth24);
HWY_EXPORT(toDepthFloat);
HWY_EXPORT(toWindow);

size_t firstHit(const float* depth, size_t count) { return HWY_DYNAMIC_DISPATCH(firstHit)(depth, count); }
size_t endOfHits(const float* depth, size_t count) { return HWY_DYNAMIC_DISPATCH(endOfHits)(depth, count); }
void toDepth24(const float* depth, size_t count, uint32_t* to) {
  HWY_DYNAMIC_DISPATCH(toDepth24)(depth, count, to);
}
void toDepthFloat(const float* depth, size_t count, uint32_t* to) {
  HWY_DYNAMIC_DISPATCH(toDepthFloat)(depth, count, to);
}
void toWindow(const uint32_t* color, const float* depth, float farthest, uint32_t background, size_t count,
              uint32_t* to) {
  HWY_DYNAMIC_DISPATCH(toWindow)(color, depth, farthest, background, count, to);
}

}  // namespace gluray::frame
#endif
