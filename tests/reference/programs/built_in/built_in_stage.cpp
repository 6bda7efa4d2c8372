#include "tests/reference/programs/built_in/built_in_stage.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace gluray::test {

std::string nameOf(Way way) {
  switch (way) {
    case Way::clientArrays: return "client_arrays";
    case Way::clientElements: return "client_elements";
    case Way::buffers: return "buffers";
    case Way::immediate: return "immediate";
    case Way::list: return "list";
  }
  return "";
}

namespace {

const std::string kBuiltInHead = "varying vec3 normal;\nvoid main() {\n";
const std::string kBuiltInColors =
    "  gl_FrontColor = gl_Color;\n  gl_BackColor = gl_Color;\n  gl_Position = ftransform();\n}\n";
const std::string kEyeNormalVertex =
    kBuiltInHead + "  normal = normalize(gl_NormalMatrix * gl_Normal);\n" + kBuiltInColors;
const std::string kNormalFragment =
    kBuiltInHead +
    "  vec4 color = gl_Color;\n  color.x = (normal.x + 1.0) * 0.5;\n  color.y = (normal.y + 1.0) * 0.5;\n"
    "  color.z = (normal.z + 1.0) * 0.5;\n  gl_FragColor = color;\n}\n";

}  // namespace

const ShaderPair kShaded = {
    kEyeNormalVertex,
    kBuiltInHead +
        "  float p = dot(normal, normalize(vec3(1.0, -1.0, -1.0)));\n  p = p < 0. ? 0. : p * 0.8;\n"
        "  vec4 color = gl_Color;\n  color.x = color.x * (0.2 + p);\n  color.y = color.y * (0.2 + p);\n"
        "  color.z = color.z * (0.2 + p);\n  gl_FragColor = color;\n}\n"};
const ShaderPair kViewNormalColor = {kEyeNormalVertex, kNormalFragment};
const ShaderPair kNormalColor = {kBuiltInHead + "  normal = normalize(gl_Normal);\n" + kBuiltInColors,
                                 kNormalFragment};

const ShaderPair kEdgeHilight = {
    kEyeNormalVertex,
    kBuiltInHead +
        "  vec4 color = gl_Color;\n  float s = pow(normal.x*normal.x + normal.y*normal.y, 2.0);\n"
        "  color.x = color.x + s * (1.0-color.x);\n  color.y = color.y + s * (1.0-color.y);\n"
        "  color.z = color.z + s * (1.0-color.z);\n  gl_FragColor = color;\n}\n"};

const ShaderPair kBalloon = {
    kEyeNormalVertex,
    kBuiltInHead +
        "  vec4 color = gl_Color;\n  color.w = min(color.w + 2.0 * color.w * pow(normal.x*normal.x + "
        "normal.y*normal.y, 5.0), 1.0);\n  gl_FragColor = color;\n}\n"};

namespace {

std::string heightChannel(const std::string& c, int first) {
  const auto at = [&](int i) { return "colorMap[" + std::to_string(first + i) + "]"; };
  const std::string v = "color." + c;
  return "  " + v + " = " + at(0) + " * (pos.z + " + at(1) + ");\n  if (" + at(2) + " != 1.0)\n    " + v +
         " = pow(" + v + ", " + at(2) + ");\n  " + v + " = " + v + " < 0. ? 0. : (" + v +
         " > 1. ? 1. : " + v + ");\n";
}

}  // namespace

const ShaderPair kHeightColor = {
    "varying vec4 pos;\nvoid main() {\n  gl_FrontColor = gl_Color;\n  gl_BackColor = gl_Color;\n"
    "  pos = gl_Vertex;\n  gl_Position = ftransform();\n}\n",
    "uniform float colorMap[9];\nvarying vec4 pos;\nvoid main() {\n  vec4 color = gl_Color;\n" +
        heightChannel("x", 0) + heightChannel("y", 3) + heightChannel("z", 6) +
        "  color.w = 1.0;\n  gl_FragColor = color;\n}\n"};

const ShaderPair kOpenCtm = {
    "varying vec3 vNormal;\nvarying vec3 vPos;\nvarying vec4 vColor;\nvoid main()\n{\n"
    "  vNormal = normalize(gl_NormalMatrix * gl_Normal);\n  vPos = vec3(gl_ModelViewMatrix * gl_Vertex);\n"
    "  vColor = gl_Color;\n  gl_TexCoord[0] = gl_TextureMatrix[0] * gl_MultiTexCoord0;\n"
    "  gl_Position = ftransform();\n}\n",
    "uniform bool uUseTexture;\nuniform sampler2D uTex;\nvarying vec3 vNormal;\nvarying vec3 vPos;\n"
    "varying vec4 vColor;\nvoid main()\n{\n  vec3 n = normalize(vNormal);\n  vec4 color = vColor;\n"
    "  if(uUseTexture)\n    color *= texture2D(uTex, gl_TexCoord[0].st);\n"
    "  vec4 ambient = color * gl_LightModel.ambient;\n"
    "  vec3 lightDir = normalize(gl_LightSource[0].position.xyz - vPos);\n"
    "  float NdotL = abs(dot(n, lightDir));\n"
    "  vec4 diffuse = color * gl_LightSource[0].diffuse * NdotL;\n"
    "  vec3 rVector = normalize(2.0 * n * dot(n, lightDir) - lightDir);\n"
    "  vec3 viewVector = normalize(-vPos);\n  float RdotV = dot(rVector, viewVector);\n"
    "  vec4 specular = vec4(0.0);\n  if(RdotV > 0.0)\n"
    "    specular = vec4(0.4, 0.4, 0.4, 1.0) * gl_LightSource[0].specular * pow(RdotV, 20.0);\n"
    "  gl_FragColor = ambient + diffuse + specular;\n}\n"};

void beginBuiltInFrame(Gl gl, double degrees) {
  gl.Viewport(0, 0, kProgramWidth, kProgramHeight);
  gl.ClearColor(0.2f, 0.25f, 0.3f, 1);
  gl.Enable(GL_DEPTH_TEST);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const View view = perspectiveView(degrees);
  gl.MatrixMode(GL_PROJECTION), gl.LoadMatrixd(glm::value_ptr(view.clipFromEye));
  gl.MatrixMode(GL_MODELVIEW), gl.LoadIdentity();
  const GLfloat places[2][4] = {{2, 3, -1, 1}, {-1, 0.5f, 0.3f, 0}}, white[] = {0.9f, 0.8f, 0.7f, 1},
                blue[] = {0.2f, 0.3f, 0.6f, 1}, dim[] = {0.1f, 0.05f, 0.15f, 1};
  for (GLenum i = 0; i < 2; ++i) {
    gl.Lightfv(GL_LIGHT0 + i, GL_POSITION, places[i]);
    gl.Lightfv(GL_LIGHT0 + i, GL_DIFFUSE, i ? blue : white);
    gl.Lightfv(GL_LIGHT0 + i, GL_SPECULAR, i ? white : blue);
    gl.Lightfv(GL_LIGHT0 + i, GL_AMBIENT, dim);
  }
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, dim);
  const GLfloat ambient[] = {0.3f, 0.4f, 0.2f, 1}, diffuse[] = {0.7f, 0.3f, 0.5f, 1};
  gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT, ambient);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, diffuse);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_EMISSION, dim);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 12);
  gl.LoadMatrixd(glm::value_ptr(glm::scale(view.eyeFromObject, {1.2, 0.9, 1})));
}

namespace {

void sendImmediately(Gl gl, const ProgramMesh& mesh, bool colors) {
  gl.Begin(GL_TRIANGLES);
  for (const GLuint i : mesh.indices) {
    if (colors) gl.Color4ubv(reinterpret_cast<const GLubyte*>(&mesh.colors[i]));
    gl.Normal3fv(glm::value_ptr(mesh.normals[i]));
    if (!mesh.texcoords.empty()) gl.TexCoord2fv(glm::value_ptr(mesh.texcoords[i]));
    gl.Vertex3fv(glm::value_ptr(mesh.positions[i]));
  }
  gl.End();
}

/// Pointers to the mesh's vectors, or into a buffer that has them one behind the other.
void setFixedPointers(Gl gl, const ProgramMesh& mesh, bool colors, bool buffered) {
  std::vector<std::byte> all;
  const auto place = [&](const auto& values) -> const void* {
    const auto* bytes = reinterpret_cast<const std::byte*>(values.data());
    if (!buffered) return bytes;
    const size_t offset = all.size();
    all.insert(all.end(), bytes, bytes + values.size() * sizeof(values[0]));
    return reinterpret_cast<const void*>(offset);
  };
  const void *positions = place(mesh.positions), *normals = place(mesh.normals), *paints = place(mesh.colors),
             *texcoords = place(mesh.texcoords);
  if (buffered) {
    GLuint name = 0;
    gl.GenBuffers(1, &name), gl.BindBuffer(GL_ARRAY_BUFFER, name);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(all.size()), all.data(), GL_STATIC_DRAW);
  }
  gl.VertexPointer(3, GL_FLOAT, 0, positions), gl.NormalPointer(GL_FLOAT, 0, normals);
  gl.EnableClientState(GL_VERTEX_ARRAY), gl.EnableClientState(GL_NORMAL_ARRAY);
  if (!mesh.texcoords.empty())
    gl.TexCoordPointer(2, GL_FLOAT, 0, texcoords), gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
  if (!colors) return;
  gl.ColorPointer(4, GL_UNSIGNED_BYTE, 0, paints);
  gl.EnableClientState(GL_COLOR_ARRAY);
}

/// The same triangles without indices.
ProgramMesh unindexed(const ProgramMesh& mesh) {
  ProgramMesh all;
  for (const GLuint i : mesh.indices) {
    all.positions.push_back(mesh.positions[i]), all.normals.push_back(mesh.normals[i]);
    all.colors.push_back(mesh.colors[i]);
    if (!mesh.texcoords.empty()) all.texcoords.push_back(mesh.texcoords[i]);
  }
  return all;
}

}  // namespace

void sendMesh(Gl gl, const ProgramMesh& mesh, Way way, bool colors) {
  if (way == Way::immediate) return sendImmediately(gl, mesh, colors);
  if (way == Way::list) {
    const GLuint list = gl.GenLists(1);
    gl.NewList(list, GL_COMPILE);
    sendImmediately(gl, mesh, colors);
    gl.EndList();
    return gl.CallList(list);
  }
  const ProgramMesh plain = way == Way::clientArrays ? unindexed(mesh) : mesh;
  setFixedPointers(gl, plain, colors, way == Way::buffers);
  if (way == Way::clientArrays)
    gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(plain.positions.size()));
  else
    gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, mesh.indices.data());
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY})
    gl.DisableClientState(array);
  if (way == Way::buffers) gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl.VertexPointer(3, GL_FLOAT, 0, nullptr), gl.NormalPointer(GL_FLOAT, 0, nullptr);
  gl.ColorPointer(4, GL_UNSIGNED_BYTE, 0, nullptr), gl.TexCoordPointer(2, GL_FLOAT, 0, nullptr);
}

}  // namespace gluray::test
