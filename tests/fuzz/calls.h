// The vocabulary of the fuzzer: every call that a stream may hold, by family. A call draws its arguments from
// the player, one after the other.
#pragma once
#include "tests/fuzz/player.h"

#include <span>

namespace gluray::fuzz {

struct Op {
  const char* name;  // what is printed: the GL name where it is one call
  uint32_t weight;   // how often it is chosen within its family
  void (*run)(Player& p);
};
using Ops = std::span<const Op>;

Ops vertexAttributeCalls();                          // glVertex*, glColor* ...: generated, all of them
Ops attributeCalls();                                // those that make no vertex
Ops vertexCalls();                                   // what else may stand between glBegin and glEnd
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
Ops calmCalls();     // back to state in which surfaces are traced
Ops queryCalls();    // occlusion queries, selection, feedback
Ops askCalls();      // questions whose answers are compared
Ops frameCalls();    // clears, finishes, other contexts

}  // namespace gluray::fuzz
