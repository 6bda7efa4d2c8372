#include "tests/support/edges_text.h"

#include "tests/support/replaced_text.h"

#include <utility>

namespace gluray::test {

std::string edgeDeclarations() {
  return "noperspective in vec4 edgeEqn[3];\nuniform float lineWidth;\nuniform vec3 edgeColor;\n"
         "uniform float edgeOpacity;\n";
}

std::string edgePainting() {
  return "  float edist[3];\n"
         "  edist[0] = dot(edgeEqn[0].xy, gl_FragCoord.xy) + edgeEqn[0].w;\n"
         "  edist[1] = dot(edgeEqn[1].xy, gl_FragCoord.xy) + edgeEqn[1].w;\n"
         "  edist[2] = dot(edgeEqn[2].xy, gl_FragCoord.xy) + edgeEqn[2].w;\n"
         "  if (edist[0] < -0.5 && edgeEqn[0].z > 0.0) discard;\n"
         "  if (edist[1] < -0.5 && edgeEqn[1].z > 0.0) discard;\n"
         "  if (edist[2] < -0.5 && edgeEqn[2].z > 0.0) discard;\n"
         "  edist[0] += edgeEqn[0].z;\n  edist[1] += edgeEqn[1].z;\n  edist[2] += edgeEqn[2].z;\n"
         "  float emix = clamp(0.5 + 0.5*lineWidth - min( min( edist[0], edist[1]), edist[2]), 0.0, 1.0);\n"
         "  diffuseColor = mix(diffuseColor, vec3(0.0), emix * edgeOpacity);\n"
         "  ambientColor = mix( ambientColor, edgeColor, emix * edgeOpacity);\n";
}

std::string afterGeometry(std::string text) {
  return replacedInAll(std::move(text), "VCVSOutput", "VCGSOutput");
}

std::string geometryText(const Surface& s) {
  if (!s.edges) return "";
  const bool normals = s.normals == Surface::Normals::vertex;
  return s.version + "in vec4 vertexVCVSOutput[];\nout vec4 vertexVCGSOutput;\n" +
         (normals ? "in vec3 normalVCVSOutput[];\nout vec3 normalVCGSOutput;\n" : "") +
         "layout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\n"
         "uniform vec4 vpDims;\nnoperspective out vec4 edgeEqn[3];\n"
         "void main()\n{\n  vec2 pos[4];\n  for (int i = 0; i < 3; i++)\n  {\n"
         "    pos[i] = gl_in[i].gl_Position.xy/gl_in[i].gl_Position.w;\n"
         "    pos[i] = pos[i]*vec2(0.5) + vec2(0.5);\n    pos[i] = pos[i]*vpDims.zw + vpDims.xy;\n  }\n"
         "  pos[3] = pos[0];\n"
         "  float ccw = sign(cross(vec3(pos[1] - pos[0], 0.0), vec3(pos[2] - pos[0], 0.0)).z);\n"
         "  for (int i = 0; i < 3; i++)\n  {\n    vec2 tmp = normalize(pos[i+1] - pos[i]);\n"
         "    tmp = ccw*vec2(-tmp.y, tmp.x);\n    float d = dot(pos[i], tmp);\n"
         "    edgeEqn[i] = vec4(tmp.x, tmp.y, 0.0, -d);\n  }\n"
         "  for (int i = 0; i < 3; i++)\n    {\n    gl_PrimitiveID = gl_PrimitiveIDIn;\n" +
         (normals ? "    normalVCGSOutput = normalVCVSOutput[i];\n" : "") +
         "    vertexVCGSOutput = vertexVCVSOutput[i];\n    gl_Position = gl_in[i].gl_Position;\n"
         "    EmitVertex();\n    }\n  EndPrimitive();\n}\n";
}

}  // namespace gluray::test
