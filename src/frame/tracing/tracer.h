// Functions for presenters to trace snapshots. Any thread.
#pragma once
#include "base/image.h"
#include "render/media/sample_illumination.h"
#include "scene/fxaa.h"
#include "scene/resolve.h"
#include "scene/snapshot.h"
#include "scene/trace_cost.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace gluray::frame {

/// Traces a snapshot. Returns false with a one-line reason on failure; never throws. frame::Renderer::render
/// in the engine. Any thread.
using Trace = std::function<bool(const scene::Snapshot&, Image&, scene::TraceCost&, std::string& error)>;

/// Traces a snapshot with the lowest priority, until `stop` returns true. Returns false without an error if
/// stopped or preempted. frame::Renderer::renderBehind in the engine.
using TraceBehind = std::function<bool(const scene::Snapshot&, Image&, scene::TraceCost&, std::string& error,
                                       const std::function<bool()>& stop)>;

/// Anti-aliases an image, `in` to `out`. False on failure; never throws. frame::Renderer::antialias in the
/// engine.
using Antialias = std::function<bool(const Settings&, const scene::Fxaa&, const uint32_t* in, int width,
                                     int height, uint32_t* out)>;

/// Resolves the samples of an image into pixels. False on failure; never throws. frame::Renderer::resolve in
/// the engine.
using Resolve = std::function<bool(const Settings&, const scene::Resolve&, const Image& samples, Image& out)>;

/// Whether tracing an unchanged scene again would free memory or speed up later images; never throws.
/// frame::Renderer::improves in the engine.
using Improves = std::function<bool()>;

/// Whether equal snapshots have equal images. False if other processes have surfaces of the view. Never
/// throws.
using StandsAlone = std::function<bool(const scene::Snapshot&)>;

/// The light that arrives at the samples of the snapshot's volume; null: the settings change nothing for it,
/// or it failed, with the reason in the log. Never throws. frame::Renderer::illuminate in the engine.
using Illuminate = std::function<std::shared_ptr<const render::SampleIllumination>(const scene::Snapshot&)>;

/// Called for each new image that is shown, after its passes. `finished`: no further passes follow. Never
/// throws.
using Shown = std::function<void(const scene::Snapshot&, const Image&, bool finished)>;

/// Ground and background for MPI programs that composite the images of their ranks. Images of trace()
/// that show the data of several ranks lack both. Functions never throw.
struct Scenery {
  // Whether the last image is of this snapshot, shows the data of several ranks, and was made for this
  // rank.
  std::function<bool(const scene::Snapshot&)> isGathered;
  Trace trace;                     // traces the snapshot with ground and background
  std::function<void()> leaveOut;  // reports that the program's image lacks both
};

/// All functions; empty functions are skipped.
struct Tracer {
  Trace trace;
  Antialias antialias = {};
  Resolve resolve = {};
  Improves improves = {};
  Illuminate illuminate = {};  // empty: volumes neither get nor block light
  TraceBehind behind = {};
  StandsAlone standsAlone = {};
  Shown shown = {};
  Scenery scenery = {};
};

}  // namespace gluray::frame
