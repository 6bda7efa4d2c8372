// Fake programs that consist only of names and sources, for tests of match.h.
#pragma once
#include "gl/programs/match.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace gluray::gl {

using Lines = std::vector<std::string>;
inline std::map<std::string, GLint> g_outputs;

struct FakeShader {
  GLenum type;
  std::string text;
  bool hasText = true;
};
inline std::vector<FakeShader> g_shaders;  // the attached ones

/// An OpenGL that only answers queries about fragment shader outputs and shader sources.
inline RealGl fakeGl() {
  RealGl real{};
  loadRealGl(
      real, [](void*, const char*) -> void* { return nullptr; }, nullptr);
  real.GetFragDataLocation = [](GLuint, const GLchar* name) {
    const auto it = g_outputs.find(name);
    return it == g_outputs.end() ? -1 : it->second;
  };
  real.GetAttachedShaders = [](GLuint, GLsizei most, GLsizei* count, GLuint* names) {
    *count = std::min(most, static_cast<GLsizei>(g_shaders.size()));
    for (GLsizei i = 0; i < *count; ++i) names[i] = static_cast<GLuint>(i);
  };
  real.GetProgramiv = [](GLuint, GLenum what, GLint* count) {
    *count = what == GL_ATTACHED_SHADERS ? static_cast<GLint>(g_shaders.size()) : 0;
  };
  real.GetShaderiv = [](GLuint name, GLenum what, GLint* value) {
    const FakeShader& shader = g_shaders.at(name);
    const size_t length = shader.hasText ? shader.text.size() + 1 : 0;
    *value = what == GL_SHADER_TYPE ? static_cast<GLint>(shader.type) : static_cast<GLint>(length);
  };
  real.GetShaderSource = [](GLuint shader, GLsizei size, GLsizei* length, GLchar* text) {
    *length = std::min(size - 1, static_cast<GLsizei>(g_shaders.at(shader).text.size()));
    g_shaders.at(shader).text.copy(text, static_cast<size_t>(*length));
    text[*length] = 0;
  };
  return real;
}

inline Program programOf(std::map<std::string, GLenum> uniforms, std::map<std::string, GLenum> attributes) {
  Program p;
  p.linked = true;
  for (const auto& [name, type] : uniforms) p.uniforms[name].type = type;
  for (const auto& [name, type] : attributes) p.attributes[name].type = type;
  return p;
}

inline const char* const kFamily = R"([[family]]
name = "f"
match.active = ["p", "m"]
match.absent = ["bad"]
match.absent_outputs = ["second"]
match.ignored = ["time"]
vertex.position = "p"
vertex.normal = "n"
vertex.color = "c"
transform.clip_from_object = "m"
transform.eye_from_object = "v"
transform.normal_matrix = "nm"
color.map = "map"
color.per_triangle = "cells"
material.diffuse_color = "dc"
material.shininess = 7
lights.color = "light{}"
lights.position = "place[{}]"
lights.count = "lights"
)";

class Match : public testing::Test {
 protected:
  Match() { g_outputs = {{"color", 0}}, g_shaders.clear(); }
  Lines obstaclesOf(const Program& program) const { return obstacles(real_, program, *family_); }
  Program fitting() const {
    return programOf({{"m", GL_FLOAT_MAT4}, {"dc", GL_FLOAT_VEC3}, {"light0", GL_FLOAT_VEC3}},
                     {{"p", GL_FLOAT_VEC3}, {"n", GL_FLOAT_VEC3}});
  }
  /// Attaches a vertex and a fragment shader whose statements are known; returns the fragment shader's text.
  static std::string& attachBoth() {
    g_shaders = {
        {GL_VERTEX_SHADER, "#version 150\nin vec4 p; uniform mat4 m;\nvoid main() { gl_Position = m*p; }"},
        {GL_FRAGMENT_SHADER, "void main() { color = vec4(light3, 1.); }"}};
    return g_shaders[1].text;
  }
  RealGl real_ = fakeGl();
  std::shared_ptr<const Family> family_ = parseFamilies(kFamily, "f.toml").front();
};

}  // namespace gluray::gl
