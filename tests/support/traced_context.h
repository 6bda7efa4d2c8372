// A context of the shadow GL over a real one in memory: the same engine that a program uses, without a door.
#pragma once
#include "gl/context/context.h"
#include "tests/support/drawn_image.h"
#include "tests/support/imitated_code.h"
#include "tests/support/osmesa_context.h"

namespace gluray::test {

class TracedContext {
 public:
  /// Current in the creating thread until destroyed. Shading is per vertex, as the real OpenGL's.
  /// `presenter` replaces the one that traces. `share` is a context whose lists and buffers it shares.
  /// `source`, if given, replaces `settings`.
  /// `families` are those of shader programs; null: the built-in families, read on demand.
  /// `clock` measures frames and draws.
  explicit TracedContext(const ContextWish& wish = {}, Settings settings = vertexShading(),
                         std::unique_ptr<gl::Presenter> presenter = nullptr,
                         const TracedContext* share = nullptr,
                         std::shared_ptr<const gl::FamilyList> families = familiesOfTests(),
                         SettingsSource* source = nullptr, gl::EngineChoice::Clock clock = nowSeconds);
  ~TracedContext();
  TracedContext(const TracedContext&) = delete;
  TracedContext& operator=(const TracedContext&) = delete;

  /// Makes it current in this thread.
  void makeCurrent();
  /// As if its drawable had a back buffer or not; at first it has none.
  void setDoubleBuffered(bool doubleBuffered) { context_->setDoubleBuffered(doubleBuffered); }

  static Settings vertexShading();
  /// The default settings, except that small scenes are traced, too.
  static Settings tracing();
  /// GLuRay's functions, as a table.
  static const gl::RealGl& stubs();
  /// GLuRay's functions, which the program calls.
  const gl::RealGl& gl() const { return stubs(); }
  const OsmesaContext& below() const { return *below_; }
  const gl::Context& context() const { return *context_; }
  /// Colour and depth, read as by the program.
  DrawnImage read() const;

 private:
  std::unique_ptr<OsmesaContext> below_;
  std::unique_ptr<gl::Presenter> presenter_;
  std::shared_ptr<gl::Context> context_;
};

/// Colour and depth of the framebuffer that `gl` has bound for reading.
DrawnImage readImage(const gl::RealGl& gl, int width, int height);

}  // namespace gluray::test
