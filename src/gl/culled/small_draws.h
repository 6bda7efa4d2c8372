// Skips small draws that are not traced as a whole if they are certainly invisible: outside of the view, or
// behind depths that the framebuffer has had in its depth epoch (adr/0072). A part of CulledDraws, GL thread.
#pragma once
#include "base/hash.h"
#include "gl/basics/reasons.h"
#include "gl/culled/clusters/box_visibility.h"
#include "gl/culled/clusters/culled_mesh.h"
#include "gl/culled/clusters/depth_pyramid.h"
#include "gl/real/elements.h"
#include "gl/trials/frame_trials.h"
#include "gl/trials/look_schedule.h"
#include "scene/snapshot.h"

#include <GL/gl.h>

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace gluray::gl {

class ClearedFramebuffers;
class CulledDraws;
class CulledProgram;
class DrawCounts;
class FrameClock;
class PendingBatch;
class ShadowState;
struct ArrayState;
struct ArraySource;

class SmallDraws {
 public:
  struct Parts {
    ShadowState& shadow;
    FrameClock& clock;
    DrawCounts& counts;
    PendingBatch& pending;
    const ClearedFramebuffers& cleared;
    CulledDraws& culled;
  };
  explicit SmallDraws(const Parts& parts) : p_(parts) {}

  /// Whether draws may be skipped in this frame.
  bool isOn();
  /// Counts a draw while !isOn(), when leavesOut() is not called.
  void count(const Elements& elements);
  /// Whether a rasterised draw is certainly invisible: then it is counted, and the caller skips it. First
  /// call RasterDraws::before() and ShadowState::sendBuffers() before. May throw std::bad_alloc.
  bool leavesOut(GLenum mode, const Elements& elements);

 private:
  struct Known {
    std::shared_ptr<CulledMesh> mesh;
    uint64_t lastFrame = 0;  // that drew it
    uint64_t lastTurn = 0;   // the same
    int frames = 0;          // that drew it
    bool isWaiting() const { return !mesh && !refused; }
    bool refused = false;  // its positions cannot be read
  };
  /// What decides whether a draw shows.
  struct Candidate {
    std::shared_ptr<CulledMesh> mesh;
    ClipMatrix matrix;
    CulledProgram* program = nullptr;
    double vertices = 0;
  };
  /// What draws have in common until state changes.
  struct Common {
    CullReason reason = CullReason::culled;  // why draws are not left out
    scene::Region drawn, seen;               // pixels that draws may change; the same without scissor test
    WindowMapping window;                    // relative to the lower corner of `seen`
    int samples = 1;
    bool reversed = false;
    bool isTested = false;  // depths decide whether they show
  };
  /// Depths that the framebuffer has had.
  struct Seen {
    DepthPyramid pyramid;
    scene::Region region;
    bool reversed = false;
    uint64_t epoch = 0;
    bool any = false;
  };

  void beginFrame();
  void beginEpoch();
  /// leavesOut() of a draw that may be.
  bool hides(GLenum mode, const Elements& elements);
  void readCommon(GLenum mode);
  bool find(GLenum mode, const Elements& elements, Candidate& candidate);
  bool findByProgram(Candidate& candidate, const ArrayState*& arrays, const ArraySource*& positions,
                     int& components);
  bool findMesh(GLenum mode, const Elements& elements, const ArrayState& arrays, const ArraySource& positions,
                int components, Candidate& candidate);
  bool mayShow(const Candidate& candidate) const;
  bool isSeen() const;
  void readDepths();
  /// False: it was made after all, because `cull.verify` asks for it, and shows. From now on such draws are
  /// made.
  bool verifiedAsHidden(const Candidate& candidate, GLenum mode, const Elements& elements);
  /// Makes the draw, to see whether it shows.
  bool isHidden(const Candidate& candidate, GLenum mode, const Elements& elements);
  void forgetOld();

  Parts p_;
  bool culls_ = false;                 // draws of this frame that come later, or some of them
  bool settles_ = false;               // in this frame
  uint64_t frame_ = 0, culledIn_ = 0;  // now; that was culled last
  uint64_t turn_ = 0, forgotIn_ = 0;   // frames that were culled; sweeps over all draws count as several
  FrameTrials::Load load_;             // of this frame
  double waiting_ = 0;                 // of meshes_
  double buildSeconds_ = 0;            // in this frame
  uint64_t epoch_ = 0;                 // of the depths since which draws are counted
  GLenum mode_ = 0;                    // that common_ was read for
  Common common_;
  Seen seen_;
  std::vector<Candidate> drawn_;  // since the last look
  double lookedAt_ = 0;           // seconds
  double apartSeconds_ = 0;       // of this draw: looks, waiting for earlier draws, verification
  LookSchedule schedule_;
  std::unordered_map<Hash128, Known> meshes_;
  std::vector<float> depths_;
  GLuint query_ = 0;
};

}  // namespace gluray::gl
