// Culls draws that are not traced: the real OpenGL draws only the triangles and instances that may be visible
// (adr/0064), by shader programs or fixed function. A part of each Context, GL thread.
#pragma once
#include "base/background_job.h"
#include "base/hash.h"
#include "gl/basics/failsafe.h"
#include "gl/basics/reasons.h"
#include "gl/clock/frame_clock.h"
#include "gl/counts/draw_counts.h"
#include "gl/culled/clusters/culled_mesh.h"
#include "gl/culled/constant_attributes.h"
#include "gl/culled/culled_program.h"
#include "gl/culled/feedback/position_feedback.h"
#include "gl/culled/instances/instances.h"
#include "gl/culled/restore_point.h"
#include "gl/culled/small_draws.h"
#include "gl/pending/pending_batch.h"
#include "gl/real/elements.h"
#include "gl/shadow/shadow_state.h"
#include "gl/trials/culling_trials.h"
#include "gl/trials/trial_budget.h"

#include <GL/gl.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace gluray::gl {

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
  explicit CulledDraws(const Parts& parts)
      : p_(parts),
        before_(parts.shadow, parts.pending, parts.raster),
        small_({parts.shadow, parts.clock, parts.counts, parts.pending, parts.cleared, *this}) {}
  ~CulledDraws();

  /// What draw() may skip of a draw in the current state: nothing; the whole draw, which is small; or
  /// clusters of its triangles or instances. For `nothing`, call count() instead of draw().
  enum class Part : uint8_t { nothing, whole, clusters };
  Part mayLeaveOut(const Elements& elements);
  bool mayCull(const Elements& elements) { return mayLeaveOut(elements) != Part::nothing; }
  void count(const Elements& elements);
  /// Makes a rasterised draw of the current shader program, or of fixed function if there is none. Call
  /// RasterDraws::before() and ShadowState::sendBuffers() first. Returns false if nothing was drawn: the
  /// caller then makes the draw. Never throws. `first` is called before anything is drawn.
  bool draw(GLenum mode, const Elements& elements, const std::function<void()>& first = {}) noexcept;

  /// Source of a draw's vertices, and the matrix to clip space.
  struct Source {
    const ArrayState* arrays = nullptr;
    const ArraySource* positions = nullptr;  // one of `arrays`
    int components = 4;                      // number of components that are used
    ClipMatrix matrix;                       // without the terms of instance attributes
    LinearPosition position;                 // by a program
    CulledProgram* program = nullptr;        // null: fixed function
  };
  /// Finds the source of draws with the current state. Returns CullReason::culled, or the reason why the
  /// source is unknown or why hidden triangles affect the image.
  CullReason source(GLenum mode, const Elements& elements, Source& source);

  /// The current shader program; requires one.
  CulledProgram& programInUse();
  /// Finds the transform of fixed function. Returns CullReason::culled, or the reason why such draws cannot
  /// be culled.
  CullReason placeByFixedFunction(Source& source);
  /// Finds the array of a program's attribute. Returns false if there is none.
  bool findPositions(CulledProgram& program, const std::string& attribute, const ArrayState*& arrays,
                     const ArraySource*& positions);
  /// Reports that a culled draw of the program (null: fixed function) differs from the complete draw: stops
  /// culling such draws, and logs one line.
  void refuseDifferent(CulledProgram* program);

  /// Whether the settings and the real OpenGL allow culled draws.
  bool isActive() const;
  /// Whether draws of the current shader program may be split, for all values of uniforms.
  bool takesParts();
  /// Whether the draw has enough vertices to be culled.
  bool isLarge(const Elements& elements) const;

 private:
  /// History of draws with equal parts: clusters, or units of instances.
  struct History {
    std::vector<uint64_t> visible;  // parts that were visible last; empty: unknown
    bool byClusters = false;        // as Plan has it
    CullingTrials trials;
    Hash128 arrays;          // the arrays that provide instance attributes
    uint64_t lastFrame = 0;  // last frame that drew these instances
  };
  struct Known {
    std::shared_ptr<CulledMesh> mesh;
    History alone;                   // of draws without several instances
    std::vector<History> instanced;  // of draws with them
    uint64_t lastFrame = 0;          // last frame that drew it
    int frames = 0;                  // number of frames that drew it
    bool refused = false;            // its positions cannot be read
    bool different = false;          // a culled image differed (fixed function)
  };
  /// Data of a draw, found before anything is drawn.
  struct Plan {
    GLenum mode = GL_TRIANGLES;
    Elements elements;
    CulledProgram* program = nullptr;  // null: fixed function
    std::shared_ptr<CulledMesh> mesh;
    Known* known = nullptr;
    History* history = nullptr;
    ClipMatrix matrix;
    std::optional<InstanceUnits> units;     // none: parts are clusters of the mesh
    std::optional<Instances> instances;     // bounds of units; none: from `feedback`
    bool byClusters = false;                // parts are clusters of each unit, else units
    CullReason apart = CullReason::culled;  // reason why instances cannot be drawn separately
    /// Whether a cluster that is visible in any instance is drawn in all instances.
    bool drawsAllInstances() const { return apart != CullReason::culled; }
    scene::Region region;  // pixels that may be drawn
    WindowMapping window;
    int samples = 1;         // of a pixel
    bool rehearsed = false;  // visibility is found in a copy of the framebuffer, which cannot be restored
    PositionFeedback* feedback = nullptr;  // source of positions, which are clip coordinates; null: arrays
    bool reversed = false;                 // larger depths are nearer: `window` maps to 1 - depth
  };

  /// Plans a draw. Returns CullReason::culled, or the reason why the draw is not culled.
  CullReason plan(GLenum mode, const Elements& elements, Plan& plan);
  CullReason sourceOfProgram(GLenum mode, const Elements& elements, Source& source);
  /// Returns the reason why hidden surfaces affect the image through blending, or CullReason::culled.
  CullReason blendingOf(CulledProgram& program, const Varyings& varyings, GLenum mode,
                        const Elements& elements);
  CullReason sourceOfFixedFunction(Source& source);
  CullReason planInstances(const Source& source, Plan& plan);
  /// Finds the instances that can be drawn separately. Returns CullReason::culled, or the reason why nothing
  /// can be skipped.
  CullReason planUnits(const CulledProgram& program, Plan& plan);
  CullReason planMesh(const Source& source, Plan& plan);
  /// Plans a draw of a shader program whose positions need transform feedback.
  CullReason planFeedback(Plan& plan);
  CullReason planClusters(const Hash128& name, const std::function<std::shared_ptr<CulledMesh>()>& make,
                          Plan& plan);
  /// Updates the clusters for this draw's positions. Returns false if these are unknown.
  bool placeClusters(const Plan& plan);
  static bool areFewAndLarge(const InstanceUnits& units, const CulledMesh& mesh);
  History& historyOf(Known& known, const Plan& plan);
  History& historyOf(Known& known, const Hash128& arrays);
  void mapWindow(Plan& plan) const;
  /// Decides whether visibility is found in a copy of the framebuffer. Returns false if it cannot be found.
  bool choosePlace(Plan& plan) const;
  void prepare(const std::shared_ptr<CulledMesh>& mesh);
  void forgetOld();

  /// Draws culled or whole, whichever was faster.
  void drawTried(const Plan& plan);
  /// Returns false if nothing was drawn, because the visible parts are not known yet, or the framebuffer
  /// cannot be copied.
  bool drawCulled(const Plan& plan);
  /// Like drawCulled(), with visibility found in a copy of the framebuffer. If `verified`, compares the
  /// results of this and of the whole draw in copies, and makes the whole draw if they differ.
  bool drawRehearsed(const Plan& plan, bool verified);
  bool rehearse(const Plan& plan, std::vector<uint64_t>& visible);
  bool isSame(const Plan& plan, const std::vector<uint64_t>& visible);
  /// Records that a culled draw differed from the whole draw.
  void markDifferent(const Plan& plan);
  /// Counts the primitives that were skipped; `drawn`: number of drawn primitives.
  void countLeft(const Plan& plan, uint64_t drawn);
  void drawWhole(const Plan& plan) { drawReal(p_.shadow.real, plan.mode, plan.elements); }
  bool drawVerified(const Plan& plan);
  /// All pixels of the region, for comparison.
  struct Pixels {
    std::vector<float> depths;
    std::vector<uint32_t> colors;  // multisampled: colours and depths of all samples
    bool operator==(const Pixels&) const = default;
  };
  bool read(const Plan& plan, Pixels& pixels);
  /// The farthest depth of each pixel's samples.
  bool readFarthest(const Plan& plan);
  /// Reads the depth of the region and finds the parts that may be visible. Returns false if depth cannot be
  /// read.
  bool findVisible(const Plan& plan, std::vector<uint64_t>& visible);
  void drawParts(const Plan& plan, const std::vector<uint64_t>& parts);
  /// Draws the clusters. `as`: the instances of the draw.
  void drawClusters(const CulledMesh& mesh, std::span<const uint64_t> clusters, const Elements& as);
  static uint64_t primitivesIn(const Plan& plan, const std::vector<uint64_t>& parts);
  static void findClustersOfInstances(const Plan& plan, const DepthPyramid& pyramid,
                                      std::vector<uint64_t>& visible);
  /// Calls each(unit, clusters) for all units of `parts`.
  template <class Each>
  static void forClustersOfInstances(const Plan& plan, const std::vector<uint64_t>& parts, const Each& each) {
    const size_t words = plan.mesh->clusters().words();
    for (uint32_t unit = 0; unit < plan.units->units(); ++unit)
      each(unit, std::span(parts).subspan(words * unit, words));
  }
  /// Whether a pixel of these parts has exactly the framebuffer's depth, so that the drawing order decides.
  bool meetsEqual(const Plan& plan, const std::vector<uint64_t>& parts);

  Parts p_;
  TrialBudget trials_;
  RestorePoint before_;
  std::unordered_map<const KnownProgram*, std::unique_ptr<CulledProgram>> programs_;
  std::unordered_map<Hash128, Known> meshes_;
  ConstantAttributes constants_;
  BackgroundJob job_;
  std::shared_ptr<CulledMesh> building_;
  bool placed_ = false;  // for the current draw
  std::vector<float> depths_;
  DepthPyramid pyramid_;
  std::vector<uint32_t> indices_;
  GLuint indexBuffer_ = 0, query_ = 0;
  SmallDraws small_;
  bool fixedDiffers_ = false;  // a small draw by fixed function was visible
};

}  // namespace gluray::gl
