// Textures and environments of physically based materials, for the program_*_test.cpp.
#pragma once
#include "tests/reference/programs/program_stage.h"

namespace gluray::test {

/// How the material's textures are filtered.
struct PbrFilter {
  GLint smallest = GL_LINEAR;  // or a filter between levels
  float anisotropy = 1;
  GLint normals = GL_RGBA8;  // format of the normal map
};

/// Makes the images that `surface` samples, binds them to units from 5 on, and sets the uniforms of the
/// program in use.
void setPbrInputs(Gl gl, GLuint program, const Surface& surface, const PbrFilter& filter = {});

}  // namespace gluray::test
