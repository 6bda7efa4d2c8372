// Traces batches again whose view turned out to hold other surfaces than they were lit with: the surfaces
// that the last frame drew after a batch are taken for granted when it is traced (adr/0047), and may not
// come; in a first frame nothing is known (adr/0095). A part of each Context, GL thread.
#pragma once
#include "gl/pending/pending_batch.h"

#include <GL/gl.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace gluray::gl {

class Relighting {
 public:
  struct Parts {
    ShadowState& shadow;
    Failsafe& failsafe;
    FrameClock& clock;
    DrawCounts& counts;
    SurfaceHistory& surfaces;
    PendingBatch& pending;
  };
  explicit Relighting(const Parts& parts) : p_(parts) {}

  /// Nothing joins what the framebuffer shows any more. Call after a flush.
  void update(GLuint framebuffer);
  /// The same for a picture that is finished: it is shown, read or copied next.
  void finish(GLuint framebuffer) {
    p_.clock.finishPicture(framebuffer);
    update(framebuffer);
  }
  /// What happens next, and whose pictures it finishes.
  enum class Place : uint8_t {
    read,      // pixels are read, copied or blitted: that of the bound read framebuffer
    images,    // textures are read or copied: those of all framebuffer objects
    sampling,  // the real OpenGL draws: those of other framebuffers whose colours are bound as textures
    leaving,   // the context is left: all
  };
  void finish(Place place) {
    if (place == Place::read || !p_.surfaces.views.empty()) [[unlikely]]
      finishAt(place);
  }

 private:
  /// Images of one batch, before and after it was lit again.
  struct Replaced {
    std::shared_ptr<const Image> before, now;
  };
  void finishAt(Place place);
  void finishSampled();
  std::optional<Replaced> relight(ViewScenes::Outdated one, const std::vector<Replaced>& below);

  Parts p_;
};

}  // namespace gluray::gl
