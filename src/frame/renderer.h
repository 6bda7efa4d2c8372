// From a snapshot to an image: the only door to the ray tracer for those who intercept.
#pragma once
#include "base/image.h"
#include "scene/fxaa.h"
#include "scene/resolve.h"
#include "scene/snapshot.h"
#include "scene/trace_cost.h"

#include <cstdint>
#include <memory>
#include <string>

namespace gluray::frame {

/// Renders one snapshot at a time; other threads wait. Acceleration structures live on between frames.
class Renderer {
 public:
  Renderer();
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// The process's renderer, made at the first call and never destroyed: hosts call us while they exit.
  static Renderer& shared();

  /// Traces `snapshot` into `image`, which takes the region's shape. False on any failure, with one line in
  /// `error`; the image then has no meaning, and later snapshots may succeed. Any thread.
  bool render(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost,
              std::string& error) noexcept;

  /// Whether a better acceleration structure is ready, which the next render() puts in the place of the one
  /// there. False while another thread is in the renderer. Any thread.
  bool improves() const noexcept;

  /// Anti-aliases a finished picture: render::fxaa with the threads of the settings. False without memory or
  /// threads. Any thread.
  bool antialias(const Settings& settings, const scene::Fxaa& fxaa, const uint32_t* in, int width, int height,
                 uint32_t* out) noexcept;
  /// The same of pixels out of samples: render::resolve.
  bool resolve(const Settings& settings, const scene::Resolve& how, const Image& samples,
               Image& out) noexcept;

 private:
  class Engine;
  std::unique_ptr<Engine> engine_;
};

}  // namespace gluray::frame
