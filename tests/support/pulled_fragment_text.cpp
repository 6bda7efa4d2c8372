// The pieces of the fragment shaders of VTK 9.6's and 9.7's vtkOpenGLLowMemoryPolyDataMapper.
#include "tests/support/pbr_text.h"
#include "tests/support/pulled_solid_text.h"
#include "tests/support/pulled_text.h"
#include "tests/support/replaced_text.h"

namespace gluray::test {
namespace {

const char* const kFragmentStart = R"(#version 150
#define highp
#define texelFetchBuffer texelFetch
uniform highp int primitiveSize, usesEdgeValues, cellType, renderPointsAsSpheres, renderLinesAsTubes, pointPicking;
smooth in vec4 vertexVCVSOutput;
uniform highp int cameraParallel;
uniform float intensity_ambient, intensity_diffuse, intensity_opacity, intensity_specular, power_specular;
uniform vec3 color_specular, color_ambient, color_diffuse, vertex_color;
uniform float intensity_ambient_bf, intensity_diffuse_bf, intensity_opacity_bf, intensity_specular_bf;
uniform float power_specular_bf;
uniform vec3 color_specular_bf, color_ambient_bf, color_diffuse_bf;
uniform int vertex_pass, enable_lights;
uniform bool showTexturesOnBackface;
uniform float cOffset, cFactor;
vec3 computedNormalVCVS;
out vec4 fragOutput0;
flat in mat4 edgeEqn;
uniform float ZCalcS;
uniform float ZCalcR;
in vec3 tubeBasis1VS;
in vec3 tubeBasis2VS;
flat in int hasTubeBasisVS;
uniform vec3 edgeColor;
uniform float edgeOpacity;
uniform highp int wireframe, edgeVisibility;
uniform float edgeWidth;
)";

const char* const kColors = R"(
  vec3 ambientColor = intensity_ambient * COLOR.rgb;
  vec3 diffuseColor = intensity_diffuse * COLOR.rgb;
  vec3 specularColor = intensity_specular * color_specular;
  float specularPower = power_specular;
  float opacity = intensity_opacity * COLOR.a;
)";
const char* const kMaterialColors = R"(
  vec3 specularColor = intensity_specular * color_specular;
  float specularPower = power_specular;
  vec3 ambientColor = intensity_ambient * color_ambient;
  vec3 diffuseColor = intensity_diffuse * color_diffuse;
  float opacity = intensity_opacity;
)";
const char* const kBackColors = R"(
  if (vertex_pass != 1 && primitiveSize > 2)
  {
    if (gl_FrontFacing == false)
    {
      ambientColor = intensity_ambient_bf * color_ambient_bf;
      diffuseColor = intensity_diffuse_bf * color_diffuse_bf;
      specularColor = intensity_specular_bf * color_specular_bf;
      specularPower = power_specular_bf;
      opacity = intensity_opacity_bf;
    }
  }
)";

const char* const kPaintedEdges = R"(
  if (vertex_pass == 1)
  {
    ambientColor = intensity_ambient * vertex_color;
    diffuseColor = intensity_diffuse * vertex_color;
    specularColor = intensity_specular * vertex_color;
  }
BLOCKS
  if (((edgeVisibility == 1) || (wireframe == 1)) && (cellType == 5))
  {
    float edist[3];
    edist[0] = dot(edgeEqn[0].xy, gl_FragCoord.xy) + edgeEqn[0].w;
    edist[1] = dot(edgeEqn[1].xy, gl_FragCoord.xy) + edgeEqn[1].w;
    edist[2] = dot(edgeEqn[2].xy, gl_FragCoord.xy) + edgeEqn[2].w;
    if (usesEdgeValues == 1)
    {
      if (edist[0] < -0.5 && edgeEqn[0].z > 0.0) discard;
      if (edist[1] < -0.5 && edgeEqn[1].z > 0.0) discard;
      if (edist[2] < -0.5 && edgeEqn[2].z > 0.0) discard;
      edist[0] += edgeEqn[0].z;
      edist[1] += edgeEqn[1].z;
      edist[2] += edgeEqn[2].z;
    }
    float emix = clamp(0.5 + 0.5 * edgeWidth - min(min(edist[0], edist[1]), edist[2]), 0.0, 1.0);
    if (wireframe == 1)
    {
      opacity = mix(0.0, opacity, emix);
    }
    else
    {
      diffuseColor = mix(diffuseColor, vec3(0.0), emix * edgeOpacity);
      ambientColor = mix(ambientColor, edgeColor, emix * edgeOpacity);
ROUND
    }
  }
)";

const char* const kBlockUniforms = R"(
uniform bool overridesColor;
uniform float intensity_opacity_override;
uniform vec3 color_ambient_override;
uniform vec3 color_diffuse_override;
)";
const char* const kBlockColors = R"(
  opacity = intensity_opacity_override;
  if (overridesColor && vertex_pass == 0) {
    ambientColor = color_ambient_override * intensity_ambient;
    diffuseColor = color_diffuse_override * intensity_diffuse; }
)";

const char* const kHeadlight = R"(
    float df = max(0.0, normalizedNormalVCVSOutput.z);
    float sf = pow(df, power_specular);
    vec3 diffuse = df * diffuseColor * lightColor0;
    vec3 specular = sf * specularColor * lightColor0;
    fragOutput0 = vec4(ambientColor + diffuse + specular, opacity);
)";
const char* const kPhongStart = R"(
    vec3 diffuse = vec3(0,0,0);
    vec3 specular = vec3(0,0,0);
)";
const char* const kPhongEnd = R"(
    diffuse = diffuse * diffuseColor;
    specular = specular * specularColor;
    fragOutput0 = vec4(ambientColor + diffuse + specular, opacity);
)";
const char* const kDirectional = R"(
    df = max(0.0, dot(normalizedNormalVCVSOutput, -lightDirectionVC@));
    diffuse += (df * lightColor@);
    sf = sign(df)*pow(max(1e-5, dot( reflect(lightDirectionVC@, normalizedNormalVCVSOutput), normalize(-vertexVC.xyz))), power_specular);
    specular += (sf * lightColor@);
)";
const char* const kPositional = R"(
    attenuation = 1.0;
    if (lightPositional@ == 0) { vertLightDirectionVC = lightDirectionVC@; }
    else
    {
      vertLightDirectionVC = vertexVC.xyz - lightPositionVC@;
      float distanceVC = length(vertLightDirectionVC);
      vertLightDirectionVC = normalize(vertLightDirectionVC);
      attenuation = 1.0 / (lightAttenuation@.x + lightAttenuation@.y * distanceVC + lightAttenuation@.z * distanceVC * distanceVC);
      if (lightConeAngle@ < 90.0)
      {
        float coneDot = dot(vertLightDirectionVC, lightDirectionVC@);
        if (coneDot >= cos(radians(lightConeAngle@))) { attenuation = attenuation * pow(coneDot, lightExponent@); }
        else { attenuation = 0.0; }
      }
    }
    df = max(0.0, attenuation * dot(normalizedNormalVCVSOutput, -vertLightDirectionVC));
    diffuse += (df * lightColor@);
    sf = sign(df)*attenuation*pow(max(1e-5, dot(reflect(vertLightDirectionVC, normalizedNormalVCVSOutput), normalize(-vertexVC.xyz))), power_specular);
    specular += (sf * lightColor@);
)";

std::string lightText(const PulledSurface& s) {
  switch (s.lights) {
    case PulledLights::none: return "    fragOutput0 = vec4(ambientColor + diffuseColor, opacity);\n";
    case PulledLights::headlight: return kHeadlight;
    case PulledLights::directional:
      return std::string(kPhongStart) + "    float df;\n    float sf;\n" +
             repeated(s.lightCount, kDirectional) + kPhongEnd;
    case PulledLights::positional:
      return std::string(kPhongStart) +
             "    vec3 vertLightDirectionVC;\n    float attenuation;\n    float df;\n    float sf;\n" +
             repeated(s.lightCount, kPositional) + kPhongEnd;
  }
  return "";
}

std::string lightUniforms(const PulledSurface& s) {
  if (s.lights == PulledLights::none) return "";
  return repeated(s.lightCount,
                  "uniform vec3 lightColor@, lightDirectionVC@, lightPositionVC@, lightAttenuation@;\n"
                  "uniform float lightConeAngle@, lightExponent@;\nuniform int lightPositional@;\n");
}

std::string colorText(const PulledSurface& s) {
  std::string text;
  switch (s.color) {
    case PulledColor::material: text = kMaterialColors; break;
    case PulledColor::points:
    case PulledColor::cells: text = replacedInAll(kColors, "COLOR", "vertexColorVS"); break;
    case PulledColor::mapped:
      text = "  vec4 texColor = texture(colortexture, colorTCoordVCVSOutput.st);" +
             replacedInAll(kColors, "COLOR", "texColor");
      break;
  }
  return text + (s.backMaterial ? kBackColors : "");
}

}  // namespace

std::string pulledFragmentText(const PulledSurface& s) {
  const bool flat = s.normals == PulledNormals::none;
  std::string text = kFragmentStart + lightUniforms(s);
  if (!flat) text += "in vec3 normalVCVSInput;\n";
  if (s.color == PulledColor::points || s.color == PulledColor::cells) text += "in vec4 vertexColorVS;\n";
  if (s.color == PulledColor::mapped)
    text += "in vec2 colorTCoordVCVSOutput;\nuniform sampler2D colortexture;\n";
  if (s.textured) text += "in vec2 tcoordVCVSOutput;\nuniform sampler2D actortexture;\n";
  if (s.clipPlanes) text += "in float clipDistancesVSOutput[6];\nuniform int numClipPlanes;\n";
  if (s.summed) text += "out vec4 fragOutput1;\n";
  if (s.blocks) text += kBlockUniforms;
  text += "void main()\n{\n  vec4 vertexVC = vertexVCVSOutput;\n";
  if (flat)
    text +=
        "  float scale = 1.0/length(fwidth(vertexVC.xyz));\n  vec3 fdx = dFdx(vertexVC.xyz)*scale;\n"
        "  vec3 fdy = dFdy(vertexVC.xyz)*scale;\n";
  if (s.depthOffset) text += "  float cscale = length(vec2(dFdx(gl_FragCoord.z),dFdy(gl_FragCoord.z)));\n";
  text += flat ? kPulledDepthWithoutNormals : kPulledDepthWithNormals;
  if (s.depthOffset) text += "  gl_FragDepth = gl_FragCoord.z + cFactor*cscale + 1.0*cOffset/65000.0f;\n";
  if (s.clipPlanes)
    text +=
        "  for (int planeNum = 0; planeNum < numClipPlanes; planeNum++)\n  {\n"
        "    if (clipDistancesVSOutput[planeNum] < 0.0) discard;\n  }\n";
  text += colorText(s) + replacedInAll(replacedInAll(kPaintedEdges, "ROUND", kPulledRoundEdges), "BLOCKS",
                                       s.blocks ? kBlockColors : "");
  text += flat ? kPulledNormalOfPrimitives : kPulledNormalOfVertices;
  text +=
      "  fragOutput0 = vec4(ambientColor + diffuseColor, opacity);\n"
      "  int vtkEnableLights = enable_lights;\n" +
      std::string(kPulledTubesAreLit) + "  if (vtkEnableLights == 1)\n  {\n" + lightText(s) + "  }\n";
  if (s.textured)
    text +=
        "  vec4 tcolor_0 = texture(actortexture, tcoordVCVSOutput);\n  vec4 tcolor = tcolor_0;\n"
        "  if (primitiveSize > 2)\n  {\n    if (gl_FrontFacing == true || showTexturesOnBackface)\n    {\n"
        "      fragOutput0 = fragOutput0 * tcolor;\n    }\n  }\n";
  text += "  if (fragOutput0.a <= 0.0)\n  {\n    discard;\n  }\n";
  if (s.summed)
    text +=
        "  fragOutput0 = vec4(fragOutput0.rgb*fragOutput0.a, fragOutput0.a);\n"
        "  fragOutput1.r = fragOutput0.a;\n";
  return text + "}\n";
}

}  // namespace gluray::test
