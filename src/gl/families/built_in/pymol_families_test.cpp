// The families of PyMOL's surfaces: PyMOL's programs fit; programs with effects that no family describes do
// not.
#include "gl/testing/test_match.h"
#include "gl/testing/test_pymol_text.h"

#include <gtest/gtest.h>

#include <string>

namespace gluray::gl {
namespace {

class PyMolFamilies : public Match {
 protected:
  /// The name of the first family that a program with this source fits; empty: none.
  std::string familyOf(const std::string& vertex, const std::string& fragment) const {
    g_shaders = {{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}};
    const Program program =
        programOf({{"g_ModelViewMatrix", GL_FLOAT_MAT4},
                   {"g_ProjectionMatrix", GL_FLOAT_MAT4},
                   {"g_NormalMatrix", GL_FLOAT_MAT3},
                   {"g_LightModel.ambient", GL_FLOAT_VEC4},
                   {"g_LightSource[0].position", GL_FLOAT_VEC4},
                   {"g_LightSource[0].diffuse", GL_FLOAT_VEC4},
                   {"g_LightSource[0].specular", GL_FLOAT_VEC4},
                   {"bgSolidColor", GL_FLOAT_VEC3},
                   {"isPicking", GL_BOOL},
                   {"lighting_enabled", GL_BOOL}},
                  {{"a_Vertex", GL_FLOAT_VEC4}, {"a_Normal", GL_FLOAT_VEC3}, {"a_Color", GL_FLOAT_VEC4}});
    const FamilyList& all = builtInFamilies();
    for (const auto& family : all)
      if (family->name.starts_with("PyMOL") && obstacles(real_, program, *family, all.code).empty())
        return family->name;
    return "";
  }
};

class InstalledPyMol : public PyMolFamilies {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kPyMolShaders)) GTEST_SKIP() << "PyMOL is not installed";
  }
  std::string familyOf(const std::string& file, const Defines& defines, int lights = 2,
                       int highlights = 8) const {
    return PyMolFamilies::familyOf(PyMolText(file + ".vs", defines, lights, highlights).text,
                                   PyMolText(file + ".fs", defines, lights, highlights).text);
  }
};

TEST_F(InstalledPyMol, SurfacesFit) {
  EXPECT_EQ(familyOf("surface", {"depth_cue", "bg_image_mode_solid"}), "PyMOL surface with depth cue");
  EXPECT_EQ(familyOf("surface", {"bg_image_mode_solid"}), "PyMOL surface");
  EXPECT_EQ(familyOf("default", {"depth_cue", "bg_image_mode_solid", "ortho"}),
            "PyMOL default with depth cue");
  EXPECT_EQ(familyOf("default", {"bg_image_mode_solid"}), "PyMOL default");
  for (int lights = 1; lights <= 8; ++lights)
    for (int highlights = 0; highlights <= lights; ++highlights)
      EXPECT_EQ(familyOf("surface", {"bg_image_mode_solid"}, lights, highlights), "PyMOL surface")
          << lights << ", " << highlights;
}

TEST_F(InstalledPyMol, OtherEffectsDoNotFit) {
  for (const char* file : {"surface", "default"}) {
    for (const char* effect :
         {"chromadepth", "ray_trace_mode_3", "transparency_mode_3", "precomputed_lighting", "ANAGLYPH",
          "ray_transparency_oblique", "PURE_OPENGL_ES_2"})
      EXPECT_EQ(familyOf(file, {"depth_cue", "bg_image_mode_solid", effect}), "") << file << " " << effect;
    EXPECT_EQ(familyOf(file, {"depth_cue"}), "") << "an image behind it";
    EXPECT_EQ(familyOf(file, {"depth_cue", "bg_image_mode_1_or_3", "bg_image_mode_2_or_3"}), "");
    EXPECT_EQ(familyOf(file, {"bg_image_mode_solid", "transparency_mode_3", "NO_ORDER_TRANSP"}), "");
    EXPECT_EQ(familyOf(file, {"bg_image_mode_solid", "chromadepth", "chromadepth_postlighting", "ortho"}),
              "");
  }
  for (const char* file : {"line", "label", "indicator", "bg"})
    EXPECT_EQ(familyOf(file, {"bg_image_mode_solid"}), "") << file;
}

/// Made of the families' own statements, with one light. The part of the text from `from` becomes `to`.
class PyMolStatements : public PyMolFamilies {
 protected:
  std::string familyWith(const std::string& from = "", const std::string& to = "") const {
    const std::string mains = textOf("PyMOL surface", "blocks"),
                      lights = textOf("PyMOL lights", "statements");
    const size_t between = mains.find("\n\n"),
                 second = lights.find("vec4 ApplyLighting", lights.find("vec4 ApplyLighting") + 1);
    std::string vertex = "void main() {\n" + mains.substr(0, between) + "\n}\n";
    std::string fragment = textOf("PyMOL surface", "statements") + textOf("PyMOL effects", "statements") +
                           textOf("PyMOL depth cue", "blocks") + lights.substr(0, second) +
                           "void main() {\n" + mains.substr(between) + "}\n";
    bool found = from.empty();
    for (std::string* text : {&vertex, &fragment})
      if (const size_t at = text->find(from); !from.empty() && at != std::string::npos)
        text->replace(at, from.size(), to), found = true;
    EXPECT_TRUE(found) << from;
    return familyOf(vertex, fragment);
  }
};

TEST_F(PyMolStatements, MustBeAllThere) {
  EXPECT_EQ(familyWith(), "PyMOL surface with depth cue");
  const std::pair<const char*, const char*> changes[] = {
      {"fog = (g_Fog_end + eye_pos.z) * g_Fog_scale;", ""},
      {"(g_Fog_end + eye_pos.z)", "(g_Fog_end - eye_pos.z)"},
      {"gl_FragColor = ApplyFog(color, fog);", "gl_FragColor = color;"},
      {"gl_FragColor = ApplyFog(color, fog);", "gl_FragColor = ApplyFog(ApplyFog(color, fog), fog);"},
      {"fog >= 1.", "fog >= 2."},
      {"min(lighting.x, 1.0)", "lighting.x"},
      {"vec3(0., 0., 1.)", "vec3(0., 1., 0.)"},
      {"shininess_0);", "shininess);"},
      {"normal = vec3(0.);", "normal = -normal;"},
      {"if (isPicking) return;", "if (isPicking) discard;"},
      {"NORMAL = normalize(g_NormalMatrix * a_Normal);", ""},
      {"gl_Position = g_ProjectionMatrix", "gl_Position = 0.5 * g_ProjectionMatrix"}};
  for (const auto& [from, to] : changes) EXPECT_EQ(familyWith(from, to), "") << from;
  EXPECT_EQ(familyWith("  PostLightingEffects();\n}\n", "  PostLightingEffects();\n}\ngl_FragColor *= 2.;\n"),
            "");
}

}  // namespace
}  // namespace gluray::gl
