// Draws that are not traced, made by the real OpenGL without what cannot be seen (adr/0064): by shader
// programs, and by fixed function. A part of each
// Context, GL thread.
#pragma once
#include "base/background_job.h"
#include "base/hash.h"
#include "gl/arrays/elements.h"
#include "gl/batch/flusher.h"
#include "gl/culled/culled_mesh.h"
#include "gl/culled/culled_program.h"
#include "gl/culled/culling_trials.h"
#include "gl/culled/restore_point.h"
#include "gl/draws/draw_counts.h"
#include "gl/draws/reasons.h"
#include "gl/failsafe.h"
#include "gl/state/shadow_state.h"
#include "gl/window/frame_clock.h"

#include <GL/gl.h>

#include <cstdint>
#include <memory>
#include <optional>
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
    Flusher& flusher;
    const RasterDraws& raster;
  };
  explicit CulledDraws(const Parts& parts) : p_(parts), before_(parts.shadow, parts.flusher, parts.raster) {}
  ~CulledDraws();

  /// Makes a draw, which is rasterised, of the current shader program or, where there is none, by fixed
  /// function; call RasterDraws::before() and ShadowState::sendBuffers() before. False: nothing was drawn.
  /// Never throws.
  bool draw(GLenum mode, const Elements& elements) noexcept;

  /// Where a draw's vertices come from, and the matrix that puts them into clip space.
  struct Source {
    const ArrayState* arrays = nullptr;
    const ArraySource* positions = nullptr;  // one of `arrays`
    int components = 4;                      // of these that count
    ClipMatrix matrix;
    CulledProgram* program = nullptr;  // null: fixed function
  };
  /// Finds it for draws with the current state. Reason::traced, or why it is not known, or why what is hidden
  /// at the end shows.
  Reason source(Source& source);

 private:
  struct Known {
    std::shared_ptr<CulledMesh> mesh;
    CullingTrials trials;
    uint64_t lastFrame = 0;  // that drew it
    int frames = 0;          // that drew it
    bool refused = false;    // its positions cannot be read
    bool different = false;  // a picture was not the same, without a shader program
  };
  /// What a draw needs, found before anything is drawn.
  struct Plan {
    CulledProgram* program = nullptr;  // null: fixed function
    std::shared_ptr<CulledMesh> mesh;
    Known* known = nullptr;
    ClipMatrix matrix;
    scene::Region region;  // pixels that may be drawn
    WindowMapping window;
    int samples = 1;         // of a pixel
    bool rehearsed = false;  // what shows is found in a copy of the framebuffer, which cannot be put back
    bool reversed = false;   // larger depths are nearer: `window` maps to 1 - depth
  };

  /// Why the draw is not culled, or Reason::traced.
  Reason plan(GLenum mode, const Elements& elements, Plan& plan);
  Reason sourceOfProgram(Source& source);
  Reason sourceOfFixedFunction(Source& source);
  Reason planMesh(const Source& source, GLenum mode, const Elements& elements, Plan& plan);
  void mapWindow(Plan& plan) const;
  CulledProgram& programInUse();
  void prepare(const std::shared_ptr<CulledMesh>& mesh);
  void forgetOld();

  /// False: nothing was drawn, because nothing is known yet of what shows, or the framebuffer cannot be
  /// copied.
  bool drawCulled(const Plan& plan);
  struct Whole {
    GLenum mode;
    const Elements& elements;
  };
  /// The same with what shows found in a copy of the framebuffer. With `whole`, compares what both make of
  /// copies; where they differ the whole draw is made.
  bool drawRehearsed(const Plan& plan, const std::optional<Whole>& whole);
  bool rehearse(const Plan& plan, std::vector<uint64_t>& visible);
  bool isSame(const Plan& plan, const std::vector<uint64_t>& visible, const Whole& whole);
  /// The draw was not the same as a whole one.
  void isDifferent(const Plan& plan);
  /// So many of its primitives were drawn.
  void countLeft(const CulledMesh& mesh, uint64_t drawn);
  bool drawVerified(const Plan& plan, GLenum mode, const Elements& elements);
  /// All that the region shows, to be compared.
  struct Pixels {
    std::vector<float> depths;
    std::vector<uint32_t> colors;  // with several samples: of them all, depths, too
    bool operator==(const Pixels&) const = default;
  };
  bool read(const Plan& plan, Pixels& pixels);
  /// The farthest depth of each pixel's samples.
  bool readFarthest(const Plan& plan);
  /// Reads the depth of the region and finds what may show. False: it cannot be read.
  bool look(const Plan& plan, std::vector<uint64_t>& visible);
  void drawClusters(const CulledMesh& mesh, const std::vector<uint64_t>& clusters);
  /// Whether a pixel of these clusters has the very depth that is there: then the order of drawing decides.
  bool meetsEqual(const CulledMesh& mesh, const std::vector<uint64_t>& clusters);

  Parts p_;
  RestorePoint before_;
  std::unordered_map<const KnownProgram*, std::unique_ptr<CulledProgram>> programs_;
  std::unordered_map<Hash128, Known> meshes_;
  BackgroundJob job_;
  std::shared_ptr<CulledMesh> building_;
  std::vector<float> depths_;
  DepthPyramid pyramid_;
  std::vector<uint32_t> indices_;
  GLuint indexBuffer_ = 0, query_ = 0;
};

}  // namespace gluray::gl
