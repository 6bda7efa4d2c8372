// The pieces of the vertex shaders of VTK 9.6's and 9.7's vtkOpenGLLowMemoryPolyDataMapper.
#include "tests/support/pulled_solid_text.h"
#include "tests/support/pulled_text.h"
#include "tests/support/replaced_text.h"

namespace gluray::test {
namespace {

const char* const kVertexStart = R"(#version 150
#define highp
#define mediump
#define lowp
#define texelFetchBuffer texelFetch
uniform highp samplerBuffer positions;
uniform highp isamplerBuffer vertexIdBuffer;
uniform highp isamplerBuffer primitiveToCellBuffer;
uniform lowp usamplerBuffer edgeValueBuffer;
uniform highp int cellIdOffset, vertexIdOffset, edgeValueBufferOffset, pointIdOffset, primitiveIdOffset;
uniform highp int useIndexedPointId, primitiveSize, usesEdgeValues, usesCellMap, cellType;
uniform mat4 MCDCMatrix;
uniform mat4 MCVCMatrix;
uniform mat3 normalMatrix;
uniform highp int wireframe;
uniform float edgeWidth;
uniform highp int edgeVisibility;
uniform float pointSize;
uniform vec4 viewportDimensions;
uniform float lineWidth;
smooth out vec4 vertexVCVSOutput;
flat out mat4 edgeEqn;
out vec3 tubeBasis1VS;
out vec3 tubeBasis2VS;
flat out int hasTubeBasisVS;
)";

const char* const kFetchTuple = R"(
vec3 fetchTuple3(samplerBuffer s, int id)
{
  int base = id * 3;
  return vec3(texelFetchBuffer(s, base).x, texelFetchBuffer(s, base + 1).x, texelFetchBuffer(s, base + 2).x);
}
)";

const char* const kIds = R"(
void main()
{
  int pointId = 0;
  int primitiveId = 0;
  int cellId = 0;
  int vertexId = 0;
  if (cellType == 1)
  {
    vertexId = gl_VertexID - vertexIdOffset;
    primitiveId = vertexId;
    POINT
  }
  else if (cellType == 3)
  {
    if (primitiveSize == 3)
    {
      WIDE
    }
    else
    {
      vertexId = gl_VertexID - vertexIdOffset;
      POINT
      THIN
    }
    EACH
  }
  else if (cellType == 5) // triangles
  {
    vertexId = gl_VertexID - vertexIdOffset;
    POINT
    primitiveId = vertexId / 3;
  }
  cellId = primitiveId + cellIdOffset;
  if (usesCellMap == 1)
  {
    cellId = texelFetchBuffer(primitiveToCellBuffer, primitiveId + primitiveIdOffset).x + cellIdOffset;
  }
  vec4 vertexMC = vec4(FETCH(positions, pointId), 1.0);
  gl_PointSize = pointSize;
)";

const char* const kPointOfIndices = R"(if (useIndexedPointId == 1)
    {
      pointId = gl_VertexID + pointIdOffset;
    }
    else
    {
      pointId = texelFetchBuffer(vertexIdBuffer, gl_VertexID).x + pointIdOffset;
    })";

const char* const kEndOfLine = R"(primitiveId = (gl_VertexID - vertexIdOffset) / 6;
      int quadCorner = (gl_VertexID - vertexIdOffset) % 6;
      int endpointSide = (quadCorner == 2 || quadCorner == 3 || quadCorner == 5) ? 1 : 0;
      vertexId = 2 * primitiveId + endpointSide;
      pointId = texelFetchBuffer(vertexIdBuffer, vertexId + vertexIdOffset).x + pointIdOffset;)";

/// The computation of ids; up to VTK 9.6 (not `scalars`) wide lines read point 0.
std::string idText(bool scalars) {
  const char* const walked = "pointId = texelFetchBuffer(vertexIdBuffer, gl_VertexID).x + pointIdOffset;";
  const char* const line = "primitiveId = vertexId >> 1;";
  std::string text = replacedInAll(kIds, "POINT", scalars ? kPointOfIndices : walked);
  text = replacedInAll(text, "WIDE", scalars ? kEndOfLine : "vertexId = (gl_VertexID - vertexIdOffset) / 3;");
  text = replacedInAll(text, "THIN", scalars ? line : "");
  return replacedInAll(text, "EACH", scalars ? "" : line);
}

const char* const kEdgeEquations = R"(
  if ((((edgeVisibility == 1) || (wireframe == 1)) && (cellType == 5)) && (vertexId % 3 == 2))
  {
    int p0 = texelFetchBuffer(vertexIdBuffer, gl_VertexID - 2).x + pointIdOffset;
    int p1 = texelFetchBuffer(vertexIdBuffer, gl_VertexID - 1).x + pointIdOffset;
    vec4 p0MC = vec4(FETCH(positions, p0), 1.0);
    vec4 p1MC = vec4(FETCH(positions, p1), 1.0);
    vec4 p0DC = MCDCMatrix * p0MC;
    vec4 p1DC = MCDCMatrix * p1MC;
    vec2 pos[4];
    pos[0] = p0DC.xy/p0DC.w;
    pos[1] = p1DC.xy/p1DC.w;
    pos[2] = gl_Position.xy/gl_Position.w;
    for(int i = 0; i < 3; ++i)
    {
      pos[i] = viewportDimensions.xy + viewportDimensions.zw * (pos[i]*vec2(0.5) + vec2(0.5));
    }
    pos[3] = pos[0];
    float ccw = sign(cross(vec3(pos[1] - pos[0], 0.0), vec3(pos[2] - pos[0], 0.0)).z);
    for (int i = 0; i < 3; i++)
    {
      vec2 tmp = normalize(pos[i+1] - pos[i]);
      tmp = ccw*vec2(-tmp.y, tmp.x);
      float d = dot(pos[i], tmp);
      edgeEqn[i] = vec4(tmp.x, tmp.y, 0.0, -d);
    }
    if (usesEdgeValues == 1)
    {
      float nudge = edgeWidth + 0.5;
      int edgeValue = int(texelFetchBuffer(edgeValueBuffer, primitiveId + edgeValueBufferOffset).x);
      if (edgeValue < 4) edgeEqn[2].z = nudge;
      if ((edgeValue % 4) < 2) edgeEqn[1].z = nudge;
      if ((edgeValue % 2) < 1) edgeEqn[0].z = nudge;
    }
  }
}
)";

const char* fetchOf(const PulledSurface& s) { return s.scalars ? "fetchTuple3(" : "texelFetchBuffer("; }

/// The text with its fetches of three floats.
std::string withFetches(const PulledSurface& s, std::string text) {
  if (!s.scalars) {
    for (const char* const index :
         {"positions, pointId)", "positions, p0)", "positions, p1)", "positions, p0PointId)",
          "positions, p1PointId)", "pointNormals, pointId)", "cellNormals, cellId)"})
      text = replacedInAll(text, std::string("FETCH(") + index, std::string("FETCH(") + index + ".xyz");
  }
  return replacedInAll(text, "FETCH(", fetchOf(s));
}

}  // namespace

std::string pulledVertexText(const PulledSurface& s) {
  std::string text = kVertexStart;
  if (s.normals == PulledNormals::points) text += "uniform highp samplerBuffer pointNormals;\n";
  if (s.normals == PulledNormals::cells) text += "uniform highp samplerBuffer cellNormals;\n";
  if (s.normals != PulledNormals::none) text += "out vec3 normalVCVSInput;\n";
  if (s.color == PulledColor::points || s.color == PulledColor::cells)
    text += "uniform lowp usamplerBuffer colors;\nout vec4 vertexColorVS;\n";
  if (s.color == PulledColor::mapped)
    text += "uniform highp samplerBuffer colorTCoords;\nout vec2 colorTCoordVCVSOutput;\n";
  if (s.textured) text += "uniform highp samplerBuffer tcoords;\nout vec2 tcoordVCVSOutput;\n";
  if (s.clipPlanes)
    text += "uniform vec4 clipPlanes[6];\nuniform int numClipPlanes;\nout float clipDistancesVSOutput[6];\n";
  if (s.scalars) text += kFetchTuple;
  text += idText(s.scalars);
  const std::string colored =
      "  vertexColorVS = vec4(texelFetchBuffer(colors, colorID)) / vec4(255.0, 255.0, 255.0, 255.0);\n";
  if (s.color == PulledColor::points) text += "  int colorID = pointId;\n" + colored;
  if (s.color == PulledColor::cells) text += "  int colorID = cellId;\n" + colored;
  if (s.normals == PulledNormals::points) text += "  vec3 normalMC = FETCH(pointNormals, pointId);\n";
  if (s.normals == PulledNormals::cells) text += "  vec3 normalMC = FETCH(cellNormals, cellId);\n";
  if (s.normals != PulledNormals::none) text += "  normalVCVSInput = normalize(normalMatrix * normalMC);\n";
  if (s.color == PulledColor::mapped)
    text +=
        "  vec2 colorTCoord = texelFetchBuffer(colorTCoords, pointId).st;\n"
        "  colorTCoordVCVSOutput = colorTCoord;\n";
  if (s.textured)
    text += "  vec2 tcoord = texelFetchBuffer(tcoords, pointId).st;\n  tcoordVCVSOutput = tcoord;\n";
  if (s.clipPlanes)
    text +=
        "  for (int planeNum = 0; planeNum < numClipPlanes; planeNum++)\n  {\n"
        "    clipDistancesVSOutput[planeNum] = dot(clipPlanes[planeNum], vertexMC);\n  }\n";
  text += "  vertexVCVSOutput = MCVCMatrix * vertexMC;\n  gl_Position = MCDCMatrix * vertexMC;\n";
  return withFetches(s, text + kPulledWideLines + kEdgeEquations);
}

}  // namespace gluray::test
