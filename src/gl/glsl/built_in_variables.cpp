#include "gl/glsl/built_in_variables.h"

#include <GL/glext.h>

#include <algorithm>
#include <utility>

namespace gluray::gl {
namespace {

using Of = BuiltInUniform::Of;

struct ColorField {
  std::string_view name;
  GLenum what;
};
constexpr ColorField kColorFields[] = {
    {"ambient", GL_AMBIENT}, {"diffuse", GL_DIFFUSE}, {"specular", GL_SPECULAR}};

/// Removes `prefix` from the beginning of `name`, if it is there.
bool takePrefix(std::string_view& name, std::string_view prefix) {
  if (name.substr(0, prefix.size()) != prefix) return false;
  name.remove_prefix(prefix.size());
  return true;
}

GLenum colorNamed(std::string_view name) {
  const auto* const found = std::find_if(std::begin(kColorFields), std::end(kColorFields),
                                         [&](const ColorField& f) { return f.name == name; });
  return found == std::end(kColorFields) ? 0 : found->what;
}

/// Removes a number such as the one in "3]." and returns it in `number`. False if there is none.
bool takeNumber(std::string_view& name, GLuint& number) {
  if (name.size() < 3 || name[0] < '0' || name[0] > '7' || name.substr(1, 2) != "].") return false;
  number = static_cast<GLuint>(name[0] - '0');
  name.remove_prefix(3);
  return true;
}

/// Removes the prefix "gl_Front" or "gl_Back" and returns the face that it names.
bool takeFace(std::string_view& name, GLenum& face) {
  if (takePrefix(name, "gl_Front")) return face = GL_FRONT, true;
  if (takePrefix(name, "gl_Back")) return face = GL_BACK, true;
  return false;
}

BuiltInUniform ofFace(std::string_view name, BuiltInUniform u) {
  if (name == "LightModelProduct.sceneColor") {
    u.of = Of::sceneColor;
  } else if (takePrefix(name, "LightProduct[")) {
    if (takeNumber(name, u.light)) u.what = colorNamed(name);
    if (u.what) u.of = Of::product;
  } else if (takePrefix(name, "Material.")) {
    u.what = name == "emission" ? GL_EMISSION : name == "shininess" ? GL_SHININESS : colorNamed(name);
    if (u.what) u.of = Of::material;
  }
  return u;
}

constexpr std::pair<std::string_view, Of> kPlainUniforms[] = {
    {"gl_ModelViewMatrix", Of::modelview},      {"gl_ProjectionMatrix", Of::projection},
    {"gl_ModelViewProjectionMatrix", Of::clip}, {"gl_NormalMatrix", Of::normals},
    {"gl_TextureMatrix[0]", Of::textureMatrix}, {"gl_Fog.scale", Of::fogScale},
    {"gl_LightModel.ambient", Of::lightModel}};

constexpr std::pair<std::string_view, GLenum> kFogFields[] = {{"gl_Fog.color", GL_FOG_COLOR},
                                                              {"gl_Fog.density", GL_FOG_DENSITY},
                                                              {"gl_Fog.start", GL_FOG_START},
                                                              {"gl_Fog.end", GL_FOG_END}};

bool isVectorUniform(const BuiltInUniform& u) {
  if (u.of == Of::fog) return u.what == GL_FOG_COLOR;
  return u.of >= Of::lightModel && !(u.of == Of::material && u.what == GL_SHININESS);
}

}  // namespace

bool isBuiltInAttribute(std::string_view name) {
  constexpr std::string_view kAttributeNames[] = {"gl_Vertex", "gl_Normal", "gl_Color", "gl_SecondaryColor",
                                                  "gl_FogCoord"};
  if (std::find(std::begin(kAttributeNames), std::end(kAttributeNames), name) != std::end(kAttributeNames))
    return true;
  return takePrefix(name, "gl_MultiTexCoord") && name.size() == 1 && name[0] >= '0' && name[0] <= '7';
}

BuiltInUniform builtInUniform(std::string_view name) {
  if (name.size() > 2 && name.substr(name.size() - 2) == ".a") {
    BuiltInUniform u = builtInUniform(name.substr(0, name.size() - 2));
    if (!isVectorUniform(u) || u.alpha) return {};
    u.alpha = true;
    return u;
  }
  BuiltInUniform u;
  for (const auto& [plain, of] : kPlainUniforms)
    if (name == plain) return u.of = of, u;
  for (const auto& [field, what] : kFogFields)
    if (name == field) return u.of = Of::fog, u.what = what, u;
  if (takePrefix(name, "gl_LightSource[")) {
    if (takeNumber(name, u.light)) u.what = name == "position" ? GL_POSITION : colorNamed(name);
    if (u.what) u.of = Of::light;
    return u;
  }
  return takeFace(name, u.face) ? ofFace(name, u) : u;
}

GLenum builtInUniformType(std::string_view name) {
  const BuiltInUniform u = builtInUniform(name);
  switch (u.of) {
    case Of::none: return 0;
    case Of::modelview:
    case Of::projection:
    case Of::textureMatrix:
    case Of::clip: return GL_FLOAT_MAT4;
    case Of::normals: return GL_FLOAT_MAT3;
    default: return u.alpha || !isVectorUniform(u) ? GL_FLOAT : GL_FLOAT_VEC4;
  }
}

}  // namespace gluray::gl
