// Skips small rasterised draws as a whole if they are certainly invisible: outside the view volume, or behind
// depths that the framebuffer has had in its depth epoch (adr/0072). A part of CulledDraws, GL thread.
#pragma once
#include "base/hash.h"
#include "gl/basics/reasons.h"
#include "gl/culled/clusters/box_visibility.h"
#include "gl/culled/clusters/culled_mesh.h"
#include "gl/culled/clusters/depth_pyramid.h"
#include "gl/culled/drawn_region.h"
#include "gl/culled/trials/frame_trials.h"
#include "gl/culled/trials/look_schedule.h"
#include "gl/real/elements.h"
#include "scene/snapshot.h"

#include <GL/gl.h>

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace gluray::gl {

class ClearedFramebuffers;
class CulledProgram;
class DrawCounts;
class FrameClock;
class PendingBatch;
class PositionSources;
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
    PositionSources& sources;
  };
  explicit SmallDraws(const Parts& parts) : p_(parts) {}

  /// Whether draws may be skipped in this frame.
  bool isOn();
  /// The frame is complete: ends its measurement.
  void endFrame();
  /// Counts a draw while !isOn(), when leavesOut() is not called.
  void count(const Elements& elements);
  /// Whether a rasterised draw is certainly invisible: then it is counted, and the caller skips it. First
  /// call RasterDraws::before() and ShadowState::sendBuffers(). May throw std::bad_alloc.
  bool leavesOut(GLenum mode, const Elements& elements);

 private:
  struct Known {
    std::shared_ptr<CulledMesh> mesh;
    uint64_t lastFrame = 0;  // last frame that drew it
    uint64_t lastTurn = 0;   // last turn that drew it
    int frames = 0;          // number of frames that drew it
    bool isWaiting() const { return !mesh && !refused; }
    bool refused = false;  // its positions cannot be read
  };
  /// Data that decides the visibility of a draw.
  struct Candidate {
    std::shared_ptr<CulledMesh> mesh;
    ClipMatrix matrix;
    CulledProgram* program = nullptr;
    double vertices = 0;
  };
  /// Data that draws share until state changes.
  struct Common {
    CullReason reason = CullReason::culled;  // reason why draws are not skipped
    DrawnRegion region;
    WindowMapping window;   // relative to the lower corner of the region in the viewport
    bool isTested = false;  // depths decide visibility
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
  /// leavesOut() for a draw that may be skipped.
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
  /// Returns false if `cull.verify` made the draw and found it visible. Such draws are then no longer
  /// skipped.
  bool verifiedAsHidden(const Candidate& candidate, GLenum mode, const Elements& elements);
  /// Makes the draw, and returns whether it was invisible.
  bool isHidden(const Candidate& candidate, GLenum mode, const Elements& elements);
  void forgetOld();

  Parts p_;
  FrameTrials trials_;
  bool culls_ = false;                 // the remaining draws of this frame, or some of them
  bool settles_ = false;               // this frame is a settling one
  uint64_t frame_ = 0, culledIn_ = 0;  // current frame; last culled frame
  uint64_t turn_ = 0, forgotIn_ = 0;   // turns: culled frames, or several for a sweep over all draws
  FrameTrials::Load load_;             // of the current frame
  double waiting_ = 0;                 // number of waiting entries in meshes_
  double buildSeconds_ = 0;            // seconds spent in this frame
  uint64_t epoch_ = 0;                 // depth epoch since which draws are counted
  GLenum mode_ = 0;                    // the mode that common_ was read for
  Common common_;
  bool commonIsOld_ = true;  // common_, from an earlier frame
  Seen seen_;
  std::vector<Candidate> drawn_;  // since the last look
  double lookedAt_ = 0;           // seconds
  double apartSeconds_ = 0;       // time of this draw for looks, earlier draws and verification
  LookSchedule schedule_;
  std::unordered_map<Hash128, Known> meshes_;
  std::vector<float> depths_;
  GLuint query_ = 0;
};

}  // namespace gluray::gl
