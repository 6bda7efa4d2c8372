// The branches of the shaders of VTK 9.6's and 9.7's vtkOpenGLLowMemoryPolyDataMapper for wide lines, tubes
// and spheres.
#include "tests/support/pulled_solid_text.h"

namespace gluray::test {

// Two triangles for each line, their corners in window coordinates.
const char* const kPulledWideLines = R"(
  tubeBasis1VS = vec3(0.0);
  tubeBasis2VS = vec3(0.0);
  hasTubeBasisVS = 0;
  if (cellType == 3 && primitiveSize == 3)
  {
    if (lineWidth > 1.0)
    {
      vec2 QUAD[6] = vec2[6](
        vec2(0.0, -0.5),
        vec2(0.0, 0.5),
        vec2(1.0, -0.5),
        vec2(1.0, -0.5),
        vec2(0.0, 0.5),
        vec2(1.0, 0.5)
      );
      vec2 pCoord = vec2(0.0, 0.0);
      int quadIdx = (gl_VertexID - vertexIdOffset) % 6;
      if (quadIdx < 0 || quadIdx >= 6) {
        pCoord = vec2(0.0, -0.5);
      } else {
        pCoord = QUAD[quadIdx];
      }
      int p0VertexId = 2 * primitiveId + vertexIdOffset;
      int p1VertexId = p0VertexId + 1;
      int p0PointId = texelFetchBuffer(vertexIdBuffer, p0VertexId).x + pointIdOffset;
      int p1PointId = texelFetchBuffer(vertexIdBuffer, p1VertexId).x + pointIdOffset;
      vec4 p0MC = vec4(FETCH(positions, p0PointId), 1.0);
      vec4 p1MC = vec4(FETCH(positions, p1PointId), 1.0);
      vec4 p0VC = MCVCMatrix * p0MC;
      vec4 p1VC = MCVCMatrix * p1MC;
      vec4 p0_DC = MCDCMatrix * p0MC;
      vec4 p1_DC = MCDCMatrix * p1MC;
      vec2 p0Screen = viewportDimensions.xy + viewportDimensions.zw * (0.5 * p0_DC.xy / p0_DC.w + 0.5);
      vec2 p1Screen = viewportDimensions.xy + viewportDimensions.zw * (0.5 * p1_DC.xy / p1_DC.w + 0.5);
      vec2 dirScreen = p1Screen - p0Screen;
      float dirLen = length(dirScreen);
      vec2 xBasis = dirLen > 1e-6 ? dirScreen / dirLen : vec2(1.0, 0.0);
      vec2 yBasis = vec2(-xBasis.y, xBasis.x);
      float normalLen = length(yBasis);
      vec2 normal2D = normalLen > 1e-6 ? yBasis / normalLen : vec2(0.0, 1.0);
      vec2 p0Offset = p0Screen + pCoord.x * xBasis + pCoord.y * yBasis * lineWidth;
      vec2 p1Offset = p1Screen + pCoord.x * xBasis + pCoord.y * yBasis * lineWidth;
      vec2 p = mix(p0Offset, p1Offset, pCoord.x);
      vec4 p_DC = mix(p0_DC, p1_DC, pCoord.x);
      vec2 ndcPos = ((p - viewportDimensions.xy) / viewportDimensions.zw) * 2.0 - 1.0;
      gl_Position = vec4(p_DC.w * ndcPos, p_DC.z, p_DC.w);
      vertexVCVSOutput = mix(p0VC, p1VC, pCoord.x);
      vec3 lineDirVec = p1VC.xyz - p0VC.xyz;
      float lineDirLen = length(lineDirVec);
      vec3 lineDirVC = lineDirLen > 1e-6 ? lineDirVec / lineDirLen : vec3(0.0, 0.0, 1.0);
      vec3 normalVC = normalize(vec3(normal2D, 0.0));
      vec3 tubeBasis2Tmp = cross(lineDirVC, normalVC);
      float tubeBasis2Len = length(tubeBasis2Tmp);
      if (tubeBasis2Len < 1e-6)
      {
        tubeBasis2Tmp = vec3(0.0, 0.0, 1.0);
        tubeBasis2Len = 1.0;
      }
      tubeBasis2Tmp = tubeBasis2Tmp / tubeBasis2Len;
      if (tubeBasis2Tmp.z < 0.0)
      {
        tubeBasis2Tmp = -tubeBasis2Tmp;
      }
      tubeBasis1VS = vec3(2.0 * pCoord.y * normal2D, 0.0);
      tubeBasis2VS = tubeBasis2Tmp;
      hasTubeBasisVS = 1;
    }
  }
)";

const char* const kPulledDepthWithNormals = R"(
  computedNormalVCVS = normalVCVSInput;
  gl_FragDepth = gl_FragCoord.z;
  if (renderPointsAsSpheres == 1 && primitiveSize == 1)
  {
    if (pointPicking == 1)
    {
      computedNormalVCVS = vec3(0.0, 0.0, 1.0);
      gl_FragDepth = gl_FragCoord.z + ZCalcS * ZCalcR;
      if (cameraParallel == 0)
      {
        float ZCalcQ = (ZCalcR - 1.0);
        gl_FragDepth = (ZCalcS - gl_FragCoord.z) / ZCalcQ + ZCalcS;
      }
    }
    else
    {
      vec2 sphereCoord = vec2(2.0 * gl_PointCoord.x - 1.0, 1.0 - 2.0 * gl_PointCoord.y);
      float len2 = dot(sphereCoord, sphereCoord);
      if (len2 > 1.0)
      {
        discard;
      }
      float lenZ = sqrt(max(0.0, 1.0 - len2));
      computedNormalVCVS = normalize(vec3(sphereCoord, lenZ));
      gl_FragDepth = gl_FragCoord.z + computedNormalVCVS.z * ZCalcS * ZCalcR;
      if (cameraParallel == 0)
      {
        float ZCalcQ = (computedNormalVCVS.z * ZCalcR - 1.0);
        gl_FragDepth = (ZCalcS - gl_FragCoord.z) / ZCalcQ + ZCalcS;
      }
    }
  }
  else if (renderLinesAsTubes == 1 && primitiveSize == 3 && hasTubeBasisVS == 1)
  {
    float len2 = dot(tubeBasis1VS.xy, tubeBasis1VS.xy);
    float lenZ = clamp(sqrt(max(0.0, 1.0 - len2)), 0.0, 1.0);
    float denom = clamp(tubeBasis2VS.z, 0.5, 1.0);
    computedNormalVCVS = normalize(tubeBasis1VS + tubeBasis2VS * lenZ);
    gl_FragDepth = gl_FragCoord.z + lenZ * ZCalcS * ZCalcR / denom;
    if (cameraParallel == 0)
    {
      float ZCalcQ = (lenZ * ZCalcR / denom - 1.0);
      gl_FragDepth = (ZCalcS - gl_FragCoord.z) / ZCalcQ + ZCalcS;
    }
  }
  else
  {
    if (primitiveSize == 1)
    {
      computedNormalVCVS = vec3(0.0, 0.0, 1.0);
    }
    else if (cellType == 3 || primitiveSize == 2)
    {
      computedNormalVCVS = abs(computedNormalVCVS);
    }
    else if (gl_FrontFacing == false)
    {
      computedNormalVCVS = -computedNormalVCVS;
    }
  }
)";

const char* const kPulledDepthWithoutNormals = R"(
  computedNormalVCVS = vec3(0.0, 0.0, 1.0);
  gl_FragDepth = gl_FragCoord.z;
  if (renderPointsAsSpheres == 1 && primitiveSize == 1)
  {
    vec3 sphereNormal = vec3(0.0, 0.0, 1.0);
    if (pointPicking == 1)
    {
      computedNormalVCVS = sphereNormal;
      gl_FragDepth = gl_FragCoord.z + ZCalcS * ZCalcR;
      if (cameraParallel == 0)
      {
        float ZCalcQ = (ZCalcR - 1.0);
        gl_FragDepth = (ZCalcS - gl_FragCoord.z) / ZCalcQ + ZCalcS;
      }
    }
    else
    {
      vec2 sphereCoord = vec2(2.0 * gl_PointCoord.x - 1.0, 1.0 - 2.0 * gl_PointCoord.y);
      float len2 = dot(sphereCoord, sphereCoord);
      if (len2 > 1.0)
      {
        discard;
      }
      float lenZ = sqrt(max(0.0, 1.0 - len2));
      sphereNormal = normalize(vec3(sphereCoord, lenZ));
      computedNormalVCVS = sphereNormal;
      gl_FragDepth = gl_FragCoord.z + sphereNormal.z * ZCalcS * ZCalcR;
      if (cameraParallel == 0)
      {
        float ZCalcQ = (sphereNormal.z * ZCalcR - 1.0);
        gl_FragDepth = (ZCalcS - gl_FragCoord.z) / ZCalcQ + ZCalcS;
      }
    }
  }
  else if (renderLinesAsTubes == 1 && primitiveSize == 3 && hasTubeBasisVS == 1)
  {
    float len2 = dot(tubeBasis1VS.xy, tubeBasis1VS.xy);
    float lenZ = clamp(sqrt(max(0.0, 1.0 - len2)), 0.0, 1.0);
    float denom = clamp(tubeBasis2VS.z, 0.5, 1.0);
    computedNormalVCVS = normalize(tubeBasis1VS + tubeBasis2VS * lenZ);
    gl_FragDepth = gl_FragCoord.z + lenZ * ZCalcS * ZCalcR / denom;
    if (cameraParallel == 0)
    {
      float ZCalcQ = (lenZ * ZCalcR / denom - 1.0);
      gl_FragDepth = (ZCalcS - gl_FragCoord.z) / ZCalcQ + ZCalcS;
    }
  }
)";

const char* const kPulledNormalOfVertices = R"(
  computedNormalVCVS = normalVCVSInput;
  vec3 vertexNormalVCVS = computedNormalVCVS;
  if (renderPointsAsSpheres == 1 && primitiveSize == 1)
  {
    if (pointPicking == 1)
    {
      vertexNormalVCVS = vec3(0.0, 0.0, 1.0);
    }
    else
    {
      vec2 sphereCoord = vec2(2.0 * gl_PointCoord.x - 1.0, 1.0 - 2.0 * gl_PointCoord.y);
      float len2 = dot(sphereCoord, sphereCoord);
      float lenZ = sqrt(max(0.0, 1.0 - len2));
      vertexNormalVCVS = normalize(vec3(sphereCoord, lenZ));
    }
  }
  else if (renderLinesAsTubes == 1 && primitiveSize == 3 && hasTubeBasisVS == 1)
  {
    float len2 = dot(tubeBasis1VS.xy, tubeBasis1VS.xy);
    float lenZ = clamp(sqrt(max(0.0, 1.0 - len2)), 0.0, 1.0);
    vertexNormalVCVS = normalize(tubeBasis1VS + tubeBasis2VS * lenZ);
  }
  else if (primitiveSize == 1)
  {
    vertexNormalVCVS = vec3(0.0, 0.0, 1.0);
  }
  else if (cellType == 3 || primitiveSize == 2)
  {
    vertexNormalVCVS = abs(vertexNormalVCVS);
  }
  else if (gl_FrontFacing == false)
  {
    vertexNormalVCVS = -vertexNormalVCVS;
  }
  computedNormalVCVS = vertexNormalVCVS;
  vec3 normalVCVSOutput = vertexNormalVCVS;
  vec3 normalizedNormalVCVSOutput = normalize(vertexNormalVCVS);
)";

const char* const kPulledNormalOfPrimitives = R"(
  if (renderPointsAsSpheres == 1 && primitiveSize == 1)
  {
    if (pointPicking == 1)
    {
      computedNormalVCVS = vec3(0.0, 0.0, 1.0);
    }
    else
    {
      float xpos = 2.0*gl_PointCoord.x - 1.0;
      float ypos = 1.0 - 2.0*gl_PointCoord.y;
      float lenZ = sqrt(max(0.0, 1.0 - (xpos*xpos + ypos*ypos)));
      computedNormalVCVS = normalize(vec3(2.0*gl_PointCoord.x - 1.0, 1.0 - 2.0*gl_PointCoord.y, lenZ));
    }
  }
  else if (primitiveSize == 1) { computedNormalVCVS = vec3(0.0, 0.0, 1.0); }
  else if (renderLinesAsTubes == 1 && primitiveSize == 3 && hasTubeBasisVS == 1)
  {
    float len2 = dot(tubeBasis1VS.xy, tubeBasis1VS.xy);
    float lenZ = clamp(sqrt(max(0.0, 1.0 - len2)), 0.0, 1.0);
    computedNormalVCVS = normalize(tubeBasis1VS + tubeBasis2VS * lenZ);
  }
  else if (primitiveSize == 2)
  {
    float addOrSubtract = (dot(fdx, fdy) >= 0.0) ? 1.0 : -1.0;
    vec3 lineVec = addOrSubtract*fdy + fdx;
    computedNormalVCVS = normalize(cross(vec3(lineVec.y, -lineVec.x, 0.0), lineVec));
  }
  else
  {
    computedNormalVCVS = normalize(cross(fdx,fdy));
    if (cameraParallel == 1 && computedNormalVCVS.z < 0.0) { computedNormalVCVS = -1.0*computedNormalVCVS; }
    if (cameraParallel == 0 && dot(computedNormalVCVS,vertexVC.xyz) > 0.0) { computedNormalVCVS = -1.0*computedNormalVCVS; }
  }
  vec3 vertexNormalVCVS = computedNormalVCVS;
  vec3 normalVCVSOutput = computedNormalVCVS;
  vec3 normalizedNormalVCVSOutput = normalize(vertexNormalVCVS);
)";

const char* const kPulledRoundEdges = R"(
      if (enable_lights == 1 && renderLinesAsTubes == 1)
      {
        float cdist = min(edist[0], edist[1]);
        vec4 cedge = mix(edgeEqn[0], edgeEqn[1], 0.5 + 0.5 * sign(edist[0] - edist[1]));
        cedge = mix(cedge, edgeEqn[2], 0.5 + 0.5 * sign(cdist - edist[2]));
        float rdist = 2.0 * min(cdist, edist[2]) / (max(edgeWidth, 1e-3) + 0.15);
        float lenZ = clamp(sqrt(max(0.0, 1.0 - rdist * rdist)), 0.0, 1.0);
        float tubeLambert = 0.3 + 0.7 * lenZ;
        vec3 tubeDiffuse = intensity_diffuse * edgeColor * tubeLambert;
        vec3 tubeAmbient = intensity_ambient * edgeColor;
        diffuseColor = mix(diffuseColor, tubeDiffuse, emix * edgeOpacity);
        ambientColor = mix(ambientColor, tubeAmbient, emix * edgeOpacity);
      }
)";

const char* const kPulledTubesAreLit = R"(
  if (vtkEnableLights == 0 && renderLinesAsTubes == 1 && primitiveSize == 3 && hasTubeBasisVS == 1)
  {
    vtkEnableLights = 1;
  }
)";

}  // namespace gluray::test
