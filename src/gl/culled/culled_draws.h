// Culls draws that are not traced, by shader programs or fixed function: the real OpenGL draws only what may
// be visible (docs/culling.md). A part of each Context, GL thread.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/real/elements.h"

#include <GL/gl.h>
#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <memory>

namespace gluray::gl {

class ClearedFramebuffers;
class DrawCounts;
class Failsafe;
class FrameClock;
class LargeDraws;
class PendingBatch;
class PositionSources;
class RasterDraws;
class ShadowState;
class SmallDraws;
struct ArraySource;
struct ArrayState;

/// All that the rest of gl/ uses of gl/culled. A handler that rasterises a draw calls draw() for it, or
/// count() if it knows that nothing can be skipped. Large draws are made without hidden clusters or instances
/// (LargeDraws), small ones are skipped as a whole (SmallDraws). Whether that pays is measured inside
/// (gl/culled/trials): frames only report their end.
class CulledDraws {
 public:
  struct Parts {
    ShadowState& shadow;
    Failsafe& failsafe;
    FrameClock& clock;
    DrawCounts& counts;
    PendingBatch& pending;
    const RasterDraws& raster;
    const ClearedFramebuffers& cleared;
  };
  explicit CulledDraws(const Parts& parts);
  ~CulledDraws();

  /// What draw() may skip of a draw in the current state: nothing; the whole draw, which is small; or
  /// clusters of its triangles or instances. For `nothing`, call count() instead of draw().
  enum class Part : uint8_t { nothing, whole, clusters };
  Part mayLeaveOut(const Elements& elements);
  /// Whether the draw has enough vertices to skip clusters.
  bool isLarge(const Elements& elements) const;
  /// Whether clusters may be skipped of large draws by the current shader program, if there is one, for all
  /// values of uniforms. Refreshes kProgramGroups unless draws are never culled.
  bool takesParts();

  void count(const Elements& elements);
  /// Makes a rasterised draw of the current shader program, or of fixed function if there is none. Call
  /// RasterDraws::before() and ShadowState::sendBuffers() first. Returns false if nothing was drawn: the
  /// caller then makes the draw. Never throws. `first` is called before anything is drawn.
  bool draw(GLenum mode, const Elements& elements, const std::function<void()>& first = {}) noexcept;
  /// The frame is complete and about to be shown: ends its measurement.
  void endFrame();

  /// Returns CullReason::culled, or the reason why the state makes hidden parts of draws affect the image.
  /// Ignores blending and instances.
  CullReason reasonOfState(GLenum mode);
  /// Where the positions of a draw's surface are.
  struct Surface {
    const ArrayState* arrays = nullptr;
    const ArraySource* positions = nullptr;  // one of `arrays`
    int components = 4;                      // number of components that are used
    glm::dmat4 clipFromObject{1};
    bool instanced = false;  // attributes of instances move the surface
    bool discards = false;   // the shader program discards fragments
  };
  /// Finds the surface of draws with the current state. Returns CullReason::culled, or the reason why it is
  /// unknown or why hidden triangles affect the image.
  CullReason findSurface(GLenum mode, const Elements& elements, Surface& surface);

 private:
  /// Whether the settings and the real OpenGL allow culled draws.
  bool isActive() const;

  Parts p_;
  std::unique_ptr<PositionSources> sources_;
  std::unique_ptr<LargeDraws> large_;
  std::unique_ptr<SmallDraws> small_;
};

}  // namespace gluray::gl
