// Images of a picture that get better step by step: passes of light that were traced for one step are kept
// for the next. One thread.
#pragma once
#include "base/image.h"
#include "frame/refinement/refiner.h"
#include "frame/tracing/tracer.h"
#include "scene/snapshot.h"

#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <vector>

namespace gluray::saved {

/// Somebody wants something else: thrown in place of an image.
struct Stopped : std::exception {
  const char* what() const noexcept override { return "stopped"; }
};

/// The images of a composition in the order in which it asks for them. Compositions of the same picture ask
/// for the same images; only what layers see below them may change from step to step.
class GrowingImages {
 public:
  static constexpr uint32_t kAll = std::numeric_limits<uint32_t>::max();

  /// `trace` returns false without an error if it was stopped.
  explicit GrowingImages(frame::Trace trace) : trace_(std::move(trace)) {}

  /// Begins a composition whose images have at most so many passes; kAll: they are finished, as
  /// frame::TracedImages finishes them.
  void compose(uint32_t passes) { next_ = 0, most_ = passes; }
  /// The next image; valid until the next compose(). Throws Stopped, or std::runtime_error with one line.
  const Image& imageOf(const scene::Snapshot& snapshot);

  /// Whether more passes would change nothing.
  bool finished() const;
  /// Of the image with the most passes, and of the noisiest one; infinite: not known yet; 0: no light.
  uint32_t passes() const;
  double noise() const;

 private:
  struct Entry {
    explicit Entry(const scene::Snapshot& s) : layers(s.layers) {}
    std::shared_ptr<const scene::Layers> layers;  // of the image
    frame::Refinement refinement;
    std::unique_ptr<frame::Refiner> refiner;  // null: the image is finished in one step
    Image image;
    bool finished = false;
  };
  void refine(Entry& entry);
  void traceWhole(const scene::Snapshot& snapshot, Entry& entry);

  frame::Trace trace_;
  std::vector<std::unique_ptr<Entry>> entries_;
  size_t next_ = 0;
  uint32_t most_ = kAll;
};

}  // namespace gluray::saved
