// When a program ends its depth peels, as far as it was seen doing so. It draws another peel while the last
// one wrote more pixels of farthest layers than a threshold, and not more than a number of peels; both are in
// the program's memory alone. Of LayerDraws, GL thread.
#pragma once
#include "base/image.h"

#include <GL/gl.h>

#include <cstdint>
#include <limits>
#include <optional>

namespace gluray::gl {

/// What is certain: at least so many peels, where each but the last wrote at least `written` pixels.
struct PeelLimits {
  uint32_t peels = 1;
  uint64_t written = std::numeric_limits<uint64_t>::max();
  bool operator==(const PeelLimits&) const = default;
};

/// Pixels of the farthest layers that peel number `peel` writes, from 1: the first one finds the opaque depth
/// in the place of the farthest layer, and a layer that is nearest and farthest counts as nearest.
uint64_t writtenBehind(const LayerCounts& layers, uint32_t peel);

/// Whether the peels that are certain show all layers of a picture of `pixels` pixels: all but a thousandth,
/// where silhouettes decide.
bool showsAll(const PeelLimits& limits, const LayerCounts& layers, uint64_t pixels);

class PeelWatch {
 public:
  const PeelLimits& limits() const { return limits_; }
  /// The first pass of a frame.
  void begin() { peels_ = 0, depths_ = 0; }
  /// A draw of a peel, which reads the depths to peel from texture `depths`.
  void drawn(GLuint depths);
  /// The real OpenGL draws the frame with these layers, because more peels may be needed than are certain.
  /// Whether that taught nothing the last time, or too often.
  bool declined(const LayerCounts& layers);
  void traced() { declines_ = 0, layers_.reset(); }
  /// The program draws the frame, of whose layers nothing is known.
  void gaveUp() { layers_.reset(); }

 private:
  PeelLimits limits_;
  std::optional<LayerCounts> layers_;  // of the frame
  bool learned_ = true;                // since declined()
  uint32_t declines_ = 0;              // in a row
  uint32_t peels_ = 0;
  GLuint depths_ = 0;
};

}  // namespace gluray::gl
