// What processes with parts of a view need to compare depths before they trace light. Any thread.
#pragma once
#include "base/image.h"
#include "render/tiles/drawn_part.h"
#include "render/tiles/tile.h"

namespace gluray::render {

struct FrameData;

/// A tile without surfaces, in the image.
void clearTile(const Tile&, Image&);

/// The part of the view with the frame's surfaces. Bounds are wider than necessary by rounding.
DrawnPart drawnPart(const FrameData&);

/// The smallest difference of depths that the framebuffer tells apart for sure.
float depthStep(const FrameData&);

/// Why the frame's pixels are lit before other processes tell their depths; null: they may wait for these.
const char* reasonAgainstDepthsFirst(const FrameData&);

}  // namespace gluray::render
