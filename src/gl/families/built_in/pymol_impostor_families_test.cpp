// The families of PyMOL's spheres and sticks: PyMOL's programs fit; programs with effects that no family
// describes do not.
#include "gl/testing/test_match.h"
#include "gl/testing/test_pymol_text.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace gluray::gl {
namespace {

Program impostorProgram(bool sticks) {
  std::map<std::string, GLenum> uniforms = {{"g_ModelViewMatrix", GL_FLOAT_MAT4},
                                            {"g_ProjectionMatrix", GL_FLOAT_MAT4},
                                            {"g_NormalMatrix", GL_FLOAT_MAT3},
                                            {"g_LightModel.ambient", GL_FLOAT_VEC4},
                                            {"g_LightSource[0].position", GL_FLOAT_VEC4},
                                            {"g_LightSource[0].diffuse", GL_FLOAT_VEC4},
                                            {"bgSolidColor", GL_FLOAT_VEC3},
                                            {"isPicking", GL_BOOL},
                                            {"lighting_enabled", GL_BOOL}};
  if (!sticks) {
    uniforms["sphere_size_scale"] = GL_FLOAT;
    return programOf(
        uniforms,
        {{"a_vertex_radius", GL_FLOAT_VEC4}, {"a_Color", GL_FLOAT_VEC4}, {"a_rightUpFlags", GL_FLOAT}});
  }
  uniforms["uni_radius"] = uniforms["half_bond"] = uniforms["inv_height"] = GL_FLOAT;
  uniforms["no_flat_caps"] = GL_BOOL;
  return programOf(uniforms, {{"attr_vertex1", GL_FLOAT_VEC3},
                              {"attr_vertex2", GL_FLOAT_VEC3},
                              {"a_Color", GL_FLOAT_VEC4},
                              {"a_Color2", GL_FLOAT_VEC4},
                              {"attr_radius", GL_FLOAT},
                              {"a_cap", GL_FLOAT},
                              {"attr_flags", GL_FLOAT}});
}

class PyMolImpostorFamilies : public Match {
 protected:
  /// The name of the first family that a program with this source fits; empty: none.
  std::string familyOf(bool sticks, const std::string& vertex, const std::string& fragment) const {
    g_shaders = {{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}};
    const Program program = impostorProgram(sticks);
    const FamilyList& all = builtInFamilies();
    for (const auto& family : all)
      if (family->name.starts_with("PyMOL") && obstacles(real_, program, *family, all.code).empty())
        return family->name;
    return "";
  }
};

class InstalledPyMolImpostors : public PyMolImpostorFamilies {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kPyMolShaders)) GTEST_SKIP() << "PyMOL is not installed";
  }
  std::string familyOf(bool sticks, const Defines& defines, int lights = 2, int highlights = 8) const {
    const std::string file = sticks ? "cylinder" : "sphere";
    return PyMolImpostorFamilies::familyOf(sticks, PyMolText(file + ".vs", defines, lights, highlights).text,
                                           PyMolText(file + ".fs", defines, lights, highlights).text);
  }
};

TEST_F(InstalledPyMolImpostors, Fit) {
  for (const bool sticks : {false, true}) {
    const std::string name = sticks ? "PyMOL sticks" : "PyMOL spheres";
    EXPECT_EQ(familyOf(sticks, {"bg_image_mode_solid"}), name);
    EXPECT_EQ(familyOf(sticks, {"bg_image_mode_solid", "depth_cue"}), name + " with depth cue");
    EXPECT_EQ(familyOf(sticks, {"bg_image_mode_solid", "ortho"}), name + ", parallel");
    EXPECT_EQ(familyOf(sticks, {"bg_image_mode_solid", "ortho", "depth_cue"}),
              name + ", parallel, with depth cue");
    for (int lights = 1; lights <= 8; ++lights)
      EXPECT_EQ(familyOf(sticks, {"bg_image_mode_solid"}, lights, lights / 2), name) << lights;
  }
}

TEST_F(InstalledPyMolImpostors, WithOtherEffectsDoNotFit) {
  for (const bool sticks : {false, true}) {
    for (const char* effect : {"chromadepth", "ray_trace_mode_3", "transparency_mode_3",
                               "precomputed_lighting", "ANAGLYPH", "ray_transparency_oblique"})
      EXPECT_EQ(familyOf(sticks, {"depth_cue", "bg_image_mode_solid", effect}), "") << effect;
    EXPECT_EQ(familyOf(sticks, {"bg_image_mode_solid", "transparency_mode_3", "NO_ORDER_TRANSP"}), "");
    EXPECT_EQ(familyOf(sticks, {"bg_image_mode_solid", "chromadepth", "chromadepth_postlighting"}), "");
    EXPECT_EQ(familyOf(sticks, {"depth_cue"}), "") << "an image behind it";
  }
}

/// Made of the families' own statements, with one light. The part of the text from `from` becomes `to`.
class PyMolImpostorStatements : public PyMolImpostorFamilies {
 protected:
  std::string familyWith(bool sticks, const std::string& from = "", const std::string& to = "") const {
    const std::string name = sticks ? "PyMOL sticks" : "PyMOL spheres", common = textOf(name, "blocks"),
                      perspective = textOf(name + ", perspective", "blocks"),
                      own = textOf(name, "statements"), lights = textOf("PyMOL lights", "statements");
    const std::string& both = sticks ? common : perspective;  // the text with both shaders' statements
    const size_t between = both.find("\n\n"), half = sticks ? own.find("bool get_bit_and_shift") : own.size(),
                 second = lights.find("vec4 ApplyLighting", lights.find("vec4 ApplyLighting") + 1);
    std::string vertex = own.substr(0, half) + "void main() {\n" + both.substr(0, between) + "\n}\n";
    const std::string main =
        sticks ? perspective + common.substr(between) : perspective.substr(between) + common;
    std::string fragment = own.substr(half) + textOf("PyMOL effects", "statements") +
                           textOf("PyMOL no depth cue", "blocks") + lights.substr(0, second) +
                           "void main() {\n" + main + "}\n";
    bool found = from.empty();
    for (std::string* text : {&vertex, &fragment})
      if (const size_t at = text->find(from); !from.empty() && at != std::string::npos)
        text->replace(at, from.size(), to), found = true;
    EXPECT_TRUE(found) << from;
    return familyOf(sticks, vertex, fragment);
  }
};

TEST_F(PyMolImpostorStatements, MustBeAllThere) {
  EXPECT_EQ(familyWith(false), "PyMOL spheres");
  EXPECT_EQ(familyWith(true), "PyMOL sticks");
  const std::pair<const char*, const char*> ofSpheres[] = {
      {"return min(adjustment, 10.);", "return min(adjustment, 5.);"},
      {"radius /= length(g_NormalMatrix[0]);", ""},
      {"corner_offset *= outer_tangent_adjustment(tmppos.xyz, radius2);", ""},
      {"b - sqrt(position)", "b + sqrt(position)"},
      {"depth <= 0.0 || depth >= 1.0", "depth <= 0.0"},
      {"gl_FragDepth = depth;", ""}};
  for (const auto& [from, to] : ofSpheres) EXPECT_EQ(familyWith(false, from, to), "") << from;
  const std::pair<const char*, const char*> ofSticks[] = {
      {"return step(.5, bit);", "return bit;"},
      {"gl_Position.z = -gl_Position.w;", ""},
      {"sqrt(pos) + b", "b - sqrt(pos)"},
      {"if (!frontcap)\n", "if (frontcap)\n"},
      {"color = mix(color1, color2, ratio);", "color = color1;"},
      {"vec3 ray_origin = vec3(0.);", "vec3 ray_origin = surface_point;"}};
  for (const auto& [from, to] : ofSticks) EXPECT_EQ(familyWith(true, from, to), "") << from;
}

}  // namespace
}  // namespace gluray::gl
