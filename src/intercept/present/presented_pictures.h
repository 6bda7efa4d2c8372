// What the roles of one context's presenter share: its pictures, and what is known of its OpenGL. GL thread.
#pragma once
#include "frame/pictures.h"
#include "frame/tracer.h"
#include "gl/batch/presenter.h"
#include "intercept/present/features.h"
#include "intercept/present/write_back/cleared_color.h"
#include "intercept/present/write_back/write_back.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace gluray::present {

/// Called with every picture that has just been written into the bound framebuffer.
using Written = std::function<void(const gl::RealGl&, const Image&)>;

struct PresentedPictures {
  PresentedPictures(const frame::Tracer& with, Written onWritten)
      : tracer(with), pictures(with.trace, with.improves), written(std::move(onWritten)) {}

  /// Pictures::of(), with its cost in `result`. Null: tracing failed, with the reason in `why`.
  const frame::LastPictures::Picture* of(const scene::Snapshot& snapshot, bool mayRepeat,
                                         std::optional<uint32_t> missColor, gl::PresentResult& result,
                                         std::string& why);
  const Features& features(const gl::RealGl& real);
  /// The write-back of pictures with such colours, made at the first call.
  WriteBack& writeBack(const gl::RealGl& real, WriteBack::Colors colors);
  /// Presenter::supports().
  bool supported(const gl::RealGl& real, std::string& why) noexcept;
  /// Presenter::takeNames() and forget().
  gl::SharedNames takeNames();
  void forget() noexcept;

  frame::Tracer tracer;
  frame::Pictures pictures;
  Written written;
  ClearedColor clearedWindow;

 private:
  std::optional<Features> features_;                      // of the context
  std::array<std::unique_ptr<WriteBack>, 3> writeBacks_;  // by WriteBack::Colors
};

}  // namespace gluray::present
