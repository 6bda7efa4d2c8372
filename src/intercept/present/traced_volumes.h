// Traces volumes and blends them over the framebuffer. Part of TracingPresenter, GL thread.
#pragma once
#include "intercept/present/presented_images.h"
#include "render/volumes/volume_tracer.h"
#include "scene/volumes/volume.h"

#include <string>

namespace gluray::present {

class TracedVolumes {
 public:
  explicit TracedVolumes(PresentedImages& shared) : shared_(shared) {}
  /// gl::Presenter::castVolume().
  bool cast(const gl::RealGl& real, const scene::VolumeCast& cast, std::string& why) noexcept;

 private:
  PresentedImages& shared_;
  render::VolumeTracer tracer_;
  Image image_;  // reused memory
};

}  // namespace gluray::present
