#include "tests/support/traced_context.h"

#include "base/log.h"
#include "gl/real/extensions.h"
#include "intercept/stubs/stub_proc.h"
#include "intercept/tracing/make_presenter.h"

#include <cstdlib>
#include <string_view>

namespace gluray::test {
namespace {

/// As an engine does that reads the environment (tools/decisions.py).
void logDecisions(gl::ContextInfo& info) {
  const char* const level = std::getenv("GLURAY_LOG_LEVEL");
  const char* const file = std::getenv("GLURAY_LOG");
  if (!level || level != std::string_view("trace") || !file) return;
  if (!log::enabled(log::Level::trace)) log::configure(log::Level::trace, file);
  info.decisions = std::make_shared<gl::Decisions>();
  info.kinds = std::make_shared<gl::DrawKinds>(!info.core);
}

}  // namespace

Settings TracedContext::tracing() {
  Settings settings;
  settings.engine = Engine::always;
  return settings;
}

Settings TracedContext::vertexShading() {
  Settings settings;
  settings.shading = ShadingRate::vertex;
  settings.engine = Engine::always;
  return settings;
}

TracedContext::TracedContext(const ContextWish& wish, Settings settings,
                             std::unique_ptr<gl::Presenter> presenter, const TracedContext* share,
                             std::shared_ptr<const gl::FamilyList> families, SettingsSource* source,
                             gl::EngineChoice::Clock clock)
    : below_(OsmesaContext::create(wish, share ? share->below_.get() : nullptr)),
      presenter_(std::move(presenter)) {
  gl::ContextInfo info;
  info.version = gl::versionOf(below_->real());
  info.packedFloats = gl::takesPackedFloats(below_->real(), info.version);
  info.software = gl::rendersInSoftware(below_->real());
  info.core = wish.core;
  info.doubleBuffered = false;
  info.settings = settings;
  info.source = source;
  info.clock = clock;
  info.families = std::move(families);
  info.drawableSize = [wish] { return glm::ivec2(wish.width, wish.height); };
  logDecisions(info);
  if (!presenter_) presenter_ = intercept::makePresenter(settings);
  const auto group = share ? share->context_->shadow.sharedGroup : std::make_shared<gl::ShareGroup>();
  context_ = gl::Context::create(below_->real(), group, info, *presenter_);
  context_->makeCurrent();
}

TracedContext::~TracedContext() {
  context_->loseCurrent();
  context_.reset();
}

void TracedContext::makeCurrent() {
  if (gl::Context* last = gl::t_thread.context) last->loseCurrent();
  below_->makeCurrent();
  context_->makeCurrent();
}

const gl::RealGl& TracedContext::stubs() {
  static const gl::RealGl table = [] {
    gl::RealGl t;
    gl::loadRealGl(
        t, [](void*, const char* name) { return intercept::stubProc(name); }, nullptr);
    return t;
  }();
  return table;
}

DrawnImage TracedContext::read() const { return readImage(gl(), below_->width(), below_->height()); }

DrawnImage readImage(const gl::RealGl& gl, int width, int height) {
  const auto pixels = static_cast<size_t>(width) * static_cast<size_t>(height);
  DrawnImage image{width, height, std::vector<uint32_t>(pixels), std::vector<float>(pixels)};
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.colors.data());
  gl.ReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, image.depths.data());
  return image;
}

}  // namespace gluray::test
