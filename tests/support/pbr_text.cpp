// The pieces of VTK's shaders for physically based materials, of 9.1 and 9.7.
#include "tests/support/pbr_text.h"

namespace gluray::test {

std::string repeated(int count, const std::string& text) {
  std::string all;
  for (int i = 0; i < count; ++i)
    for (const char c : text) all += c == '@' ? std::to_string(i) : std::string(1, c);
  return all;
}

namespace {

const char* const kPbrFunctions =
    "const float PI = 3.14159265359;\nconst float recPI = 0.31830988618;\n"
    "float D_GGX(float NdH, float roughness) {\n"
    "  float a = roughness * roughness;\n  float a2 = a * a;\n"
    "  float d = (NdH * a2 - NdH) * NdH + 1.0;\n  return a2 / (PI * d * d);\n}\n"
    "float V_SmithCorrelated(float NdV, float NdL, float roughness) {\n"
    "  float a2 = roughness * roughness;\n"
    "  float ggxV = NdL * sqrt(a2 + NdV * (NdV - a2 * NdV));\n"
    "  float ggxL = NdV * sqrt(a2 + NdL * (NdL - a2 * NdL));\n  return 0.5 / (ggxV + ggxL);\n}\n"
    "vec3 F_Schlick(vec3 F0, vec3 F90, float HdL) { return F0 + (F90 - F0) * pow(1.0 - HdL, 5.0); }\n"
    "vec3 DiffuseLambert(vec3 albedo) { return albedo * recPI; }\n"
    "vec3 SpecularIsotropic(float NdH, float NdV, float NdL, float HdL, float roughness, vec3 F0, vec3 F90, "
    "out "
    "vec3 F) {\n"
    "  float D = D_GGX(NdH, roughness);\n  float V = V_SmithCorrelated(NdV, NdL, roughness);\n"
    "  F = F_Schlick(F0, F90, HdL);\n  return (D * V) * F;\n}\n";

const char* const kPbrLight =
    "  L = normalize(-lightDirectionVC@);\n  H = normalize(V + L);\n  HdL = clamp(dot(H, L), 1e-5, 1.0);\n"
    "  NdL = clamp(dot(N, L), 1e-5, 1.0);\n  NdH = clamp(dot(N, H), 1e-5, 1.0);\n  radiance = lightColor@;\n"
    "  specular = SpecularIsotropic(NdH, NdV, NdL, HdL, roughness, F0, F90, F);\n"
    "  diffuse = (1.0 - metallic) * (1.0 - F) * DiffuseLambert(albedo);\n"
    "  Lo += radiance * (diffuse + specular) * NdL;\n";
/// For a single light at the viewer: L = V = H.
const char* const kPbrHeadlight =
    "  specular = SpecularIsotropic(NdV, NdV, NdV, 1.0, roughness, F0, F90, F);\n"
    "  diffuse = (1.0 - metallic) * (1.0 - F) * DiffuseLambert(albedo);\n  radiance = lightColor0;\n"
    "  Lo += radiance * (diffuse + specular) * NdV;\n";

const char* const kPbrPositional =
    "  if (lightPositional@ == 0) {\n    attenuation = 1.0;\n    L = -lightDirectionVC@;\n  } else {\n"
    "    L = lightPositionVC@ - vertexVC.xyz;\n    distanceVC = length(L);\n    L = normalize(L);\n"
    "    attenuation = 1.0 / (lightAttenuation@.x\n      + lightAttenuation@.y * distanceVC\n"
    "      + lightAttenuation@.z * distanceVC * distanceVC);\n    if (lightConeAngle@ < 90.0) {\n"
    "      float coneDot = dot(-L, lightDirectionVC@);\n"
    "      if (coneDot >= cos(radians(lightConeAngle@)))\n      {\n"
    "        attenuation = attenuation * pow(coneDot, lightExponent@);\n      }\n      else\n      {\n"
    "        attenuation = 0.0;\n      }\n    }\n  }\n"
    "  H = normalize(V + L);\n  NdL = clamp(dot(N, L), 1e-5, 1.0);\n  NdH = clamp(dot(N, H), 1e-5, 1.0);\n"
    "  HdL = clamp(dot(H, L), 1e-5, 1.0);\n  radiance = lightColor@;\n  radiance *= attenuation;\n"
    "  specular = SpecularIsotropic(NdH, NdV, NdL, HdL, roughness, F0, F90, F);\n"
    "  diffuse = (1.0 - metallic) * (1.0 - F) * DiffuseLambert(albedo);\n"
    "  Lo += radiance * (diffuse + specular) * NdL;\n";

const char* const kScatteredOften =
    "  diffuse = (1.0 - metallic) * (1.0 - 0.04) * albedo;\n"
    "  vec3 Fr = max(vec3(1.0 - roughness), F0) - F0;\n  vec3 k_S = F0 + Fr * pow(1.0 - NdV, 5.0);\n"
    "  vec3 FssEss = k_S * brdf.r + F90 * brdf.g;\n  float Ems = 1.0 - (brdf.r + brdf.g);\n"
    "  vec3 F_avg = F0 + (1.0 - F0) / 21.0;\n"
    "  vec3 FmsEms = Ems * FssEss * F_avg / max(1.0 - F_avg * Ems, vec3(1e-5));\n"
    "  vec3 k_D = diffuse * (1.0 - FssEss - FmsEms);\n  vec3 iblSpecular = FssEss * "
    "prefilteredSpecularColor;\n  vec3 iblDiffuse = (FmsEms + k_D) * irradiance;\n";

const char* const kHarmonics =
    "uniform float shRed[9];\nuniform float shGreen[9];\nuniform float shBlue[9];\n"
    "float ComputeSH(vec3 n, float sh[9])\n{\n  float v = 0.0;\n  v += sh[0];\n  v += sh[1] * n.y;\n"
    "  v += sh[2] * n.z;\n  v += sh[3] * n.x;\n  v += sh[4] * n.x * n.y;\n  v += sh[5] * n.y * n.z;\n"
    "  v += sh[6] * (3.0 * n.z * n.z - 1.0);\n  v += sh[7] * n.x * n.z;\n"
    "  v += sh[8] * (n.x * n.x - n.y * n.y);\n  return max(v, 0.0);\n}\n";

std::string functionsText(const Surface& s) {
  std::string text = kPbrFunctions;
  const std::string plain = "  return a2 / (PI * d * d);\n";
  if (s.recent)
    text.replace(text.find(plain), plain.size(),
                 "  float denom = max(PI * d * d, 1e-8);\n  return a2 / denom;\n");
  return text;
}

std::string environmentDeclarations(const Surface& s) {
  if (s.environment == Surface::Environment::none) return "";
  const std::string images =
      "uniform mat3 envMatrix;\nuniform sampler2D brdfTex;\nuniform samplerCube prefilterTex;\n";
  return images + (s.environment == Surface::Environment::harmonics ? kHarmonics
                                                                    : "uniform samplerCube irradianceTex;\n");
}

std::string valuesText(const Surface& s) {
  std::string text;
  if (s.pbrTextures)
    text +=
        "  vec4 albedoSample = texture(albedoTex, tcoordVCVSOutput);\n"
        "  vec3 albedo = albedoSample.rgb * diffuseColor;\n"
        "  opacity = opacityUniform * albedoSample.a;\n"
        "  vec3 emissiveColor = texture(emissiveTex, tcoordVCVSOutput).rgb;\n"
        "  emissiveColor = emissiveColor * emissiveFactorUniform;\n"
        "  vec4 material = texture(materialTex, tcoordVCVSOutput);\n"
        "  float roughness = material.g * roughnessUniform;\n"
        "  float metallic = material.b * metallicUniform;\n  float ao = material.r;\n";
  if (s.environment != Surface::Environment::none) text += "  const float prefilterMaxLevel = float(4);\n";
  if (!s.pbrTextures)
    text +=
        "  vec3 albedo = diffuseColor;\n  float roughness = roughnessUniform;\n"
        "  float metallic = metallicUniform;\n  float ao = 1.0;\n  vec3 emissiveColor = vec3(0.0);\n";
  return text +
         "  vec3 N = normalVCVSOutput;\n  vec3 V = normalize(-vertexVC.xyz);\n"
         "  float NdV = clamp(dot(N, V), 1e-5, 1.0);\n";
}

std::string environmentText(const Surface& s) {
  if (s.environment == Surface::Environment::none) return "";
  const std::string irradiance =
      s.environment == Surface::Environment::cube
          ? "  vec3 irradiance = texture(irradianceTex, envMatrix*N).rgb;\n"
          : "  vec3 rotN = envMatrix * N;\n"
            "  vec3 irradiance = vec3(ComputeSH(rotN, shRed), ComputeSH(rotN, shGreen), ComputeSH(rotN, "
            "shBlue));\n";
  return irradiance +
         "  vec3 worldReflect = normalize(envMatrix*reflect(-V, N));\n"
         "  vec3 prefilteredSpecularColor = textureLod(prefilterTex, worldReflect, roughness * "
         "prefilterMaxLevel).rgb;\n  vec2 brdf = texture(brdfTex, vec2(NdV, roughness)).rg;\n";
}

}  // namespace

std::string pbrDeclarations(const Surface& s) {
  std::string text =
      "uniform float metallicUniform;\nuniform float roughnessUniform;\nuniform float aoStrengthUniform;\n"
      "uniform float baseF0Uniform;\nuniform vec3 edgeTintUniform;\nuniform vec3 emissiveFactorUniform;\n";
  if (s.pbrTextures)
    text += "uniform sampler2D albedoTex;\nuniform sampler2D emissiveTex;\nuniform sampler2D materialTex;\n";
  if (s.normalMap)
    text += "uniform sampler2D normalTex;\nuniform float normalScaleUniform;\nin vec3 tangentVCVSOutput;\n";
  if (s.recent) text += "uniform float IBLIntensity;\n";
  return text + environmentDeclarations(s) + functionsText(s);
}

std::string normalMapText() {
  return "  vec3 tangentVC = tangentVCVSOutput;\n"
         "  tangentVC = normalize(tangentVC - dot(tangentVC, normalVCVSOutput) * normalVCVSOutput);\n"
         "  vec3 bitangentVC = cross(normalVCVSOutput, tangentVC);\n"
         "  mat3 tbn = mat3(tangentVC, bitangentVC, normalVCVSOutput);\n"
         "  vec3 normalTS = texture(normalTex, tcoordVCVSOutput).xyz * 2.0 - 1.0;\n"
         "  normalTS = normalize(normalTS * vec3(normalScaleUniform, normalScaleUniform, 1.0));\n"
         "  normalVCVSOutput = normalize(tbn * normalTS);\n";
}

std::string pbrText(const Surface& s) {
  const bool lit = s.environment != Surface::Environment::none;
  std::string text = valuesText(s) + environmentText(s) +
                     "  vec3 Lo = vec3(0.0);\n  vec3 F0 = mix(vec3(baseF0Uniform), albedo, metallic);\n"
                     "  float f90 = clamp(dot(F0, vec3(50.0 * 0.33)), 0.0, 1.0);\n"
                     "  vec3 F90 = mix(vec3(f90), edgeTintUniform, metallic);\n"
                     "  vec3 L, H, radiance, F, specular, diffuse;\n"
                     "  float NdL, NdH, HdL, distanceVC, attenuation, D, Vis;\n";
  text += s.lights == Surface::Lights::pbrHeadlight
              ? kPbrHeadlight
              : repeated(s.lightCount, s.lights == Surface::Lights::pbr ? kPbrLight : kPbrPositional);
  if (s.recent)
    return text +
           (lit ? kScatteredOften : "  vec3 iblSpecular = vec3(0.0);\n  vec3 iblDiffuse = vec3(0.0);\n") +
           "  vec3 color = (iblDiffuse + iblSpecular) * IBLIntensity;\n  color += Lo;\n"
           "  color = mix(color, color * ao, aoStrengthUniform);\n  color += emissiveColor;\n"
           "  fragOutput0 = vec4(color, opacity);\n"
           "  fragOutput0.rgb = pow(fragOutput0.rgb, vec3(1.0/2.2));\n";
  text += lit ? "  vec3 specularBrdf = F0 * brdf.r + F90 * brdf.g;\n"
                "  vec3 iblSpecular = prefilteredSpecularColor * specularBrdf;\n"
                "  vec3 iblDiffuse = (1.0 - F0) * (1.0 - metallic) * irradiance * albedo;\n"
                "  vec3 color = iblDiffuse + iblSpecular;\n"
              : "  vec3 ambient = vec3(0.0);\n  vec3 color = ambient + Lo;\n";
  if (lit) text += "  color += Lo;\n";
  return text +
         "  color = mix(color, color * ao, aoStrengthUniform);\n  color += emissiveColor;\n"
         "  color = pow(color, vec3(1.0/2.2));\n  fragOutput0 = vec4(color, opacity);\n";
}

}  // namespace gluray::test
