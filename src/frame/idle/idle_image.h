// Refines the images of one frame in its window step by step. Used by one thread at a time: the refining
// thread, or the GL thread while the refining thread is stopped.
#pragma once
#include "base/idle_window.h"
#include "base/image.h"
#include "frame/refinement/refiner.h"
#include "frame/tracing/tracer.h"
#include "scene/fxaa.h"
#include "scene/resolve.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gluray::frame {

/// An image as it was written into the frame.
struct IdleImage {
  scene::SnapshotPtr snapshot;
  uint64_t id = 0;                              // ImageCache::CachedImage::id
  glm::ivec2 corner{0}, size{0};                // pixels of the framebuffer
  std::vector<uint32_t> colors;                 // RGBA8; of a multisampled framebuffer, the first samples
  std::optional<scene::Resolve> resolve;        // of a multisampled framebuffer, how its samples became these
  std::unique_ptr<Refinement> refinement = {};  // null: no passes yet
  // One per pixel, 0 or 1, as bytes for fast writing in every frame.
  std::vector<uint8_t> mixed = {};  // pixels whose samples differ; empty: none
  std::vector<uint8_t> hits = {};   // pixels that show surfaces; empty: all
  bool averages = false;            // Image::isAverages()

  /// Without `refinement`.
  IdleImage copy() const {
    return {snapshot, id, corner, size, colors, resolve, nullptr, mixed, hits, averages};
  }
  scene::Region region() const { return {corner.x, corner.y, size.x, size.y}; }
};

/// An anti-aliasing pass of the program that GLuRay computed over images of the frame.
struct IdleFxaa {
  scene::Fxaa how;
  scene::Region region;  // of the framebuffer
  Settings settings;
  std::vector<uint32_t> before;  // RGBA8 of the region
  std::vector<bool> seen = {};   // pixels of the window that show the result of the pass
};

/// The pixels of a window that show a frame's images, and their refinement.
class IdleFrame {
 public:
  IdleFrame(std::vector<IdleImage> images, std::shared_ptr<IdleWindow> window,
            std::vector<IdleFxaa> passes = {});
  /// Reads the window. Returns false if that is not possible, or if the window has changed since the last
  /// step.
  bool readWindow() noexcept;
  /// Makes a frame with the same images for another window, which owns their refinement until takeBack().
  std::unique_ptr<IdleFrame> lend(std::shared_ptr<IdleWindow> window);
  void takeBack(IdleFrame& lent) noexcept;
  enum class Step { more, done, failed };
  struct Done {
    bool traced = false, shown = false;
    scene::TraceCost cost;  // of all steps
    std::string why;        // one line if the last step failed; empty: stopped, or the window has changed
  };
  /// Traces one pass of the visible, unfinished image with the fewest passes, and shows the result if it is
  /// much better. `trace` may stop early and return false. Throws std::bad_alloc.
  Step step(const Tracer& tracer, const Trace& trace, Done& done);
  /// Whether the window shows none of the images unchanged.
  bool refused() const;
  bool looked() const { return looked_; }
  bool hasWindow() const { return window_ != nullptr; }
  /// Framebuffer regions of the images.
  std::vector<scene::Region> regions() const;
  bool has(uint64_t id) const;
  /// Noise of the noisiest image; infinite: not known yet.
  double noise() const;
  /// Hands over the refinement of the image with this id.
  std::unique_ptr<Refinement> takePasses(uint64_t id) noexcept;

 private:
  struct Part {
    IdleImage written;
    std::unique_ptr<Refinement> refinement;
    std::unique_ptr<Refiner> refiner;
    Image image, pixels;            // the refined image; the same resolved, if it has samples
    std::vector<uint32_t> visible;  // pixels of the window that show the image
    std::vector<uint32_t> at;       // their places in the image
    // The colours behind them (edge_pixels.h); empty: none is known.
    std::vector<std::optional<uint32_t>> behind;
    uint32_t shownPasses = 0;
    bool finished = false, refused = false;
  };
  void look();
  bool findVisible(Part& part);
  void findEdges(Part& part);
  void undoPasses(const Tracer& tracer);
  bool composeNext(const Part& part, const Image& image, const Tracer& tracer);
  const Image* imageOf(Part& part, const Tracer& tracer);

  std::shared_ptr<IdleWindow> window_;
  WindowPixels shown_, next_;
  WindowPixels under_, nextUnder_;  // window pixels before anti-aliasing
  std::vector<IdleFxaa> passes_;    // those whose result the window shows
  bool undone_ = false;             // under_ is known
  bool looked_ = false;             // where the window shows the parts is known
  std::vector<bool> taken_;         // pixels of the window in which an image is seen
  std::vector<Part> parts_;         // the last written first
};

}  // namespace gluray::frame
