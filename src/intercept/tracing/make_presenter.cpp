#include "intercept/tracing/make_presenter.h"

#include "intercept/present/tracing_presenter.h"
#include "intercept/tracing/shared_renderer.h"
#include "intercept/tracing/workers.h"

namespace gluray::intercept {
namespace {

bool behind(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost, std::string& error,
            const std::function<bool()>& stop) {
  if (cluster::RemoteTracer* const job = workers()) return job->trace(snapshot, image, cost, error, stop);
  return traceHere(snapshot, image, cost, error, stop);
}

bool trace(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost, std::string& error) {
  return behind(snapshot, image, cost, error, nullptr);
}

bool antialias(const Settings& settings, const scene::Fxaa& fxaa, const uint32_t* in, int width, int height,
               uint32_t* out) {
  return sharedRenderer().antialias(settings, fxaa, in, width, height, out);
}

bool resolve(const Settings& settings, const scene::Resolve& how, const Image& samples, Image& out) {
  return sharedRenderer().resolve(settings, how, samples, out);
}

bool improves() {
  const cluster::RemoteTracer* const job = workers();
  return job ? job->improves() : sharedRenderer().improves();
}

/// Traces and writes back nothing, to measure the cost of interception.
class NullPresenter final : public gl::Presenter {
 public:
  gl::PresentResult present(const gl::RealGl&, const scene::SnapshotPtr&,
                            const gl::PresentTarget&) noexcept override {
    gl::PresentResult result;
    result.outcome = gl::PresentResult::traced;
    return result;
  }
  bool supports(const gl::RealGl&, bool core, std::string& why) noexcept override {
    if (core) why = "core profile";
    return !core;
  }
  void forget(const gl::RealGl&) noexcept override {}
};

}  // namespace

std::unique_ptr<gl::Presenter> makePresenter(const Settings& settings, present::Written onWritten,
                                             bool refinesWindows) {
  if (settings.renderer == Renderer::null) return std::make_unique<NullPresenter>();
  frame::Tracer tracer{trace, antialias, resolve, improves};
  if (refinesWindows) tracer.behind = behind;
  if (!workers())
    tracer.illuminate = [](const scene::Snapshot& snapshot) { return sharedRenderer().illuminate(snapshot); };
  if (cluster::RemoteTracer* const job = workers()) {
    tracer.standsAlone = [job](const scene::Snapshot& snapshot) { return job->standsAlone(snapshot); };
    tracer.shown = [job](const scene::Snapshot& snapshot, const Image& image, bool finished) {
      job->shown(snapshot, image, finished);
    };
    tracer.scenery = {[job](const scene::Snapshot& snapshot) { return job->isGathered(snapshot); },
                      [job](const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost,
                            std::string& error) { return job->traceComplete(snapshot, image, cost, error); },
                      [job] { job->leaveSceneryOut(); }};
  }
  return std::make_unique<present::TracingPresenter>(tracer, std::move(onWritten));
}

}  // namespace gluray::intercept
