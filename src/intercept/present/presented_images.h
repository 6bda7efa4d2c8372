// State shared by the roles of one context's presenter: images, features, write-backs. GL thread.
#pragma once
#include "frame/images/traced_images.h"
#include "frame/tracing/tracer.h"
#include "gl/batch/presenter.h"
#include "intercept/present/read_back/sample_depths.h"
#include "intercept/present/state/features.h"
#include "intercept/present/write_back/cleared_color.h"
#include "intercept/present/write_back/write_back.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace gluray::present {

/// Called after an image has been written into the bound framebuffer.
using Written = std::function<void(const gl::RealGl&, const Image&)>;

struct PresentedImages {
  PresentedImages(const frame::Tracer& with, Written onWritten)
      : tracer(with), images(with), written(std::move(onWritten)) {}

  /// TracedImages::imageOf(); adds the cost to `result`. Null: tracing failed, with the reason in `why`.
  const frame::ImageCache::CachedImage* imageOf(const scene::Snapshot& snapshot, gl::ImageWish wish,
                                                std::optional<uint32_t> missColor, gl::PresentResult& result,
                                                std::string& why);
  const Features& features(const gl::RealGl& real);
  /// The write-back for images with such colours, made at the first call.
  WriteBack& writeBack(const gl::RealGl& real, WriteBack::Colors colors);
  /// Presenter::supports().
  bool supported(const gl::RealGl& real, std::string& why) noexcept;
  /// Presenter::takeNames() and forget().
  gl::SharedNames takeNames();
  void forget() noexcept;

  frame::Tracer tracer;
  frame::TracedImages images;
  Written written;
  ClearedColor clearedWindow;
  SampleDepths samples;

 private:
  std::optional<Features> features_;                                      // of the context
  std::array<std::unique_ptr<WriteBack>, WriteBack::kKinds> writeBacks_;  // by WriteBack::Colors
};

}  // namespace gluray::present
