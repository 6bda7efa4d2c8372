// The fuzzer's calls, grouped by kind: everything that a stream may hold. A call draws its arguments from
// the player, one after the other.
#pragma once
#include "tests/fuzz/player.h"

#include <span>

namespace gluray::fuzz {

struct Op {
  const char* name;  // to print: the GL name if it is a single call
  uint32_t weight;   // relative frequency within its kind
  void (*run)(Player& p);
};
using Ops = std::span<const Op>;

Ops vertexAttributeCalls();                          // glVertex*, glColor* ...: generated, all of them
Ops attributeCalls();                                // those that send no vertex
Ops vertexCalls();                                   // other calls that may stand between glBegin and glEnd
Ops beginCalls();                                    // glBegin
Ops endCalls();                                      // glEnd
Ops stateCalls();                                    // switches, depth, blending, polygons, fog, viewport
Ops lightCalls();                                    // lights, materials, clip planes
Ops matrixCalls();                                   // matrices and their stacks
Ops stackCalls();                                    // attribute stacks
Ops listCalls();                                     // names of lists, calls of lists
Ops newListCalls();                                  // glNewList
Ops newAttributeListCalls(), callAttributesCalls();  // lists that may be called between glBegin and glEnd
Ops endListCalls();                                  // glEndList
Ops bufferCalls();                                   // buffer objects
Ops arrayCalls();                                    // vertex arrays
Ops drawCalls();                                     // draws from arrays, rectangles, meshes of evaluators
Ops textureCalls();                                  // textures, their environment and coordinates
Ops pixelCalls();                                    // raster position, pixels, evaluator maps
Ops targetCalls();                                   // framebuffers, draw and read buffer
Ops programCalls();  // programs, their uniforms and arrays, vertex array objects
Ops calmCalls();     // reset state so that surfaces are traced
Ops queryCalls();    // occlusion queries, selection, feedback
Ops askCalls();      // queries whose results are compared
Ops frameCalls();    // clears, finishes, other contexts

}  // namespace gluray::fuzz
