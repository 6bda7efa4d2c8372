// Finds where a framebuffer still shows an image that was written into it, to replace the image by another
// one of the same surfaces. Pure functions; any thread.
#pragma once
#include "base/image.h"
#include "scene/snapshot.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace gluray::scene {

/// The part of an image that holds hits, reduced to RGBA8 colours and the depths that are written. Pixels
/// that are averages over several rays hold colours times coverage, with the coverage as alpha. Empty where
/// nothing was hit, or the colours are not bytes. Throws std::bad_alloc.
Image writtenPart(const Image& image);

/// What a framebuffer holds in the rectangle of an image, bottom row first.
struct ShownPixels {
  std::vector<uint32_t> colors;  // RGBA8; of several samples, their mean
  std::vector<float> depths;     // window depths; empty: they are compared elsewhere
  float depthStep = 0;           // depths that differ by at most this are equal
};

/// Images that were written later over the same view.
struct LaterImages {
  std::span<const std::shared_ptr<const Image>> parts = {};  // by writtenPart(), in the order of drawing
  bool largestWins = false;                                  // larger depths are nearer
};

/// Makes `out` the image that must be written, without a blend, so that the framebuffer shows `now` where it
/// shows `written`; it misses elsewhere. Both are parts as writtenPart() returns them; `shown` is in the
/// rectangle of `written`. Pixels count as shown where colours (alpha does not count) and depths are equal.
/// Pixels that a surface covers in part count where their colours can hold the surface's, and one of the
/// eight neighbours is covered in full and shown. Pixels over which later averages were blended count where
/// their colours and depths are those of the blend; they keep the share of the later images, and their depth
/// is the one of the blend. Several samples: a depth test for equality must protect those of other surfaces.
/// Throws std::bad_alloc. Returns the number of pixels to be written.
size_t findReplaced(const Image& written, const Image& now, const ShownPixels& shown, Image& out,
                    const LaterImages& later = {});

/// Replaces `before` by `now` in the colours over which layers are drawn that cover `region`, where those
/// show `before`. Throws std::bad_alloc.
void replaceUnder(Layers& layers, const Region& region, const Image& before, const Image& now);

}  // namespace gluray::scene
