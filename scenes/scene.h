// Small deterministic images, each for one piece of OpenGL, drawn through a table of GL functions: the real
// ones, or ours.
#pragma once
#include "gl/real/real.h"

#include <ostream>
#include <span>
#include <string_view>

namespace gluray::scenes {

using Gl = const gl::RealGl&;

/// How far the traced image may be from the real OpenGL's, with the reason where it is not the rule.
struct Tolerance {
  int color = 2;              // of 255, each channel
  double edgeShare = 0.0005;  // of all pixels may differ more: edges fall on either side of a pixel's centre
  float depth = 1e-5f;        // of the depth range, where both hit
  const char* reason = "the rule";
};

struct Scene {
  const char* name;
  /// Draws one frame into the bound framebuffer of a fresh compatibility context, `width` x `height` pixels,
  /// and leaves it selected for reading.
  void (*draw)(Gl gl, int width, int height);
  bool traced = true;  // at least one draw must be traced; otherwise the scene is for the real OpenGL alone
  Tolerance tolerance = {};
};

/// How test frameworks print one.
inline void PrintTo(const Scene* scene, std::ostream* out) { *out << scene->name; }

/// All scenes, in a fixed order.
std::span<const Scene> scenes();
/// Null where there is none of that name.
const Scene* findScene(std::string_view name);

/// One model under one light, sent in different ways: the images must be equal to the bit.
std::span<const Scene> variants();

}  // namespace gluray::scenes
