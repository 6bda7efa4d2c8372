// Packets against triangle blocks, compiled once per instruction set.
#include "accel/blocks/triangle_block_kernels.h"

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/blocks/triangle_block_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// What follows is included once for each instruction set, after Highway's macros.
#include "accel/blocks/triangle_test.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::accel {
namespace HWY_NAMESPACE {

template <class D, class Wanted>
void meetSome(D d, const Wanted& wanted, const TriangleRun& run, const PacketRows& p, unsigned i,
              Chooser choose, const void* query) {
  Rays<D> rays = load(d, p, i);
  if (!hn::AllFalse(d, rays.valid)) wanted(d, rays, run, p, i, choose, query);
}

template <class Wanted>
void meetAll(const Wanted& wanted, const TriangleRun& run, const PacketRows& p, Chooser choose,
             const void* query) {
  const hn::CappedTag<float, kLanes> wide;
  const auto step = static_cast<unsigned>(hn::Lanes(wide));
  unsigned i = 0;
  for (; i + step <= p.count; i += step) meetSome(wide, wanted, run, p, i, choose, query);
  for (; i < p.count; ++i) meetSome(hn::CappedTag<float, 1>(), wanted, run, p, i, choose, query);
}

void meetNearest(const TriangleRun& run, const PacketRows& p, const HitNames& names, Chooser choose,
                 const void* query) {
  meetAll(Nearest{names}, run, p, choose, query);
}
void meetAny(const TriangleRun& run, const PacketRows& p, Chooser choose, const void* query) {
  meetAll(Any{}, run, p, choose, query);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::accel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::accel {

HWY_EXPORT(meetNearest);
HWY_EXPORT(meetAny);

void meetTriangles(const TriangleRun& run, const PacketRows& packet, const HitNames& names, Chooser choose,
                   const void* query) {
  HWY_DYNAMIC_DISPATCH(meetNearest)(run, packet, names, choose, query);
}

void occludeTriangles(const TriangleRun& run, const PacketRows& packet, Chooser choose, const void* query) {
  HWY_DYNAMIC_DISPATCH(meetAny)(run, packet, choose, query);
}

}  // namespace gluray::accel
#endif
