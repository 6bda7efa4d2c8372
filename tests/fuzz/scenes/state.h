// State of random scenes: cameras, lights, surfaces, fragments.
#pragma once
#include "tests/fuzz/scenes/script.h"

namespace gluray::fuzz {

void writeCamera(Writer& w, int size);
void writeTexture(Writer& w, uint32_t name);
void writeLights(Writer& w);
/// Equations of three clip planes, set once in a scene: avoided.md.
void writeClipPlanes(Writer& w);
/// Polygon state, textures, clip planes, normals.
void writeSurface(Writer& w);
/// A query of the current colour, whose answer is not compared: Mesa stores the colour.
void askColor(Writer& w);
/// Whether a query comes first: avoided.md. There is none in lists.
enum class Asks : uint8_t { nothing, color };
/// glColorMaterial and GL_COLOR_MATERIAL.
void writeColorMaterial(Writer& w, Asks asks = Asks::color);
/// Per-fragment operations.
void writeFragments(Writer& w);
/// glEnable or glDisable. Returns whether it enables.
bool writeToggle(Writer& w, uint32_t capability, uint32_t percent);

}  // namespace gluray::fuzz
