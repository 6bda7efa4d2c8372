// A context of the shadow GL over a real one in memory: what a program meets behind a door, without the door.
#pragma once
#include "gl/context.h"
#include "tests/support/imitated_code.h"
#include "tests/support/osmesa_context.h"
#include "tests/support/picture.h"

namespace gluray::test {

class TracedContext {
 public:
  /// Current in the creating thread until destroyed. Shading is per vertex, as the real OpenGL's.
  /// `presenter` stands in for the one that traces. `share` is a context whose lists and buffers it shares.
  /// `source`, where there is one, has the settings instead of `settings`.
  /// `families` are those of shader programs; null: those that are built in, read when they are needed.
  explicit TracedContext(const ContextWish& wish = {}, Settings settings = vertexShading(),
                         std::unique_ptr<gl::Presenter> presenter = nullptr,
                         const TracedContext* share = nullptr,
                         std::shared_ptr<const gl::FamilyList> families = familiesOfTests(),
                         const SettingsSource* source = nullptr);
  ~TracedContext();
  TracedContext(const TracedContext&) = delete;
  TracedContext& operator=(const TracedContext&) = delete;

  /// Instead of the one that is current in this thread.
  void makeCurrent();

  static Settings vertexShading();
  /// What is usual, but that small scenes are traced, too.
  static Settings tracing();
  /// Our functions, as table.
  static const gl::RealGl& stubs();
  /// Our functions: what the program calls.
  const gl::RealGl& gl() const { return stubs(); }
  const OsmesaContext& below() const { return *below_; }
  const gl::Context& context() const { return *context_; }
  /// Colour and depth as the program reads them.
  Picture read() const;

 private:
  std::unique_ptr<OsmesaContext> below_;
  std::unique_ptr<gl::Presenter> presenter_;
  std::shared_ptr<gl::Context> context_;
};

/// Colour and depth of what `gl` has bound for reading.
Picture readPicture(const gl::RealGl& gl, int width, int height);

}  // namespace gluray::test
