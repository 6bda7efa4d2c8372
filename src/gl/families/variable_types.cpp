#include "gl/families/variable_types.h"

#include "gl/glsl/glsl_types.h"

#include <initializer_list>

namespace gluray::gl {
namespace {

bool isDouble(GLenum type) {
  return type == GL_DOUBLE || (type >= GL_DOUBLE_VEC2 && type <= GL_DOUBLE_VEC4) ||
         (type >= GL_DOUBLE_MAT2 && type <= GL_DOUBLE_MAT4x3);
}

/// A set of types that a variable may have in its role in a family.
struct Types {
  const char* what;
  bool (*fit)(GLenum type);
};
const Types kNumber{"a number", [](GLenum t) {
                      return t == GL_FLOAT || t == GL_INT || t == GL_UNSIGNED_INT || t == GL_BOOL;
                    }};
const Types kFloat{"a float", [](GLenum t) { return t == GL_FLOAT; }};
const Types kVector{"a vector",
                    [](GLenum t) { return t == GL_FLOAT_VEC2 || t == GL_FLOAT_VEC3 || t == GL_FLOAT_VEC4; }};
const Types kFloats{"a float or vector", [](GLenum t) { return kFloat.fit(t) || kVector.fit(t); }};
const Types kValue{"a number or vector", [](GLenum t) { return kNumber.fit(t) || kVector.fit(t); }};
const Types kMatrix{"a mat4", [](GLenum t) { return t == GL_FLOAT_MAT4; }};
const Types kPlain{"a number, vector or matrix", [](GLenum t) { return glslName(t).find("sampler") != 0; }};
const Types kVec2{"a vec2", [](GLenum t) { return t == GL_FLOAT_VEC2; }};
const Types kVec4{"a vec4", [](GLenum t) { return t == GL_FLOAT_VEC4; }};
const Types kLinear{"a mat3 or mat4", [](GLenum t) { return t == GL_FLOAT_MAT3 || t == GL_FLOAT_MAT4; }};
const Types kImage{"a sampler", [](GLenum t) { return t == GL_SAMPLER_2D || t == GL_SAMPLER_1D; }};
const Types kCube{"a samplerCube", [](GLenum t) { return t == GL_SAMPLER_CUBE; }};
const Types kBuffer{"a samplerBuffer", [](GLenum t) { return t == GL_SAMPLER_BUFFER; }};
const Types kIntegers{"an isamplerBuffer", [](GLenum t) {
                        return t == GL_INT_SAMPLER_BUFFER || t == GL_UNSIGNED_INT_SAMPLER_BUFFER;
                      }};
const Types kBytes{"a usamplerBuffer", [](GLenum t) { return t == GL_UNSIGNED_INT_SAMPLER_BUFFER; }};

/// Reports variables of wrong types.
class TypeCheck {
 public:
  TypeCheck(const Program& p, std::vector<std::string>& out) : p_(p), out_(out) {}

  void attribute(const std::string& name, const Types& types = kVector) const {
    const ProgramAttribute* a = name.empty() ? nullptr : p_.attribute(name);
    if (a && !types.fit(a->type)) refuse(name, types);
  }
  void uniform(const std::string& name, const Types& types) const {
    const ProgramUniform* u = name.empty() ? nullptr : p_.uniform(name);
    if (u && !types.fit(u->type)) refuse(name, types);
  }
  void uniforms(const std::vector<std::string>& names, const Types& types) const {
    for (const std::string& name : names) uniform(name, types);
  }
  void values(std::initializer_list<const FamilyValue*> values) const {
    for (const FamilyValue* v : values) uniform(v->uniform, kValue), uniforms(v->factors, kValue);
  }
  void material(const FamilyMaterial& m) const {
    values({&m.ambientIntensity, &m.ambientColor, &m.diffuseIntensity, &m.diffuseColor, &m.specularIntensity,
            &m.specularColor, &m.emission, &m.shininess, &m.opacity});
  }
  /// Checks the variable of the first light, or the array that holds the variables of all lights.
  void light(const std::string& pattern, const Types& types) const {
    if (pattern.ends_with("[{}]")) return uniform(pattern.substr(0, pattern.size() - 4), types);
    const size_t at = pattern.find("{}");
    if (at == std::string::npos) return uniform(pattern, types);
    std::string name = pattern.substr(0, at);
    uniform(name.append("0").append(pattern, at + 2), types);
  }

 private:
  void refuse(const std::string& name, const Types& types) const {
    out_.push_back(about("has ", name, std::string(", which is not ") + types.what));
  }
  const Program& p_;
  std::vector<std::string>& out_;
};

void needPulledTypes(const TypeCheck& check, const Family& f) {
  const FamilyPulling& pull = f.pulling;
  for (const std::string* name : {&f.position, &f.normal, &f.texcoord, &f.mapTexcoord})
    check.uniform(*name, kBuffer);
  check.uniform(f.color, kBytes), check.uniform(f.edgeFlags, kBytes);
  for (const std::string* name : {&pull.pointIds, &pull.cells}) check.uniform(*name, kIntegers);
  for (const std::string* name :
       {&pull.pointOffset, &pull.firstVertex, &pull.indexedIf, &pull.cellsIf, &pull.cellsOffset, &pull.size,
        &f.edgesIf, &f.edgesUnless, &f.edgeFlagsIf, &f.edgeFlagsOffset})
    check.uniform(*name, kNumber);
}

}  // namespace

std::string about(const char* before, const std::string& name, const std::string& after) {
  std::string text = before;
  return text.append("\"").append(name).append("\"").append(after);
}

void needTypes(const Program& p, const Family& f, std::vector<std::string>& out) {
  if (!f.rasteriseBecause.empty()) return;
  const TypeCheck check(p, out);
  const FamilyLights& l = f.lights;
  for (const std::string* name :
       {&f.position, &f.normal, &f.color, &f.texcoord, &f.tangent, &f.impostors.axis})
    check.attribute(*name);
  check.attribute(f.mapTexcoord, kFloats);
  if (f.pulling.given()) needPulledTypes(check, f);
  check.attribute(f.instanceShift, kVec4);
  for (const auto& [name, value] : f.neutral) check.uniform(name, kPlain);
  for (const auto& [name, value] : f.decided) check.uniform(name, kNumber);
  check.values({&f.impostors.radius, &f.impostors.inside, &f.impostors.radiusDivisor, &f.impostors.size,
                &f.impostors.bulge, &f.impostors.bulgeDepth, &f.impostors.depthBias, &f.impostors.scale,
                &f.impostors.billboardScale});
  check.values({&f.impostors.longer});
  check.uniform(f.impostors.projection, kMatrix), check.uniform(f.impostors.viewport, kVec4);
  check.attribute(f.impostors.end), check.attribute(f.impostors.endColor);
  check.attribute(f.impostors.corners, f.impostors.radiusInCorners ? kVec2 : kFloat);
  check.attribute(f.impostors.caps, kFloat);
  check.uniform(f.impostors.roundCaps, kNumber);
  for (const FamilyValue& factor : f.impostors.halvesBlend) check.values({&factor});
  check.uniforms(f.clipFromObject, kMatrix), check.uniforms(f.eyeFromObject, kLinear);
  check.uniform(f.normalMatrix, kLinear), check.uniform(f.viewer, kVector);
  check.uniform(f.parallelView, kNumber), check.uniform(f.triangleOffset, kNumber);
  check.uniform(f.flipsBackFaces, kNumber), check.uniform(f.lights.enabled, kNumber);
  check.values({&f.fog.color, &f.fog.start, &f.fog.end, &f.fog.scale, &f.fog.density});
  check.uniform(f.uniformColors, kNumber), check.uniform(f.clipPlaneCount, kNumber);
  check.uniform(f.clipPlanes, kVector), check.uniform(f.clipWindow, kVec4);
  check.uniform(f.texcoordMatrix, kMatrix);
  check.values({&f.edgeWidth, &f.edgeColor, &f.edgeOpacity});
  check.values({&f.rimColor, &f.rimExponent, &f.rimOpacity});
  check.values({&f.backColor}), check.uniform(f.backColorIf, kNumber);
  check.uniform(f.texturesIf, kNumber), check.uniform(f.fog.modeFrom, kNumber);
  for (int c = 0; c < 3; ++c) check.values({&f.height.scale[c], &f.height.offset[c], &f.height.exponent[c]});
  check.uniforms(f.matcap, kImage), check.values({&f.mapLow, &f.mapHigh, &f.backFactor, &f.pbr.ambient});
  check.uniforms(l.positionMatrix, kMatrix);
  check.uniform(f.colorMap, kImage), check.uniforms(f.textures, kImage);
  check.uniform(f.triangleColors, f.pulling.given() ? kBytes : kBuffer);
  check.uniform(f.triangleNormals, kBuffer);
  check.material(f.material), check.material(f.backMaterial);
  check.values({&f.pbr.metallic, &f.pbr.roughness, &f.pbr.baseF0, &f.pbr.edgeTint, &f.pbr.emissive,
                &f.pbr.occlusionStrength, &f.pbr.normalScale, &f.depthOffset, &f.depthFactor});
  check.values({&f.pbr.environmentIntensity, &f.pbr.multipleScattering, &f.pbr.distributionFloor,
                &f.colorExponent, &f.encoding});
  for (const std::string* name :
       {&f.pbr.materialTexture, &f.pbr.emissiveTexture, &f.pbr.normalTexture, &f.pbr.brdfTable})
    check.uniform(*name, kImage);
  check.uniform(f.pbr.irradiance, kCube), check.uniform(f.pbr.prefiltered, kCube);
  check.uniform(f.pbr.environmentMatrix, kLinear), check.uniforms(f.pbr.harmonics, kNumber);
  for (const std::string* name :
       {&l.color, &l.direction.uniform, &l.position, &l.attenuation, &l.halfVector.uniform})
    check.light(*name, kVector);
  for (const std::string* name : {&l.intensity.uniform, &l.highlightIntensity.uniform, &l.positional,
                                  &l.coneAngle, &l.exponent, &l.count})
    check.light(*name, kNumber);
  for (const auto* values : {&l.specularColor, &l.shininess})
    for (const FamilyValue& value : *values) check.light(value.uniform, kValue);
  for (const auto& [name, uniform] : p.uniforms)
    if (isDouble(uniform.type)) out.push_back(about("has ", name, " in double precision"));
}

}  // namespace gluray::gl
