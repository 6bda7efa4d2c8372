// One OpenGL context as we see it: which vertices are held back, what the pending batch is, what state has
// changed. Made by intercept/, used by generated stubs and handlers, always on the thread where the context
// is current.
#pragma once
#include "gl/arrays/arrays.h"
#include "gl/batch/batch.h"
#include "gl/batch/depth_copy.h"
#include "gl/batch/presenter.h"
#include "gl/batch/resolve_draws.h"
#include "gl/buffers/attachments.h"
#include "gl/capture/current_values.h"
#include "gl/capture/immediate.h"
#include "gl/capture/material_latch.h"
#include "gl/context_info.h"
#include "gl/draws/coplanar_surfaces.h"
#include "gl/draws/draw_kinds.h"
#include "gl/draws/multipass_surfaces.h"
#include "gl/draws/ray_precision.h"
#include "gl/layers/layer_draws.h"
#include "gl/lists/list_compiler.h"
#include "gl/programs/program_draws.h"
#include "gl/real.h"
#include "gl/share_group.h"
#include "gl/state/attrib_stack.h"
#include "gl/state/state.h"
#include "gl/statistics.h"
#include "gl/textures/texture.h"
#include "gl/thread_state.h"
#include "gl/window/antialiased_picture.h"
#include "gl/window/engine_choice.h"
#include "gl/window/window_frames.h"

#include <exception>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace gluray::gl {

/// What a generated stub must do when `attention` is set.
enum class Gate {
  run,      // go on
  forward,  // call the real OpenGL only
  refuse,   // an error was recorded; return 0
  compile,  // a display list is being compiled
};

class Context {
 public:
  /// The real context must be current, now or when the first call arrives.
  static std::shared_ptr<Context> create(const RealGl& real, std::shared_ptr<ShareGroup> group,
                                         const ContextInfo& info, Presenter& presenter);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  const RealGl& real;
  bool attention =
      false;  // passthrough, inside glBegin, a run is open, or a list is compiled: stubs ask gate()
  uint32_t dirty = kAllGroups;  // StateGroups to read back before the next draw needs them
  State state;                  // valid where not dirty; use refresh()
  ArrayState arrays;            // the same for kFixedArrays
  ArrayState attributes;        // the same for kAttributes
  Attachments attachments;      // buffers in vertex array objects
  CurrentValues current;        // current attributes: ours, or after refresh(kCurrent)
  MaterialLatch latch;
  Passes passes;
  Sheets sheets;
  RayPrecision precision;
  // Parts that have rules of their own. Each knows this context; what they share is here.
  Immediate immediate;
  ListCompiler lists;
  AttribStack attribStack;
  LayerDraws layers;
  ResolveDraws resolves;
  WindowFrames window;
  ProgramDraws programs;

  Statistics statistics;
  uint64_t frame = 1;
  double beganSeconds = 0;  // when this frame was first seen to clear or draw; 0: not yet

  // --- for generated stubs
  // -------------------------------------------------------------------------------------------
  /// `anywhere`: the command is legal between glBegin and glEnd and deals with runs and lists itself.
  /// `compiled`: lists take it.
  Gate gate(bool anywhere = false, bool compiled = true) noexcept;
  bool passthrough() const { return passthrough_; }
  template <class F>
  auto protect(F&& body) noexcept -> decltype(body());
  /// protect(), and once more where a failure came before `body` was done: a capture that failed has become a
  /// draw of the real OpenGL by then, and memory may be there again.
  template <class F>
  void insist(F&& body) noexcept;
  void syncCurrent() {
    if (current.anyUnsent()) [[unlikely]]
      current.send(real);
  }
  /// Before a command that we do not model is forwarded: attributes are sent, and the batch too if it may
  /// matter.
  /// look: it draws nothing, but looks at what was drawn; leave: later draws go to another framebuffer, but
  /// nobody looks; redirect: so they do, or what pending draws need changes.
  enum class Flush { none, look, leave, redirect, all };
  void beforeForward(Flush flush) noexcept;
  void count(int command) noexcept;
  void touch(uint32_t groups) { dirty |= groups; }

  // --- for intercept/
  // ------------------------------------------------------------------------------------------------
  /// Called on the thread where the context has just been made current, or is about to lose it.
  void makeCurrent();
  void loseCurrent();
  /// Shows what is pending, before a buffer swap, and after it.
  void beforeSwap();
  void afterSwap();
  /// The frame is complete and about to be shown.
  void completeFrame();
  /// Programs that draw into memory alone may never swap or finish: clears of colour and depth are the frames
  /// of those. Called before and after the real clear.
  void clearing(GLbitfield mask);
  void cleared(GLbitfield mask);
  /// What the draw framebuffer is known to hold, where it is but a clear.
  const std::optional<ClearedTarget>& clearedTarget() const { return cleared_; }
  /// Something may have been drawn, or sent, into the draw framebuffer.
  void forgetClear() { cleared_.reset(), smooth_ = {}; }
  /// The same of the texture bound to `target`, which may be attached to the framebuffer.
  void imageSent(GLenum target);
  /// After that, where it was a part of the framebuffer's picture that was copied.
  void imageCopied(GLenum target, GLint level, glm::ivec2 offset, const scene::Region& from);
  /// Traces the pending batch and writes it into the framebuffer. Nothing to do if there is none.
  void flush() {
    settle();
    flushBatch();
  }
  /// The same of the batch alone, not of pictures that wait for being resolved.
  void flushBatch() {
    if (layers.holdsDepths()) layers.giveUp();
    present();
    if (layers.asks()) layers.giveUp();
  }
  /// The same where what is drawn next goes elsewhere, but nobody looks at what was drawn so far.
  void redirect() {
    settle();
    present();
  }
  /// The same where another framebuffer is bound: the batch may wait for being resolved.
  void leave();
  /// Before the draw framebuffer is cleared: as redirect(), but that what the clear hides is let go. What is
  /// clean then, for ResolveDraws::cleanIs() after the real clear.
  Unresolved::Cleared beforeClear(GLbitfield mask);
  /// Writes pictures that wait elsewhere into their framebuffers: all, or those that a draw of now may meet.
  void settle();
  void settleBelow(int samples);
  /// Presents what was held back, into the framebuffer of its time. `known`: its picture is.
  void presentLate(const BatchKey& key, const scene::SnapshotPtr& snapshot, std::vector<ProgramDraw> draws,
                   bool known);
  /// Counts what came of a picture. `known`: it was shown before, elsewhere.
  void takeResult(const PresentResult& result, bool known = false);
  /// Before images of textures, or a buffer's contents, change: draws that are kept with their names are
  /// made.
  void imagesChange() noexcept;
  void contentsChange(GLuint buffer) noexcept;
  /// From now on every draw is rasterised; what was held back is given to the real OpenGL.
  void stepAside(const char* why) noexcept;
  bool aside() const { return aside_; }
  /// For glFlush and glFinish: shows what is pending if anybody could see it before the next swap.
  void showIfVisible();
  /// Calls of commands that we do not model, by index into kCommandNames.
  const std::vector<Counter<uint64_t>>& unknownCalls() const { return unknownCalls_; }
  const ContextInfo& info() const { return info_; }
  /// The settings of this frame: from its beginning, which is the swap before it or its first clear where
  /// that comes before its draws, to its end.
  const Settings& settings() const { return settings_; }
  /// Before a clear: where the frame begins with it, takes the settings of now.
  void beforeClearTakeSettings() noexcept;

  // --- for handlers
  // --------------------------------------------------------------------------------------------------
  /// The first error since the program asked stays, ours or the real OpenGL's.
  void setError(GLenum error);
  GLenum takeError();
  ShareGroup& group() { return *group_; }
  const std::shared_ptr<ShareGroup>& sharedGroup() const { return group_; }
  TextureCache& textures() { return textures_; }
  Batch& batch() { return batch_; }
  Presenter& presenter() { return presenter_; }

  /// Reads `groups` back where they changed.
  void refresh(uint32_t groups) noexcept;
  void readGroups(uint32_t groups);

  bool insideBegin() const { return immediate.insideBegin(); }
  bool compiling() const { return lists.compiling(); }
  bool executing() const { return lists.executing(); }
  /// Tells stubs what they are to do, after any of these has changed.
  void updateAttention();

  // Frames that are left to the real OpenGL (direct.cpp).
  /// Whether draws go to it as they come. Then nothing is read back or kept but display lists.
  bool direct() const { return direct_; }
  /// Whether the draw that comes goes there: it is counted and may be sent. Otherwise, because it is too
  /// large, the rest of the frame is drawn as ever.
  bool drawsDirectly(DrawPath path, PrimitiveClass kind, uint64_t triangles);
  /// The first clear or draw of a frame starts its measurement.
  void works() {
    if (choice_.wantsStart()) [[unlikely]]
      startMeasuring();
  }
  /// Whether this frame's duration is measured, so that nothing may be shown again or later.
  bool measured() const { return choice_.wantsStop(); }
  bool startsMeasuring() const { return choice_.wantsStart(); }
  /// Whether a surface of so many triangles is left to the real OpenGL, however much there is in all.
  bool leavesAlone(uint64_t triangles) const {
    return choice_.way() == EngineChoice::Way::mixed && choice_.takesAlone(triangles, viewportPixels());
  }
  /// The same of surfaces that are blended in the order of drawing.
  bool leavesLayers(uint64_t triangles) const { return choice_.takesLayers(triangles, viewportPixels()); }

  int activeQueries = 0;  // queries and conditional renderings that count or guard draws
  GLenum matrixMode = 0;  // 0: ask the real OpenGL
  /// Whether the real OpenGL renders on the CPU.
  bool isSoftwareBelow();
  /// Whether pictures of ours can be shown by this OpenGL.
  bool canTrace();
  /// Why a surface with this mesh cannot be traced now, or Reason::traced. Call refresh(kDrawGroups) before.
  Reason triage(PrimitiveClass kind);
  Reason triage(const KnownMesh& mesh, const std::vector<MaterialChange>& materials);
  /// Does what the draw would do where it is a full-screen pass that costs less without the real OpenGL.
  /// False: draw it.
  bool replacePass(GLenum mode, const Elements& elements);
  /// A glBlitFramebuffer that ResolveDraws::byBlit() does not do, after beforeBlit().
  void beforeBlit() noexcept;
  void blit(Blit blit);
  /// Runs `trace`, which says whether it added a draw to the batch. A failure of ours makes the draw
  /// rasterised, not lost.
  template <class F>
  Reason attempt(F&& trace);
  /// Adds a mesh to the batch with the state of now. `materials` beside the current one.
  void addInstance(const scene::MeshPtr& mesh, SlotMask slots, const std::vector<MaterialChange>& materials);
  /// Makes the real OpenGL ready for a draw of its own: order, attributes.
  void beforeRasterDraw(PrimitiveClass kind);
  /// Whether a surface that is rasterised now may lie upon others of its layer, so that it matters which
  /// depth those left. Its triangles are then to be shown to meetPasses(), before beforeRasterDraw().
  bool mayMeetPasses(PrimitiveClass kind) const;
  void meetPasses(std::span<const Triangle> triangles);
  /// The surfaces that were found to have another pass get the depth of the real OpenGL.
  void rasteriseMet(Passes::Meeting meeting);
  /// Whether surfaces are compared with the depth that is there.
  bool meetsDepth(PrimitiveClass kind) const;
  /// Whether a rasterised draw leaves depth for passes that come: after meetPasses() it is then given to
  /// rememberPass().
  bool isPass(PrimitiveClass kind, Reason reason) const;
  void rememberPass(const KnownMesh& known);
  /// Cuts off what lies beyond the draw framebuffer.
  void clampToTarget(scene::Region& region);
  /// Where a draw that moves depth by `offset` puts its mesh now.
  SheetPlace sheetPlace(const glm::dmat4& clipFromObject, scene::PolygonOffset offset) const;
  /// Whether surfaces are drawn with a polygon offset away from the viewer.
  bool isPushedBack() const;
  void countRaster(Reason reason, DrawPath path, PrimitiveClass kind, uint64_t triangles);
  void countTraced(DrawPath path, uint64_t triangles);
  /// What was counted as traced was drawn by the real OpenGL in the end.
  void countAsRasterised(const scene::Snapshot& snapshot, Reason reason);
  /// Both count these; so does the end of a primitive that the real OpenGL was given.
  void noteLoad(uint64_t triangles);
  /// Who takes draws by kind; null: nobody.
  DrawKinds* kinds() const { return info_.kinds.get(); }
  /// Gives the real OpenGL the contents of buffers that its draws may read.
  void sendBuffers();

 private:
  Context(const RealGl& real, std::shared_ptr<ShareGroup> group, const ContextInfo& info,
          Presenter& presenter);
  /// Traces the batch or, for a reason, has the real OpenGL draw it.
  void present(Reason reason = Reason::traced);
  /// triage() where everything that can be is traced.
  Reason triageAlways(const KnownMesh& mesh, const std::vector<MaterialChange>& materials);
  /// Whether every fragment of a surface with this mesh has alpha 1.
  bool isOpaque(const scene::Mesh& mesh, const std::vector<MaterialChange>& materials) const;
  /// Whether one that can be traced is a layer, blended in the order of drawing (LayerDraws::mayBeDrawn()).
  bool isLayer(const scene::Mesh& mesh, const std::vector<MaterialChange>& materials) const;
  void noteClear(GLbitfield mask);
  std::optional<ClearedTarget> clearedUnder(const scene::Snapshot& snapshot, const BatchKey& key);
  bool antialiasInto(GLuint attachment, const scene::Region& region, bool instead);
  void takeSettings();
  void startMeasuring();
  void chooseEngine();
  bool clearsViewport() const;
  void setDirect(bool direct);
  void showDrawn();
  void showFront();
  double viewportPixels() const {
    return static_cast<double>(state.viewport.z) * static_cast<double>(state.viewport.w);
  }
  uint64_t draws() const { return statistics.drawsTraced + statistics.drawsRasterised; }
  /// Grows with everything that is drawn and may be kept: pictures, and meshes that were never traced.
  uint64_t work() const { return statistics.flushes + statistics.meshesBuilt; }
  void deleteDiscarded();
  /// Lets go of meshes that have not been used lately.
  void forgetOld();

  std::shared_ptr<ShareGroup> group_;
  ContextInfo info_;
  Settings settings_;
  uint64_t settingsVersion_ = 0;  // of the source when they were taken
  bool begun_ = false;            // this frame has cleared
  uint64_t drawsBefore_ = 0;      // draws until this frame
  Presenter& presenter_;
  bool passthrough_ = false;  // we are not there: every call goes to the real OpenGL
  EngineChoice choice_;
  bool direct_ = false;  // draws go to the real OpenGL as they come
  bool aside_ = false;   // after a failure of ours: draws are rasterised, all else goes on
  bool supportKnown_ = false, supported_ = true;
  enum class Answer { unknown, no, yes };
  Answer softwareBelow_ = Answer::unknown;  // the real OpenGL renders on the CPU
  GLenum error_ = GL_NO_ERROR;

  uint64_t drawsInFront_ = 0;             // draws until the last frame in the front buffer
  int clears_ = 0;                        // of colour and depth since forgetOld()
  uint64_t workForgotten_ = 0;            // work() at that time
  std::optional<ClearedTarget> cleared_;  // the draw framebuffer, if it is worth knowing
  Smooth smooth_;
  glm::ivec2 drawableSize_{0};  // largest size that the window is known to have had
  scene::Region sizeAskedFor_;
  TextureCache textures_{*group_};
  Batch batch_;
  std::vector<Counter<uint64_t>> unknownCalls_;
};

template <class F>
auto Context::protect(F&& body) noexcept -> decltype(body()) {
  try {
    return body();
  } catch (const std::exception& e) { stepAside(e.what()); } catch (...) {
    stepAside("unknown error");
  }
  if constexpr (!std::is_void_v<decltype(body())>) return {};
}

template <class F>
void Context::insist(F&& body) noexcept {
  bool done = false;
  const auto once = [&] { body(), done = true; };
  protect(once);
  if (!done) protect(once);
}

template <class F>
Reason Context::attempt(F&& trace) {
  try {
    return trace();
  } catch (const std::exception& e) { stepAside(e.what()); }
  return Reason::failure;
}

/// Groups that decide whether and how a surface is traced.
inline constexpr uint32_t kDrawGroups = kModelview | kProjection | kViewport | kRaster | kLighting |
                                        kMaterial | kFixedTextures | kClip | kTarget | kCurrent;

/// The same for surfaces that a shader program draws.
inline constexpr uint32_t kProgramGroups =
    kViewport | kRaster | kTarget | kClip | kProgram | kProgramTextures | kAttributes;

}  // namespace gluray::gl
