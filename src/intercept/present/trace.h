// What makes pictures of snapshots, for those who present them.
#pragma once
#include "base/image.h"
#include "scene/snapshot.h"

#include <cstdint>
#include <functional>
#include <string>

namespace gluray::present {

/// What one tracing cost.
struct TraceCost {
  double buildSeconds = 0, traceSeconds = 0;
  uint64_t blasBuilds = 0, blasRefinements = 0, bvhBytes = 0;
  bool blasRefining = false;
};

/// Traces a snapshot. False with one line of reason on failure; never throws. frame::Renderer::render in the
/// engine. Any thread.
using Trace = std::function<bool(const scene::Snapshot&, Image&, TraceCost&, std::string& error)>;

}  // namespace gluray::present
