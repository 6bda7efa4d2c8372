// Result and cost of presenting a batch, returned by the presenters. GL thread.
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
  bool repeated = false;                                   // nothing had changed: the last image was reused
  uint32_t passes = 0;                                     // passes of light samples traced by this call
  double noise = std::numeric_limits<double>::infinity();  // estimated, of the image; infinite: not known
  bool averages = false;                                   // pixels are averages of several rays
  bool uploaded = false;                                   // written by upload into textures, not drawn
  /// The numbers of layers, if one peel does not show all of them. Then the layers were rasterised, or the
  /// image waits.
  std::optional<LayerCounts> layers;
  std::vector<uint32_t> image;        // the waiting image of layers; empty if it was written
  GLenum pendingError = GL_NO_ERROR;  // an error of the program, found on the way, to be reported
  /// The written part of the image, as scene::writtenPart() returns it, if PresentTarget::keepsPixels.
  std::shared_ptr<const Image> written;
  std::string why;  // if not traced: one line for the user, not yet logged

  /// How much tracing is lost by an image that was not traced. If the real OpenGL could not draw the
  /// instances either, the framebuffer lacks them, and tracing ends.
  scene::Loss loss() const { return outcome == failed ? scene::Loss::tracing : cost.loss; }
  /// `why`, or a general message if it is empty.
  const char* reason() const { return why.empty() ? "the ray tracer could not make an image" : why.c_str(); }
};

}  // namespace gluray::gl
