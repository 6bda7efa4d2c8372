// Renders a snapshot into an image: intercept/'s only interface to the ray tracer. Any thread.
#pragma once
#include "base/image.h"
#include "scene/fxaa.h"
#include "scene/resolve.h"
#include "scene/snapshot.h"
#include "scene/trace_cost.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace gluray::render {
class MovingTileSource;
class RemoteSurfaces;
class TileSource;
struct SampleIllumination;
struct MovingRays;
}  // namespace gluray::render

namespace gluray::frame {

/// Renders one snapshot at a time; other threads wait. Keeps acceleration structures between frames.
class Renderer {
 public:
  /// Threads that trace: shared by all renderers of the process, or its own, so that an image may wait for
  /// another renderer's image.
  enum class Threads : bool { shared, own };
  explicit Renderer(Threads = Threads::shared);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Traces `snapshot` into `image`, which is resized to the region. Returns false on failure, with one line
  /// in `error` and the loss in `cost.loss`; the image is then undefined. Any thread.
  bool render(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost,
              std::string& error) noexcept;

  /// Like render(), with the lowest priority: stops at the next tile if `stop` returns true or another thread
  /// needs the renderer. Returns false without an error if stopped; the image is then undefined.
  bool renderBehind(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost, std::string& error,
                    const std::function<bool()>& stop) noexcept;

  /// Traces the tiles that `source` hands out, for an image that several processes trace together.
  /// `averages` false: one sample per pixel, regardless of settings.
  bool renderTiles(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost, std::string& error,
                   render::TileSource& source, bool averages) noexcept;

  /// Like renderTiles(), for a frame of an animation (scene::LightSampling::Mode::moving), whose light is
  /// filtered with the view's earlier frames.
  bool renderMoving(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost, std::string& error,
                    render::MovingTileSource& source, bool averages, const render::MovingRays& rays) noexcept;

  /// Traces the image of this process's part of a view, with light effects. `remote`: the other parts,
  /// which block light. Frames of animations are filtered with earlier frames of this part.
  bool renderPart(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost, std::string& error,
                  render::MovingTileSource& source, bool averages, render::RemoteSurfaces& remote) noexcept;

  /// The light that arrives at the samples of the snapshot's volume, of which there is one, with the
  /// snapshot's settings. Null: they change nothing for it, or it failed: then one line is logged. Any
  /// thread.
  std::shared_ptr<const render::SampleIllumination> illuminate(const scene::Snapshot& snapshot) noexcept;

  /// A context was destroyed: before the next image, all renderers free the acceleration structures whose
  /// meshes went with it. Any thread.
  static void contextGone() noexcept;

  /// Whether a full-quality acceleration structure is ready for the next render() to install. False while
  /// another thread uses the renderer. Any thread.
  bool improves() const noexcept;

  /// Anti-aliases a finished image: render::fxaa with the settings' threads. False without memory or
  /// threads. Any thread.
  bool antialias(const Settings& settings, const scene::Fxaa& fxaa, const uint32_t* in, int width, int height,
                 uint32_t* out) noexcept;
  /// Resolves samples into pixels: render::resolve; otherwise like antialias().
  bool resolve(const Settings& settings, const scene::Resolve& how, const Image& samples,
               Image& out) noexcept;

 private:
  class Engine;
  class InFront;
  std::unique_ptr<Engine> engine_;
};

}  // namespace gluray::frame
