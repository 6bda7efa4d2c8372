// The tracing and shading kernels, compiled for several instruction sets; the first call chooses the best for
// this processor. Called on tracing threads.
#pragma once
#include "render/frame_data/frame_data.h"
#include "render/tiles/tile.h"

namespace gluray::render {

struct HiddenPixels;
struct TileVisibility;
struct WaitingPoints;

/// Traces and shades one tile of every sample plane. Threads may run it in parallel on different tiles.
/// `waiting`: queue of points, if visibility is collected (FrameData::collector).
void traceTile(const FrameData&, const Tile&, WaitingPoints* waiting = nullptr);

/// Finds the hits and depths of a tile: FrameData::seen, and the image's depths. Colours stay undefined.
void traceEyeRays(const FrameData&, const Tile&);

/// Lights the hits that traceEyeRays() has found, except those in `hidden`: writes their colours, or, if
/// visibility is collected, puts their points into `waiting`. May be called again.
void lightSeen(const FrameData&, const Tile&, const HiddenPixels& hidden, WaitingPoints* waiting = nullptr);

/// Second pass over a tile of a moving frame (FrameData::moving): colours the hits that the first pass
/// stored.
void relightTile(const FrameData&, const Tile&, const TileVisibility&);

/// Name of the instruction set that traceTile uses, such as "AVX3".
const char* kernelTarget();

}  // namespace gluray::render
