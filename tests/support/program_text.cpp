// The pieces of VTK 9.1's polygonal shaders (vtkOpenGLPolyDataMapper's replacements in vtkPolyDataVS and FS).
#include "tests/support/edges_text.h"
#include "tests/support/pbr_text.h"

namespace gluray::test {
namespace {

const char* const kPhongStart =
    "  vec3 diffuse = vec3(0,0,0);\n  vec3 specular = vec3(0,0,0);\n  float df;\n  float sf;\n";
const char* const kPhongEnd =
    "  diffuse = diffuse * diffuseColor;\n  specular = specular * specularColor;\n"
    "  fragOutput0 = vec4(ambientColor + diffuse + specular, opacity);\n";

const char* const kDirectional =
    "  df = max(0.0, dot(normalVCVSOutput, -lightDirectionVC@));\n"
    "  diffuse += (df * lightColor@);\n"
    "  sf = sign(df)*pow(max(1e-5, dot( reflect(lightDirectionVC@, normalVCVSOutput), "
    "normalize(-vertexVC.xyz))), "
    "specularPower);\n"
    "  specular += (sf * lightColor@);\n";

const char* const kPositional =
    "  attenuation = 1.0;\n"
    "  if (lightPositional@ == 0) { vertLightDirectionVC = lightDirectionVC@; }\n"
    "  else {\n"
    "    vertLightDirectionVC = vertexVC.xyz - lightPositionVC@;\n"
    "    float distanceVC = length(vertLightDirectionVC);\n"
    "    vertLightDirectionVC = normalize(vertLightDirectionVC);\n"
    "    attenuation = 1.0 / (lightAttenuation@.x + lightAttenuation@.y * distanceVC\n"
    "      + lightAttenuation@.z * distanceVC * distanceVC);\n"
    "    if (lightConeAngle@ < 90.0) {\n"
    "      float coneDot = dot(vertLightDirectionVC, lightDirectionVC@);\n"
    "      if (coneDot >= cos(radians(lightConeAngle@))) { attenuation = attenuation * pow(coneDot, "
    "lightExponent@); }\n"
    "      else { attenuation = 0.0; }\n"
    "    }\n  }\n"
    "  df = max(0.0,attenuation*dot(normalVCVSOutput, -vertLightDirectionVC));\n"
    "  diffuse += (df * lightColor@);\n"
    "  sf = sign(df)*attenuation*pow( max(1e-5, dot( reflect(vertLightDirectionVC, normalVCVSOutput), "
    "normalize(-vertexVC.xyz))), specularPower);\n"
    "  specular += (sf * lightColor@);\n";

bool hasColorTcoord(const Surface& s) { return s.color == Surface::Color::mapped && s.colorTcoord; }
bool hasTcoord(const Surface& s) {
  return s.actorTexture || s.pbrTextures || s.normalMap || s.baseTexture ||
         (s.color == Surface::Color::mapped && !s.colorTcoord);
}

/// Statements that copy attribute `name` to the vertex shader's output `name` + VCVSOutput.
std::string tcoordText(const Surface& s, const std::string& name) {
  if (!s.tcoordMatrix) return "  " + name + "VCVSOutput = " + name + ";\n";
  return "  vec4 " + name + "Tmp = tcMatrix*vec4(" + name + ",0.0,1.0);\n  " + name + "VCVSOutput = " + name +
         "Tmp.xy/" + name + "Tmp.w;\n";
}

std::string uniformText(const Surface& s) {
  const std::string positional =
      "uniform vec3 lightPositionVC@;\nuniform vec3 lightAttenuation@;\nuniform float lightConeAngle@;\n"
      "uniform float lightExponent@;\nuniform int lightPositional@;\n";
  std::string text =
      "uniform int PrimitiveIDOffset;\nuniform int cameraParallel;\nuniform bool OverridesColor;\n"
      "uniform float ambientIntensity;\nuniform float diffuseIntensity;\nuniform float opacityUniform;\n"
      "uniform vec3 ambientColorUniform;\nuniform vec3 diffuseColorUniform;\nuniform float "
      "specularIntensity;\n"
      "uniform vec3 specularColorUniform;\nuniform float specularPowerUniform;\n";
  if (s.backMaterial)
    text +=
        "uniform float ambientIntensityBF;\nuniform float diffuseIntensityBF;\nuniform float "
        "opacityUniformBF;\n"
        "uniform vec3 ambientColorUniformBF;\nuniform vec3 diffuseColorUniformBF;\nuniform float "
        "specularIntensityBF;\nuniform vec3 specularColorUniformBF;\nuniform float specularPowerUniformBF;\n";
  if (s.lights == Surface::Lights::headlight) text += "uniform vec3 lightColor0;\n";
  if (s.lights > Surface::Lights::headlight)
    text += repeated(s.lightCount, "uniform vec3 lightColor@;\nuniform vec3 lightDirectionVC@;\n");
  if (s.lights == Surface::Lights::positional || s.lights == Surface::Lights::pbrPositional)
    text += repeated(s.lightCount, positional);
  if (s.lights >= Surface::Lights::pbr) text += pbrDeclarations(s);
  if (s.clipPlanes) text += "uniform int numClipPlanes;\nin float clipDistancesVSOutput[6];\n";
  if (s.depthOffset) text += "uniform float cOffset;\nuniform float cFactor;\n";
  if (s.actorTexture) text += "uniform sampler2D actortexture;\n";
  if (s.baseTexture) text += "uniform sampler2D albedoTex;\n";
  if (s.color == Surface::Color::cell) text += "uniform samplerBuffer textureC;\n";
  if (s.color == Surface::Color::mapped) text += "uniform sampler2D colortexture;\n";
  if (s.color == Surface::Color::vertex) text += "in vec4 vertexColorVSOutput;\n";
  if (hasTcoord(s)) text += "in vec2 tcoordVCVSOutput;\n";
  if (hasColorTcoord(s)) text += "in vec2 colorTCoordVCVSOutput;\n";
  if (s.normals == Surface::Normals::cell)
    text += "uniform samplerBuffer textureN;\nuniform mat3 normalMatrix;\n";
  if (s.normals == Surface::Normals::vertex) text += "in vec3 normalVCVSOutput;\n";
  return text + "in vec4 vertexVCVSOutput;\nout vec4 fragOutput0;\n";
}

const char* const kBackMaterial =
    "  if (gl_FrontFacing == false) {\n    ambientColor = ambientIntensityBF * ambientColorUniformBF;\n"
    "    diffuseColor = diffuseIntensityBF * diffuseColorUniformBF;\n"
    "    specularColor = specularIntensityBF * specularColorUniformBF;\n"
    "    specularPower = specularPowerUniformBF;\n    opacity = opacityUniformBF; }\n";

/// Which value an unlit colour begins with.
std::string colorText(const Surface& s) {
  const std::string material =
      "  vec3 specularColor = specularIntensity * specularColorUniform;\n"
      "  float specularPower = specularPowerUniform;\n";
  const char* const override =
      !s.overridable ? ""
                     : "  if (OverridesColor) {\n    ambientColor = ambientColorUniform * ambientIntensity;\n"
                       "    diffuseColor = diffuseColorUniform * diffuseIntensity; }\n";
  std::string texel;
  if (s.color == Surface::Color::cell) texel = "texelFetch(textureC, gl_PrimitiveID + PrimitiveIDOffset)";
  if (s.color == Surface::Color::mapped)
    texel =
        std::string("texture(colortexture, ") + (s.colorTcoord ? "colorTCoord" : "tcoord") + "VCVSOutput.st)";
  if (s.color == Surface::Color::vertex) texel = "vertexColorVSOutput";
  const std::string ofMaterial =
      material +
      "  vec3 ambientColor = ambientIntensity * ambientColorUniform;\n"
      "  vec3 diffuseColor = diffuseIntensity * diffuseColorUniform;\n  float opacity = "
      "opacityUniform;\n" +
      override + (s.backMaterial ? kBackMaterial : "");
  if (texel.empty()) return ofMaterial;
  if (s.backMaterial)
    return ofMaterial +
           "  diffuseColor = diffuseIntensity * vertexColorVSOutput.rgb;\n"
           "  ambientColor = ambientIntensity * vertexColorVSOutput.rgb;\n"
           "  opacity = opacity * vertexColorVSOutput.a;\n";
  return material + "  vec4 texColor = " + texel +
         ";\n  vec3 ambientColor = ambientIntensity * texColor.rgb;\n"
         "  vec3 diffuseColor = diffuseIntensity * texColor.rgb;\n  float opacity = opacityUniform * "
         "texColor.a;\n" +
         (s.recent ? "  ambientColor = pow(ambientColor, vec3(2.2));\n  diffuseColor = pow(diffuseColor, "
                     "vec3(2.2));\n"
                   : "") +
         override;
}

std::string normalText(const Surface& s) {
  const std::string turned = "  if (gl_FrontFacing == false) { normalVCVSOutput = -normalVCVSOutput; }\n";
  if (s.normals == Surface::Normals::vertex)
    return "  vec3 normalVCVSOutput = normalize(normalVCVSOutput);\n" + turned +
           (s.normalMap ? normalMapText() : "");
  if (s.normals == Surface::Normals::cell)
    return "  vec3 normalVCVSOutput = texelFetch(textureN, gl_PrimitiveID + PrimitiveIDOffset).xyz;\n"
           "  normalVCVSOutput = normalize(normalMatrix * normalVCVSOutput);\n" +
           turned;
  return "  vec3 normalVCVSOutput = normalize(cross(fdx,fdy));\n"
         "  if (cameraParallel == 1 && normalVCVSOutput.z < 0.0) { normalVCVSOutput = -1.0*normalVCVSOutput; "
         "}\n"
         "  if (cameraParallel == 0 && dot(normalVCVSOutput,vertexVC.xyz) > 0.0) { normalVCVSOutput = "
         "-1.0*normalVCVSOutput; }\n";
}

std::string lightText(const Surface& s) {
  switch (s.lights) {
    case Surface::Lights::none:
      return std::string(s.baseTexture ? "  diffuseColor *= texture(albedoTex, tcoordVCVSOutput).rgb;\n"
                                       : "") +
             "  fragOutput0 = vec4(ambientColor + diffuseColor, opacity);\n" +
             (s.recent ? "  fragOutput0.rgb = pow(fragOutput0.rgb, vec3(1.0/2.2));\n" : "");
    case Surface::Lights::headlight:
      return "  float df = max(0.000001, normalVCVSOutput.z);\n  float sf = pow(df, specularPower);\n"
             "  vec3 diffuse = df * diffuseColor * lightColor0;\n"
             "  vec3 specular = sf * specularColor * lightColor0;\n"
             "  fragOutput0 = vec4(ambientColor + diffuse + specular, opacity);\n";
    case Surface::Lights::directional: return kPhongStart + repeated(s.lightCount, kDirectional) + kPhongEnd;
    case Surface::Lights::positional:
      return std::string("  vec3 vertLightDirectionVC;\n  float attenuation;\n") + kPhongStart +
             repeated(s.lightCount, kPositional) + kPhongEnd;
    case Surface::Lights::pbr:
    case Surface::Lights::pbrPositional:
    case Surface::Lights::pbrHeadlight: return pbrText(s);
  }
  return "";
}

}  // namespace

std::string vertexText(const Surface& s) {
  const bool normals = s.normals == Surface::Normals::vertex;
  const bool colors = s.color == Surface::Color::vertex;
  std::string text = s.version +
                     "in vec4 vertexMC;\nout vec4 vertexVCVSOutput;\nuniform mat4 MCDCMatrix;\n"
                     "uniform mat4 MCVCMatrix;\n";
  if (normals) text += "in vec3 normalMC;\nuniform mat3 normalMatrix;\nout vec3 normalVCVSOutput;\n";
  if (colors) text += "in vec4 scalarColor;\nout vec4 vertexColorVSOutput;\n";
  if (hasTcoord(s)) text += "in vec2 tcoord;\nout vec2 tcoordVCVSOutput;\n";
  if (hasColorTcoord(s)) text += "in vec2 colorTCoord;\nout vec2 colorTCoordVCVSOutput;\n";
  if (s.tcoordMatrix) text += "uniform mat4 tcMatrix;\n";
  if (s.normalMap) text += "in vec3 tangentMC;\nout vec3 tangentVCVSOutput;\n";
  if (s.clipPlanes)
    text += "uniform int numClipPlanes;\nuniform vec4 clipPlanes[6];\nout float clipDistancesVSOutput[6];\n";
  text += "void main()\n{\n";
  if (s.clipPlanes)
    text +=
        "  for (int planeNum = 0; planeNum < numClipPlanes; planeNum++)\n"
        "    clipDistancesVSOutput[planeNum] = dot(clipPlanes[planeNum], vertexMC);\n";
  if (colors) text += "  vertexColorVSOutput = scalarColor;\n";
  if (hasTcoord(s)) text += tcoordText(s, "tcoord");
  if (hasColorTcoord(s)) text += tcoordText(s, "colorTCoord");
  if (normals) text += "  normalVCVSOutput = normalMatrix * normalMC;\n";
  if (s.normalMap) text += "  tangentVCVSOutput = normalMatrix * tangentMC;\n";
  return text + "  vertexVCVSOutput = MCVCMatrix * vertexMC;\n  gl_Position = MCDCMatrix * vertexMC;\n}\n";
}

std::string fragmentText(const Surface& s) {
  std::string text = s.version + uniformText(s) + (s.edges ? edgeDeclarations() : "") +
                     "void main()\n{\n  vec4 vertexVC = vertexVCVSOutput;\n";
  if (s.clipPlanes)
    text +=
        "  for (int planeNum = 0; planeNum < numClipPlanes; planeNum++)\n"
        "    if (clipDistancesVSOutput[planeNum] < 0.0) discard;\n";
  if (s.normals == Surface::Normals::triangle)
    text += "  vec3 fdx = dFdx(vertexVC.xyz);\n  vec3 fdy = dFdy(vertexVC.xyz);\n";
  if (s.depthOffset)
    text +=
        "  float cscale = length(vec2(dFdx(gl_FragCoord.z),dFdy(gl_FragCoord.z)));\n"
        "  gl_FragDepth = gl_FragCoord.z + cFactor*cscale + 1.0*cOffset/65000;\n";
  text += colorText(s);
  if (s.edges) text += edgePainting();
  if (s.lights != Surface::Lights::none) text += normalText(s);
  text += lightText(s);
  if (s.actorTexture)
    text += "  fragOutput0 = fragOutput0 * vec4(texture(actortexture, tcoordVCVSOutput).rgb, 1.0);\n";
  text += "  if (fragOutput0.a <= 0.0)\n    {\n    discard;\n    }\n}\n";
  return s.edges ? afterGeometry(text) : text;
}

}  // namespace gluray::test
