// Shared by the tests' own programs that draw impostors: sixty impostors, their arrays, light and
// view. For program_impostors_test.cpp and program_pixel_impostors_test.cpp.
#pragma once
#include "tests/reference/programs/program_stage.h"

#include <string>
#include <vector>

namespace gluray::test {

inline constexpr int kImpostors = 60;

/// The part of their family files about transforms and lights.
inline const std::string kOwnFamily =
    "[[family]]\nname = \"own\"\nmatch.active = [\"place\", \"modelview\", \"projection\"]\n"
    "vertex.position = \"place\"\nvertex.color = \"paint\"\n"
    "transform.clip_from_object = [\"projection\", \"modelview\"]\ntransform.eye_from_object = "
    "\"modelview\"\n"
    "normals.parallel_view = \"ortho\"\nmaterial.ambient_intensity = 0.2\nmaterial.ambient_color = 1\n"
    "material.diffuse_intensity = 0.8\nlights.direction = \"sun\"\n";

/// Compiles and links; the test fails if a shader's log is not empty. `geometry` may be empty.
GLuint linkImpostors(Gl gl, const std::string& vertex, const std::string& geometry,
                     const std::string& fragment);

/// Makes a vertex array object current that has attributes "place" and "paint".
void placeImpostors(Gl gl, GLuint program);
/// Adds an array of `size` floats each for another attribute; does nothing if that is not active.
void addImpostorValues(Gl gl, GLuint program, const char* name, GLint size, const std::vector<float>& values);

/// View and light of the program in use.
void lookAtImpostors(Gl gl, GLuint program, const View& view, bool parallel);

void drawNumbered(Gl gl, GLenum mode, const std::vector<GLushort>& numbers);

}  // namespace gluray::test
