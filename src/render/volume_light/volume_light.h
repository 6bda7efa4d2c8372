// Finds the light that arrives at the samples of volumes, and keeps what stays the same from frame to frame.
// One thread at a time.
#pragma once
#include "accel/world.h"
#include "base/hash.h"
#include "parallel/arena.h"
#include "render/media/medium_lattice.h"
#include "render/media/sample_illumination.h"
#include "scene/snapshot.h"
#include "scene/volumes/placed_volume.h"

#include <memory>
#include <vector>

namespace gluray::render {

class LightPoints;
class Media;

/// A volume in its view.
struct VolumeInView {
  const scene::Snapshot& view;  // no instances; its secondary scene has what else the view shows
  const scene::PlacedVolume& volume;
};

class VolumeLights {
 public:
  /// The light that arrives at a volume's samples, with the view's settings. `world` holds the view's
  /// snapshot. Null: the settings change nothing for it. Throws std::bad_alloc, std::runtime_error if a
  /// matrix cannot be inverted.
  std::shared_ptr<const SampleIllumination> arriving(const VolumeInView&, const accel::World& world,
                                                     Media& media, Arena& arena);

 private:
  /// What blocks light around a volume, in its data space.
  struct Surroundings {
    struct Surface {
      Hash128 geometry;
      glm::dmat4 dataFromObject;
    };
    std::vector<Surface> surfaces;
    std::vector<std::shared_ptr<const Lattice>> media;  // the volume's own first
    std::vector<glm::mat4> latticeFromData;
    bool isLike(const Surroundings& other) const;
  };
  struct Occlusion {
    Surroundings around;
    float radius = 0, strength = 0;
    std::vector<float> values;
  };
  /// `points` finds it where it is not known.
  std::vector<float> occlusionOf(Surroundings around, const LightPoints& points, float radius,
                                 float strength);
  static Surroundings surroundingsOf(const VolumeInView& in, const std::vector<PlacedLattice>& media);

  std::vector<Occlusion> known_;  // the one used last is the last
};

}  // namespace gluray::render
