// What presenting a batch did and cost: returned by the presenters. GL thread.
#pragma once
#include "base/image.h"
#include "scene/trace_cost.h"

#include <GL/gl.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gluray::gl {

struct PresentResult {
  enum Outcome {
    traced,      // colour and depth are in the framebuffer
    rasterised,  // tracing failed; the real OpenGL has drawn the same instances, now or before
    failed,      // neither was possible
  } outcome = failed;
  scene::TraceCost cost;
  double presentSeconds = 0;
  bool repeated = false;  // nothing had changed: the last image was used again
  uint32_t passes = 0;    // of light, traced now
  double noise = std::numeric_limits<double>::infinity();  // estimated, of the image; infinite: not known
  bool averages = false;                                   // pixels are averages of several rays
  bool uploaded = false;                                   // into textures, not drawn
  /// Set if one peel does not show all layers: how many there are. Rasterised, or the image waits.
  std::optional<LayerCounts> layers;
  std::vector<uint32_t> image;        // the waiting image of layers; empty: it was written
  GLenum pendingError = GL_NO_ERROR;  // the program's error that was found on the way, to be reported to it
  /// The written part of the image, as scene::writtenPart() returns it, if PresentTarget::keepsPixels.
  std::shared_ptr<const Image> written;
  std::string why;  // if not traced: one line for the user, not logged yet

  /// What an image that was not traced costs. Where the real OpenGL could not draw the instances either, the
  /// framebuffer lacks them: tracing ends.
  scene::Loss loss() const { return outcome == failed ? scene::Loss::tracing : cost.loss; }
  /// `why`, or a general line where it is empty.
  const char* reason() const { return why.empty() ? "the ray tracer could not make an image" : why.c_str(); }
};

}  // namespace gluray::gl
