// Draws of volumes: traces them in place of the fragment shader that would cast their rays (docs/adr/0110).
// A part of each Context, GL thread.
#pragma once
#include "gl/draws/batch_filler.h"
#include "gl/draws/raster_draws.h"
#include "gl/real/elements.h"
#include "gl/volumes/volume_maps.h"
#include "scene/volumes/volume.h"

#include <GL/gl.h>

#include <string>

namespace gluray::gl {

/// Number of a volume's faces: a clipped box has far fewer.
inline constexpr uint64_t kMostVolumeFaces = 1000;
/// Triangles that take a software OpenGL as long as a volume: more than it gets without a trial
/// (EngineChoice).
inline constexpr uint64_t kLoadOfVolume = 1000000;

class VolumeDraws {
 public:
  struct Parts {
    ShadowState& shadow;
    const Failsafe& failsafe;
    const FrameClock& clock;
    SurfaceHistory& surfaces;
    PendingBatch& pending;
    Relighting& relighting;
    RasterDraws& raster;
    BatchFiller& filler;
  };
  explicit VolumeDraws(const Parts& parts) : p_(parts) {}

  /// Draws the volume of the shader program in use. False: the real OpenGL must draw it; then the program's
  /// `why` says the reason.
  bool draw(GLenum mode, const Elements& elements);

 private:
  struct Place {
    glm::dmat4 clipFromData{1}, eyeFromData{1};
  };
  bool read(GLenum mode, const Elements& elements, scene::VolumeCast& cast, Place& place, std::string& why);
  /// Gives a volume its place in its view, where settings change light.
  void placeInView(const Place& place, scene::VolumeCast& cast);
  /// Lights the surfaces behind it again, if they were not lit with it: once it is blended over them, they
  /// cannot be replaced.
  bool castInView(const scene::VolumeCast& cast, std::string& why);
  bool hasOffset() const;
  const char* obstacleToBlending(bool spanned) const;
  bool readFaces(GLenum mode, const Elements& elements, scene::VolumeView& view) const;
  const char* obstacle() const;

  Parts p_;
  VolumeMaps maps_;
  Batch view_;        // of placeInView(), empty between calls
  BatchKey viewKey_;  // of VolumeCast::lit
};

}  // namespace gluray::gl
