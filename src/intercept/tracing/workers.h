// The connection to the workers that trace for this process. Any thread.
#pragma once
#include "cluster/program/remote_tracer.h"

namespace gluray::intercept {

/// The workers that the session's settings name; null if this process traces. Created by the first call,
/// never destroyed.
cluster::RemoteTracer* workers();

/// Traces in this process. `stop`: as in frame::TraceBehind; null: as in frame::Trace.
bool traceHere(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost, std::string& error,
               const std::function<bool()>& stop);

}  // namespace gluray::intercept
