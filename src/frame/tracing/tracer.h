// The functions that presenters call to make pictures of snapshots. Any thread.
#pragma once
#include "base/image.h"
#include "scene/fxaa.h"
#include "scene/resolve.h"
#include "scene/snapshot.h"
#include "scene/trace_cost.h"

#include <cstdint>
#include <functional>
#include <string>

namespace gluray::frame {

/// Traces a snapshot. False with one line of reason on failure; never throws. frame::Renderer::render in the
/// engine. Any thread.
using Trace = std::function<bool(const scene::Snapshot&, Image&, scene::TraceCost&, std::string& error)>;

/// The same behind all other pictures, until `stop` says so. False without an error: stopped, or another
/// picture came first. frame::Renderer::renderBehind in the engine.
using TraceBehind = std::function<bool(const scene::Snapshot&, Image&, scene::TraceCost&, std::string& error,
                                       const std::function<bool()>& stop)>;

/// Anti-aliases a picture, `in` to `out`. False on failure; never throws. frame::Renderer::antialias in the
/// engine.
using Antialias = std::function<bool(const Settings&, const scene::Fxaa&, const uint32_t* in, int width,
                                     int height, uint32_t* out)>;

/// Resolves the samples of a picture into pixels. False on failure; never throws. frame::Renderer::resolve in
/// the engine.
using Resolve = std::function<bool(const Settings&, const scene::Resolve&, const Image& samples, Image& out)>;

/// Whether tracing an unchanged scene again would free memory or speed up later pictures; never throws.
/// frame::Renderer::improves in the engine.
using Improves = std::function<bool()>;

/// Whether the picture of a snapshot depends on nothing else. False where other processes hold surfaces of
/// the view: a later snapshot that is equal may have another picture. Never throws.
using StandsAlone = std::function<bool(const scene::Snapshot&)>;

/// Hears of each new picture that is shown, after all passes. `finished`: no more passes make it better.
/// Never throws.
using Shown = std::function<void(const scene::Snapshot&, const Image&, bool finished)>;

/// For MPI programs that compose the pictures of their ranks: ground and background, which pictures of
/// trace() lack where they show what several ranks draw. Functions never throw.
struct Scenery {
  // Whether the last picture is of this snapshot, shows what several ranks draw, and was made for this one.
  std::function<bool(const scene::Snapshot&)> isGathered;
  Trace trace;                     // traces the snapshot with all that it holds
  std::function<void()> leaveOut;  // the program's picture stays without
};

/// All of them; an empty function is skipped.
struct Tracer {
  Trace trace;
  Antialias antialias = {};
  Resolve resolve = {};
  Improves improves = {};
  TraceBehind behind = {};
  StandsAlone standsAlone = {};
  Shown shown = {};
  Scenery scenery = {};
};

}  // namespace gluray::frame
