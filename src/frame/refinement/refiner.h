// Traces passes of one snapshot and accumulates their mean. One thread at a time.
#pragma once
#include "frame/refinement/refinement.h"
#include "frame/tracing/tracer.h"

#include <string>

namespace gluray::frame {

/// Whether more passes improve the snapshot's image, and there is memory for their sums.
bool isRefinable(const scene::Snapshot& snapshot);

/// Whether there is memory for its auxiliary features as well.
bool isFilterable(const scene::Snapshot& snapshot);

/// Whether an image is finished: its noise is within the setting `noise`, it has `refine.passes` passes, or
/// one more would end after `refine.seconds`.
bool isFinished(const Refinement& refinement, const Settings& settings);

/// Fewer passes give no reliable noise estimate, because well distributed rays may agree by chance.
inline constexpr uint32_t kMinPasses = 4;

/// A pass takes at most so many rays of a kind per pixel. Where the settings ask for more samples, they are
/// divided among several passes, which together count as one of `refine.passes`: so the noise is known before
/// all of four times the samples are taken.
inline constexpr int kMaxPassSamples = 16;
/// Divides the settings' samples, and multiplies `refine.passes`.
void divideIntoPasses(Settings& settings);

class Refiner {
 public:
  /// Continues `refinement`, whose passes, if any, are of an equal snapshot; it must outlive this.
  Refiner(const scene::Snapshot& snapshot, Refinement& refinement);
  /// Traces one more pass; misses of byte colours get `missColor`. Returns false, with a line in `error`, if
  /// nothing was added. Adds to `cost`.
  bool pass(const Trace& trace, uint32_t missColor, scene::TraceCost& cost, std::string& error);
  /// Writes the mean into `out`; misses get out.missColor. Call after pass(). Throws std::bad_alloc.
  void show(Image& out) const;
  /// Whether show() may be called.
  bool hasPass() const { return whole_; }
  bool finished() const { return isFinished(refinement_, snapshot_.settings); }
  /// After pass(): the image of another process that makes the passes; null: this process makes the passes.
  const Image* elsewhere() const { return elsewhere_ ? &image_ : nullptr; }
  /// Whether the image elsewhere() is finished.
  bool finishedElsewhere() const { return finishedElsewhere_; }
  const Refinement& refinement() const { return refinement_; }
  /// The snapshot's, divided into passes.
  const Settings& settings() const { return snapshot_.settings; }

 private:
  bool wantsFeatures() const;
  bool traceFeatures(const Trace& trace, scene::TraceCost& cost, std::string& error);

  scene::Snapshot snapshot_;  // with wide colours, even if the image has byte colours
  bool wide_;                 // the image's colours are wide
  Refinement& refinement_;
  Image image_;         // of the last pass
  bool whole_ = false;  // image_ has all tiles
  bool filters_;        // images are denoised
  bool elsewhere_ = false, finishedElsewhere_ = false;
};

}  // namespace gluray::frame
