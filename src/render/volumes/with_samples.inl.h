// Chooses the code for a volume's voxels. Compiled once for each instruction set.
#if defined(GLURAY_RENDER_WITH_SAMPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_WITH_SAMPLES_INL_H_
#undef GLURAY_RENDER_WITH_SAMPLES_INL_H_
#else
#define GLURAY_RENDER_WITH_SAMPLES_INL_H_
#endif

#include "render/volumes/voxel_samples.inl.h"

#include <vector>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Calls visitor.visit(frame, samples of each channel) for the type of the volume's voxels and its filter.
template <class Samples, class Visitor>
HWY_ATTR void visitSamples(const VolumeFrame& frame, const Visitor& visitor) {
  std::vector<Samples> samples;
  for (size_t c = 0; c < frame.channels.size(); ++c)
    samples.emplace_back(*frame.volume->grid, static_cast<int>(c));
  visitor.visit(frame, samples.data());
}

template <class Stored, class Visitor>
HWY_ATTR void withStored(const VolumeFrame& frame, const Visitor& visitor) {
  const scene::Volume& v = *frame.volume;
  if (!v.linear) return visitSamples<VoxelSamples<Stored, NearestFilter>>(frame, visitor);
  if constexpr (sizeof(Stored) == 1)
    if (v.byteFilter) return visitSamples<VoxelSamples<Stored, ByteFilter>>(frame, visitor);
  visitSamples<VoxelSamples<Stored, LinearFilter>>(frame, visitor);
}

template <class Visitor>
HWY_ATTR void withSamples(const VolumeFrame& frame, const Visitor& visitor) {
  switch (frame.volume->grid->type) {
    case scene::VoxelGrid::Type::byte: return withStored<uint8_t>(frame, visitor);
    case scene::VoxelGrid::Type::signedByte: return withStored<int8_t>(frame, visitor);
    case scene::VoxelGrid::Type::word: return withStored<uint16_t>(frame, visitor);
    case scene::VoxelGrid::Type::signedWord: return withStored<int16_t>(frame, visitor);
    case scene::VoxelGrid::Type::single: return withStored<float>(frame, visitor);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#endif
