// Statements of the tests' programs that differ from VTK's text but compute the same: VTK's families must
// know them, too.
#pragma once
#include "gl/families/family.h"

#include <memory>

namespace gluray::test {

inline constexpr const char* kImitatedCode = R"toml(
[[code]]
name = "VTK"
statements = '''
fragOutput0 = fragOutput0 * vec4(texture(actortexture, tcoordVCVSOutput).rgb, 1.0);
vec4 texColor = vertexColorVSOutput;
vec4 texColor = texelFetch(textureC, gl_PrimitiveID + PrimitiveIDOffset);
for (int planeNum = 0; planeNum < numClipPlanes; planeNum++)
  clipDistancesVSOutput[planeNum] = dot(clipPlanes[planeNum], vertexMC);
for (int planeNum = 0; planeNum < numClipPlanes; planeNum++)
  if (clipDistancesVSOutput[planeNum] < 0.0) discard;
'''
blocks = '''
vec3 normalVCVSOutput = texelFetch(textureN, gl_PrimitiveID + PrimitiveIDOffset).xyz;
normalVCVSOutput = normalize(normalMatrix * normalVCVSOutput);
if (gl_FrontFacing == false) { normalVCVSOutput = -normalVCVSOutput; }
'''
[[code]]
name = "VTK physically based"
statements = '''
vec3 ambient = vec3(0.0);
'''
blocks = '''
vec3 color = ambient + Lo;
color = mix(color, color * ao, aoStrengthUniform);
color += emissiveColor;
color = pow(color, vec3(1.0/2.2));
fragOutput0 = vec4(color, opacity);
'''
[[code]]
name = "VTK anti-aliasing"
statements = '''
tc = texCoordIn;
if (EndpointSearchIterations < 0 || InvTexSize.x < 0.0) discard;
gl_FragColor = vec4(1.0 - texture2D(Input, tc).rgb, 1.0);
'''
)toml";

/// The built-in families, which also know the tests' code.
inline std::shared_ptr<const gl::FamilyList> familiesOfTests() {
  static const auto families = [] {
    auto all = std::make_shared<gl::FamilyList>(gl::parseFamilies(kImitatedCode, "imitated_code.h"));
    all->append(gl::builtInFamilies());
    return all;
  }();
  return families;
}

}  // namespace gluray::test
