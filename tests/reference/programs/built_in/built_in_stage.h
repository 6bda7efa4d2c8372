// Programs in the idiom of GLSL 1.x, which take vertices, matrices and lights from fixed function, and the
// ways to send them vertices. For built_in_*_test.cpp.
#pragma once
#include "tests/reference/programs/program_stage.h"

#include <string>

namespace gluray::test {

/// A compatibility profile of the stage's size.
inline ContextWish compatibleWish() { return {kProgramWidth, kProgramHeight}; }

/// How vertices are sent.
enum class Way { clientArrays, clientElements, buffers, immediate, list };
std::string nameOf(Way way);

struct ShaderPair {
  std::string vertex, fragment;
};
/// As PyQtGraph 0.13 has them.
extern const ShaderPair kShaded, kViewNormalColor, kNormalColor, kEdgeHilight, kHeightColor, kBalloon;
/// As OpenCTM's viewer has it.
extern const ShaderPair kOpenCtm;

/// Clears and sets matrices, lights 0 and 1, materials and the light model.
void beginBuiltInFrame(Gl gl, double degrees = 35);
/// Sends the mesh with normals, with texture coordinates if it has them and, if `colors`, colours.
void sendMesh(Gl gl, const ProgramMesh& mesh, Way way, bool colors = true);

/// What the real OpenGL draws is drawn by tracing and while tracing fails; `draws` of them are traced.
inline void expectBuiltIns(const std::string& name, const DrawProgram& draw, int draws,
                           const std::string& families = "") {
  expectBoth(name, draw, draws, compatibleWish(), kProgramTolerance, families);
}

}  // namespace gluray::test
