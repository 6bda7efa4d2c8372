// Pieces of the programs of pulled_text.h for wide lines, tubes and spheres. Private to its sources.
#pragma once

namespace gluray::test {

/// Of the vertex shader; FETCH stands for the fetch of a position.
extern const char* const kPulledWideLines;
/// Of the fragment shader: depth, and the normal, with and without normals of vertices.
extern const char* const kPulledDepthWithNormals;
extern const char* const kPulledDepthWithoutNormals;
extern const char* const kPulledNormalOfVertices;
extern const char* const kPulledNormalOfPrimitives;
/// The look of painted edges of surfaces whose lines are tubes; and why tubes have lights in any case.
extern const char* const kPulledRoundEdges;
extern const char* const kPulledTubesAreLit;

}  // namespace gluray::test
