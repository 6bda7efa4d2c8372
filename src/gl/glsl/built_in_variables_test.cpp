#include "gl/glsl/built_in_variables.h"

#include <GL/glext.h>
#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

using Of = BuiltInUniform::Of;

TEST(BuiltInVariables, Attributes) {
  for (const char* name : {"gl_Vertex", "gl_Normal", "gl_Color", "gl_MultiTexCoord0", "gl_MultiTexCoord7"})
    EXPECT_TRUE(isBuiltInAttribute(name)) << name;
  for (const char* name :
       {"gl_Vertices", "gl_MultiTexCoord", "gl_MultiTexCoord8", "gl_NormalMatrix", "Vertex"})
    EXPECT_FALSE(isBuiltInAttribute(name)) << name;
}

TEST(BuiltInVariables, Uniforms) {
  EXPECT_EQ(builtInUniform("gl_NormalMatrix").of, Of::normals);
  const BuiltInUniform light = builtInUniform("gl_LightSource[3].position");
  EXPECT_EQ(light.of, Of::light);
  EXPECT_EQ(light.light, 3u);
  EXPECT_EQ(light.what, static_cast<GLenum>(GL_POSITION));
  const BuiltInUniform product = builtInUniform("gl_BackLightProduct[1].specular.a");
  EXPECT_EQ(product.of, Of::product);
  EXPECT_EQ(product.face, static_cast<GLenum>(GL_BACK));
  EXPECT_EQ(product.light, 1u);
  EXPECT_EQ(product.what, static_cast<GLenum>(GL_SPECULAR));
  EXPECT_TRUE(product.alpha);
  EXPECT_EQ(builtInUniform("gl_FrontLightModelProduct.sceneColor").of, Of::sceneColor);
}

TEST(BuiltInVariables, UnknownOnes) {
  for (const char* name :
       {"gl_Fog.colour", "gl_Fog", "gl_Fog.density.a", "gl_TextureMatrix[1]", "gl_LightSource[8].position",
        "gl_LightSource[0].halfVector", "gl_LightSource[0]", "gl_FrontMaterial.shininess.a",
        "gl_ModelViewMatrix.a", "gl_LightModel.ambient.a.a", "gl_FrontMaterial.",
        "gl_FrontLightProduct[].ambient", "", ".a", "modelview"})
    EXPECT_EQ(builtInUniform(name).of, Of::none) << name;
}

TEST(BuiltInVariables, Types) {
  EXPECT_EQ(builtInUniformType("gl_ModelViewProjectionMatrix"), static_cast<GLenum>(GL_FLOAT_MAT4));
  EXPECT_EQ(builtInUniformType("gl_NormalMatrix"), static_cast<GLenum>(GL_FLOAT_MAT3));
  EXPECT_EQ(builtInUniformType("gl_FrontMaterial.emission"), static_cast<GLenum>(GL_FLOAT_VEC4));
  EXPECT_EQ(builtInUniformType("gl_FrontMaterial.shininess"), static_cast<GLenum>(GL_FLOAT));
  EXPECT_EQ(builtInUniformType("gl_LightModel.ambient.a"), static_cast<GLenum>(GL_FLOAT));
  EXPECT_EQ(builtInUniformType("gl_TextureMatrix[0]"), static_cast<GLenum>(GL_FLOAT_MAT4));
  EXPECT_EQ(builtInUniformType("gl_Fog.color"), static_cast<GLenum>(GL_FLOAT_VEC4));
  EXPECT_EQ(builtInUniformType("gl_Fog.color.a"), static_cast<GLenum>(GL_FLOAT));
  EXPECT_EQ(builtInUniformType("gl_Fog.scale"), static_cast<GLenum>(GL_FLOAT));
  EXPECT_EQ(builtInUniformType("gl_Fog.end"), static_cast<GLenum>(GL_FLOAT));
  EXPECT_EQ(builtInUniformType("gl_Vertex"), 0u);
}

}  // namespace
}  // namespace gluray::gl
