// VTK's own lighting passes are recognised, so that GLuRay can tell users to choose between them and its own.
#include "gl/testing/test_match.h"

#include <gtest/gtest.h>

#include <string>

namespace gluray::gl {
namespace {

class LightPasses : public Match {
 protected:
  /// Name of the first family that fits, and why it is not traced.
  std::pair<std::string, std::string> familyOf(const Program& program) const {
    const FamilyList& all = builtInFamilies();
    for (const auto& family : all)
      if (obstacles(real_, program, *family, all.code).empty())
        return {family->name, family->rasteriseBecause};
    return {};
  }
  static Program surface(std::map<std::string, GLenum> uniforms) {
    uniforms["MCDCMatrix"] = GL_FLOAT_MAT4;
    return programOf(std::move(uniforms), {{"vertexMC", GL_FLOAT_VEC4}});
  }
};

TEST_F(LightPasses, OfScreenSpaceAmbientOcclusion) {
  const auto [name, why] = familyOf(programOf({{"kernelRadius", GL_FLOAT},
                                               {"kernelBias", GL_FLOAT},
                                               {"texNoise", GL_SAMPLER_2D},
                                               {"texPosition", GL_SAMPLER_2D},
                                               {"texNormal", GL_SAMPLER_2D}},
                                              {{"ndCoordIn", GL_FLOAT_VEC2}, {"texCoordIn", GL_FLOAT_VEC2}}));
  EXPECT_EQ(name, "VTK screen-space ambient occlusion");
  EXPECT_NE(why.find("switch it off"), why.npos);
  EXPECT_NE(why.find("ao=on"), why.npos);
}

TEST_F(LightPasses, AndTheSurfacesBeneath) {
  attachBoth() = "void main() {\n  fragOutput1 = vec4(vertexVC.xyz, 1.0);\n}";
  EXPECT_EQ(familyOf(surface({})).first, "VTK screen-space ambient occlusion: surfaces");
  attachBoth() = "void main() {\n  fragOutput0 = vec4(vertexVC.xyz, 1.0);\n}";
  EXPECT_NE(familyOf(surface({})).first, "VTK screen-space ambient occlusion: surfaces");
}

TEST_F(LightPasses, OfShadowMaps) {
  EXPECT_EQ(familyOf(surface({{"depthC", GL_FLOAT}, {"nearZ", GL_FLOAT}, {"farZ", GL_FLOAT}})).first,
            "VTK shadow maps");
  const auto [name, why] = familyOf(surface({{"depthC", GL_FLOAT}, {"shadowMap0", GL_SAMPLER_2D}}));
  EXPECT_EQ(name, "VTK shadow maps: surfaces");
  EXPECT_NE(why.find("switch them off"), why.npos);
}

TEST_F(LightPasses, OfDepthOfField) {
  EXPECT_EQ(familyOf(programOf({{"focalDisk", GL_FLOAT},
                                {"focalDistance", GL_FLOAT},
                                {"worldToTCoord", GL_FLOAT_VEC2},
                                {"nearC", GL_FLOAT},
                                {"farC", GL_FLOAT}},
                               {{"vertexMC", GL_FLOAT_VEC4}}))
                .first,
            "VTK depth of field");
}

}  // namespace
}  // namespace gluray::gl
