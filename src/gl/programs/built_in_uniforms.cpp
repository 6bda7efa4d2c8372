#include "gl/programs/built_in_uniforms.h"

#include "gl/glsl/built_in_variables.h"
#include "gl/real/state_queries.h"

#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace gluray::gl {
namespace {

using Of = BuiltInUniform::Of;

glm::mat4 matrixOf(const RealGl& real, GLenum name) {
  glm::mat4 m(1);
  real.GetFloatv(name, glm::value_ptr(m));
  return m;
}

glm::vec4 ofLight(const RealGl& real, GLuint light, GLenum what) {
  glm::vec4 v(0);
  real.GetLightfv(GL_LIGHT0 + light, what, glm::value_ptr(v));
  return v;
}

glm::vec4 ofMaterial(const RealGl& real, GLenum face, GLenum what) {
  glm::vec4 v(0);
  real.GetMaterialfv(face, what, glm::value_ptr(v));
  return v;
}

glm::mat4 textureMatrix(const RealGl& real) {
  const auto active = static_cast<GLenum>(integer(real, GL_ACTIVE_TEXTURE));
  real.ActiveTexture(GL_TEXTURE0);
  const glm::mat4 m = matrixOf(real, GL_TEXTURE_MATRIX);
  real.ActiveTexture(active);
  return m;
}

glm::vec4 ofFog(const RealGl& real, GLenum what) {
  glm::vec4 v(0);
  real.GetFloatv(what, glm::value_ptr(v));
  return v;
}

glm::vec4 modelAmbient(const RealGl& real) {
  glm::vec4 v(0);
  real.GetFloatv(GL_LIGHT_MODEL_AMBIENT, glm::value_ptr(v));
  return v;
}

/// Vectors, and numbers in x. GLSL 1.20, 7.5.
glm::vec4 builtInVector(const RealGl& real, const BuiltInUniform& u) {
  switch (u.of) {
    case Of::fog: return ofFog(real, u.what);
    case Of::fogScale: return glm::vec4(1 / (ofFog(real, GL_FOG_END).x - ofFog(real, GL_FOG_START).x));
    case Of::lightModel: return modelAmbient(real);
    case Of::light: return ofLight(real, u.light, u.what);
    case Of::material: return ofMaterial(real, u.face, u.what);
    case Of::product: {
      const glm::vec4 product = ofMaterial(real, u.face, u.what) * ofLight(real, u.light, u.what);
      return {glm::vec3(product), ofMaterial(real, u.face, u.what).a};
    }
    case Of::sceneColor: {
      const glm::vec4 sum =
          ofMaterial(real, u.face, GL_EMISSION) + ofMaterial(real, u.face, GL_AMBIENT) * modelAmbient(real);
      return {glm::vec3(sum), ofMaterial(real, u.face, GL_DIFFUSE).a};
    }
    default: return glm::vec4(0);
  }
}

}  // namespace

void dropBuiltIns(Program& program) {
  std::erase_if(program.uniforms, [](const auto& entry) { return isBuiltIn(entry.first); });
  numberElements(program);
}

void nameBuiltIns(Program& program, const Family& family) {
  dropBuiltIns(program);
  for (const std::string& name : family.mentioned) {
    if (!isBuiltIn(name)) continue;
    if (const GLenum type = builtInUniformType(name)) program.uniforms[name].type = type;
  }
  numberElements(program);
}

void readBuiltIn(const RealGl& real, std::string_view name, UniformValue& value) {
  const BuiltInUniform u = builtInUniform(name);
  const auto keep = [&](const auto& v, int count) {
    std::copy_n(glm::value_ptr(v), count, value.floats.begin());
  };
  switch (u.of) {
    case Of::none: return;
    case Of::modelview: return keep(matrixOf(real, GL_MODELVIEW_MATRIX), 16);
    case Of::textureMatrix: return keep(textureMatrix(real), 16);
    case Of::projection: return keep(matrixOf(real, GL_PROJECTION_MATRIX), 16);
    case Of::clip:
      return keep(matrixOf(real, GL_PROJECTION_MATRIX) * matrixOf(real, GL_MODELVIEW_MATRIX), 16);
    case Of::normals: {
      const glm::dmat3 linear(matrixOf(real, GL_MODELVIEW_MATRIX));
      return keep(glm::mat3(glm::transpose(glm::inverse(linear))), 9);
    }
    default: break;
  }
  const glm::vec4 v = builtInVector(real, u);
  u.alpha ? void(value.floats[0] = v.a) : keep(v, 4);
}

}  // namespace gluray::gl
