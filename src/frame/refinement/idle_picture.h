// The pictures of one frame that a window shows, refined step by step. Used by one thread at a time: the
// refining thread, or the GL thread while that one is stopped.
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

/// A picture as it was written into the frame.
struct IdlePicture {
  scene::SnapshotPtr snapshot;
  uint64_t id = 0;                              // LastPictures::Picture::id
  glm::ivec2 corner{0}, size{0};                // pixels of the framebuffer
  std::vector<uint32_t> colors;                 // RGBA8; of a multisampled framebuffer, the first samples
  std::optional<scene::Resolve> resolve;        // of a multisampled framebuffer, how its samples became these
  std::unique_ptr<Refinement> refinement = {};  // passes so far; null: none
  // One a pixel, 0 or 1: whole bytes, because they are written in every frame.
  std::vector<uint8_t> mixed = {};  // pixels whose samples differ; empty: none
  std::vector<uint8_t> hits = {};   // pixels that show surfaces; empty: all

  /// Without `refinement`.
  IdlePicture copy() const { return {snapshot, id, corner, size, colors, resolve, nullptr, mixed, hits}; }
  scene::Region region() const { return {corner.x, corner.y, size.x, size.y}; }
};

/// An anti-aliasing pass of the program that GLuRay made over pictures of the frame.
struct IdleFxaa {
  scene::Fxaa how;
  scene::Region region;  // of the framebuffer
  Settings settings;
  std::vector<uint32_t> before;  // RGBA8 of the region
  std::vector<bool> seen = {};   // pixels where the window shows what the pass made of them
};

/// Where the written colours of one picture are seen in the window, and what they become.
class IdleFrame {
 public:
  IdleFrame(std::vector<IdlePicture> pictures, std::shared_ptr<IdleWindow> window,
            std::vector<IdleFxaa> passes = {});
  /// Reads the window. False: that is not possible, or it has changed since the last step.
  bool readWindow() noexcept;
  /// The same pictures, for another window. It has their passes until takeBack().
  std::unique_ptr<IdleFrame> lend(std::shared_ptr<IdleWindow> window);
  void takeBack(IdleFrame& lent) noexcept;
  enum class Step { more, done, failed };
  struct Done {
    bool traced = false, shown = false;
    scene::TraceCost cost;  // of all steps
    std::string why;        // the last one failed: one line; empty: it was stopped, or the window has changed
  };
  /// Traces one pass over the picture with the fewest, if the window shows it and it is not finished, and
  /// shows it if it is much better. `trace` may stop early and return false. Throws std::bad_alloc.
  Step step(const Tracer& tracer, const Trace& trace, Done& done);
  /// Whether the window was found to show none of the pictures as they were written.
  bool refused() const;
  bool looked() const;  // for any of the pictures
  bool hasWindow() const { return window_ != nullptr; }
  /// Where the pictures are in their framebuffer.
  std::vector<scene::Region> regions() const;
  bool has(uint64_t id) const;
  /// Of its noisiest picture; infinite: not known yet.
  double noise() const;
  /// Hands over the passes of the picture of this id.
  std::unique_ptr<Refinement> takePasses(uint64_t id) noexcept;

 private:
  struct Part {
    IdlePicture picture;
    std::unique_ptr<Refinement> refinement;
    std::unique_ptr<Refiner> refiner;
    Image image, pixels;            // the refined picture; the same resolved, if it has samples
    std::vector<uint32_t> visible;  // pixels of the window in which the picture is seen
    std::vector<uint32_t> at;       // their places in the picture
    uint32_t shownPasses = 0;
    bool looked = false;  // `visible` is known
    bool finished = false, refused = false;
  };
  bool findVisible(Part& part);
  void undoPasses(const Tracer& tracer);
  bool composeNext(const Part& part, const Image& image, const Tracer& tracer);
  const Image* imageOf(Part& part, const Tracer& tracer);

  std::shared_ptr<IdleWindow> window_;
  WindowPixels shown_, next_;
  WindowPixels under_, nextUnder_;  // the same before anti-aliasing
  std::vector<IdleFxaa> passes_;    // those whose result the window shows
  bool undone_ = false;             // under_ is known
  std::vector<bool> taken_;         // pixels of the window in which a picture is seen
  std::vector<Part> parts_;         // the last written first
};

}  // namespace gluray::frame
