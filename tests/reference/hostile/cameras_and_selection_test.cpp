// Twenty habits of real programs that break a naive interceptor. Habits 9 to 13: cameras, flushes, selection,
// materials, arrays.
#include "tests/reference/hostile/habits.h"

#include <array>
#include <cmath>
#include <vector>

namespace gluray::test::twenty_points {
namespace {

TEST(TwentyPoints, P09SeveralCamerasViewportsAndDepthRanges) {
  const gl::Statistics s = expectSame([](Gl gl, Seen&) {
    stage(gl);
    gl.DepthRange(0.1, 1);
    send(gl, sphere(16, 24));
    gl.Viewport(0, 0, 60, 60);  // axis cross
    gl.DepthRange(0, 0.1);
    flatCamera(gl, 60, 60, 1.2);
    gl.Rotatef(35, 1, 1, 0);
    sendAt(gl, vase(16, 12), 0, 0, 0, 0.8f);
    gl.Viewport(kWidth - 50, kHeight - 50, 50, 50);  // navigation cube
    gl.DepthRange(0.05, 0.5);
    camera(gl, 50, 50, 3);
    send(gl, torus(0.7f, 0.3f, 20, 12));
  });
  EXPECT_EQ(s.drawsTraced, 3u);
}

TEST(TwentyPoints, P10FlushMeansNothing) {
  const gl::Statistics s = expectSame([](Gl gl, Seen&) {
    const GLuint canvas = [&] {  // a framebuffer that is never shown
      GLuint names[3];
      gl.GenFramebuffers(1, names);
      gl.GenRenderbuffers(2, names + 1);
      gl.BindFramebuffer(GL_FRAMEBUFFER, names[0]);
      const GLenum formats[] = {GL_RGBA8, GL_DEPTH_COMPONENT24},
                   places[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
      for (int i = 0; i < 2; ++i) {
        gl.BindRenderbuffer(GL_RENDERBUFFER, names[i + 1]);
        gl.RenderbufferStorage(GL_RENDERBUFFER, formats[i], kWidth, kHeight);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, places[i], GL_RENDERBUFFER, names[i + 1]);
      }
      return names[0];
    }();
    stage(gl);
    const Model m = sphere(8, 12);
    for (int i = 0; i < 60; ++i) {
      sendAt(gl, m, -1.2f + 0.04f * static_cast<float>(i), 0, 0, 0.2f);
      gl.Flush();
    }
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, canvas);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl.BlitFramebuffer(0, 0, kWidth, kHeight, 0, 0, kWidth, kHeight,
                       GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  });
  EXPECT_EQ(s.drawsTraced, 60u);
  EXPECT_LE(s.flushes, 2u) << "every glFlush was taken for the end of a frame";
}

TEST(TwentyPoints, P11SelectionAndFeedbackComeFromTheRealOne) {
  const gl::Statistics s = expectSame([](Gl gl, Seen& seen) {
    stage(gl);
    const auto draw = [&] {
      gl.InitNames();
      gl.PushName(0);
      for (GLuint name = 1; name <= 4; ++name) {
        gl.LoadName(name);
        sendAt(gl, sphere(8, 12), -1.2f + 0.6f * static_cast<float>(name), 0, 0.3f * static_cast<float>(name),
               0.3f);
      }
    };
    draw();
    std::array<GLuint, 64> hits{};
    gl.SelectBuffer(static_cast<GLsizei>(hits.size()), hits.data());
    gl.RenderMode(GL_SELECT);
    draw();
    const GLint count = gl.RenderMode(GL_RENDER);
    seen.push_back(static_cast<float>(count));
    for (int i = 0; i < count; ++i) {
      seen.push_back(static_cast<float>(hits[static_cast<size_t>(4 * i)]));      // names of the hit
      seen.push_back(static_cast<float>(hits[static_cast<size_t>(4 * i + 3)]));  // the name
    }
    std::vector<GLfloat> feedback(20000);
    gl.FeedbackBuffer(static_cast<GLsizei>(feedback.size()), GL_3D, feedback.data());
    gl.RenderMode(GL_FEEDBACK);
    draw();
    seen.push_back(static_cast<float>(gl.RenderMode(GL_RENDER)));
    seen.insert(seen.end(), feedback.begin(), feedback.begin() + 100);
    sendAt(gl, torus(0.5f, 0.2f, 16, 8), 0, 0.6f, 0, 1);
  });
  EXPECT_EQ(s.drawsTraced, 5u);
}

TEST(TwentyPoints, P12MaterialsPerVertexAndSidesThatToggle) {
  expectSame([](Gl gl, Seen& seen) {
    stage(gl);
    const Model m = scenes::sheet(10);
    for (int pass = 0; pass < 12; ++pass) {
      gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, pass % 2);
      gl.PushMatrix();
      gl.Translatef(-1.1f + 0.2f * static_cast<float>(pass), 0.1f * static_cast<float>(pass % 3), 0);
      gl.Rotatef(30.0f * static_cast<float>(pass), 0, 1, 0);
      gl.Scalef(0.25f, 0.4f, 0.3f);
      gl.Begin(GL_TRIANGLES);
      for (size_t i = 0; i < m.indices.size(); ++i) {
        const uint32_t v = m.indices[i];
        const float t = static_cast<float>(i % 7) / 7;
        // For both faces: Mesa 22.3 lights backs with green and blue of the front if materials change
        // inside glBegin.
        const GLfloat color[] = {t, 1 - t, 0.3f, 1};
        gl.Materialfv(GL_FRONT_AND_BACK, i % 2 ? GL_DIFFUSE : GL_AMBIENT_AND_DIFFUSE, color);
        gl.Normal3fv(&m.normals[3 * v]);
        gl.Vertex3fv(&m.positions[3 * v]);
      }
      gl.End();
      gl.PopMatrix();
    }
    GLfloat left[4];
    gl.GetMaterialfv(GL_FRONT, GL_DIFFUSE, left);
    seen.assign(left, left + 4);
    for (const GLenum mode : {GL_DIFFUSE, GL_AMBIENT_AND_DIFFUSE, GL_EMISSION, GL_SPECULAR}) {
      gl.ColorMaterial(GL_FRONT_AND_BACK, mode);
      gl.Enable(GL_COLOR_MATERIAL);
      sendAt(gl, sphere(8, 12), -0.9f + 0.001f * static_cast<float>(mode - GL_AMBIENT), 0.8f, 0, 0.2f,
             kNormals | kColors);
      gl.Disable(GL_COLOR_MATERIAL);
    }
  });
}

TEST(TwentyPoints, P13PointersLatchTheirBufferAndListsReadAtOnce) {
  const gl::Statistics s = expectSame([](Gl gl, Seen&) {
    stage(gl);
    gl.Enable(GL_NORMALIZE);
    const Model m = sphere(10, 16);
    std::vector<GLdouble> positions(m.positions.begin(), m.positions.end());
    std::vector<GLbyte> normals;
    std::vector<GLubyte> colors;
    std::vector<GLushort> indices(m.indices.begin(), m.indices.end());
    for (size_t v = 0; v < m.vertexCount(); ++v) {
      for (size_t c = 0; c < 3; ++c) normals.push_back(static_cast<GLbyte>(127 * m.normals[3 * v + c]));
      normals.push_back(0);  // stride 4
      for (const int shift : {5, 3, 1}) colors.push_back(static_cast<GLubyte>(v << shift & 255));
    }
    GLuint buffers[2];
    gl.GenBuffers(2, buffers);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(positions.size() * sizeof(GLdouble)),
                  positions.data(), GL_STATIC_DRAW);
    gl.VertexPointer(3, GL_DOUBLE, 0, nullptr);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffers[1]);  // the pointer keeps the first
    gl.BufferData(GL_ARRAY_BUFFER, 4, nullptr, GL_STATIC_DRAW);
    gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    gl.NormalPointer(GL_BYTE, 4, normals.data());
    gl.ColorPointer(3, GL_UNSIGNED_BYTE, 0, colors.data());
    gl.Enable(GL_COLOR_MATERIAL);
    for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY}) gl.EnableClientState(array);
    const auto draw = [&] {
      gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_SHORT, indices.data());
    };
    const GLuint list = gl.GenLists(1);
    gl.NewList(list, GL_COMPILE);
    draw();
    gl.EndList();
    for (GLubyte& c : colors) c = static_cast<GLubyte>(255 - c);
    std::fill(indices.begin(), indices.end(), GLushort{0});  // the list has read them already
    gl.CallList(list);
    indices.assign(m.indices.begin(), m.indices.end());
    gl.Translatef(0.9f, 0, 0.5f), gl.Scalef(0.5f, 0.5f, 0.5f);
    draw();
  });
  EXPECT_EQ(s.trianglesRasterised, 0u);
}

TEST(TwentyPoints, P13ArraysRewrittenBetweenDrawsOfOneList) {
  expectSame([](Gl gl, Seen&) {
    stage(gl);
    gl.Enable(GL_NORMALIZE);
    std::array<GLfloat, 14 * 10> tube;  // position, normal, colour: stride 40, as one program has it
    gl.InterleavedArrays(GL_V3F, 40, tube.data());
    gl.EnableClientState(GL_NORMAL_ARRAY), gl.NormalPointer(GL_FLOAT, 40, tube.data() + 3);
    gl.EnableClientState(GL_COLOR_ARRAY), gl.ColorPointer(4, GL_FLOAT, 40, tube.data() + 6);
    gl.Enable(GL_COLOR_MATERIAL);
    GLuint order[14];
    for (GLuint i = 0; i < 14; ++i) order[i] = i;
    const GLuint list = gl.GenLists(1);
    gl.NewList(list, GL_COMPILE);
    for (int segment = 0; segment < 60; ++segment) {
      for (int i = 0; i < 14; ++i) {
        const float along = static_cast<float>(segment + i % 2) * 0.1f,
                    around = 1.0472f * static_cast<float>(i / 2);
        const float values[] = {std::cos(along) + 0.1f * std::cos(around) * std::cos(along),
                                -0.8f + 0.27f * along + 0.1f * std::sin(around),
                                std::sin(along) + 0.1f * std::cos(around) * std::sin(along),
                                std::cos(around) * std::cos(along),
                                std::sin(around),
                                std::cos(around) * std::sin(along),
                                0.5f + 0.5f * std::sin(along),
                                0.4f,
                                0.8f,
                                1};
        std::copy(std::begin(values), std::end(values), tube.begin() + 10 * i);
      }
      gl.DrawElements(GL_TRIANGLE_STRIP, 14, GL_UNSIGNED_INT, order);
    }
    gl.EndList();
    tube.fill(0);
    gl.CallList(list);
  });
}

// --- Matrices that have no place in the world of the batch, and coordinates beyond the range of floats

struct UnplacedCase {
  const char* name;
  uint64_t traced;  // draws
  void (*set)(Gl gl);
};
void PrintTo(const UnplacedCase& p, std::ostream* out) { *out << p.name; }

/// Scaled down to the size of the others.
void scaledTriangle(Gl gl, double scale) {
  const auto size = static_cast<float>(0.4 / scale);
  gl.Translatef(0.8f, -0.4f, 0.5f), gl.Scaled(scale, scale, scale);
  gl.Disable(GL_LIGHTING), gl.Color3f(1, 1, 0);
  gl.Begin(GL_TRIANGLES);
  gl.Vertex3f(-size, -size, size / 4), gl.Vertex3f(size, -size, 0), gl.Vertex3f(0, size, -size / 4);
  gl.End(), gl.Enable(GL_LIGHTING);
}

class UnplacedSurfaces : public testing::TestWithParam<UnplacedCase> {};

TEST_P(UnplacedSurfaces, AreDrawnWhereTheyAre) {
  const gl::Statistics s = expectSame(
      [](Gl gl, Seen&) {
        stage(gl);
        send(gl, sphere(16, 24));
        gl.PushMatrix(), GetParam().set(gl), gl.PopMatrix();
        sendAt(gl, sphere(16, 24), -0.9f, 0.5f, 0.2f, 0.4f);
      },
      {.traced = GetParam().traced});
  EXPECT_EQ(s.rasterisedBecause[static_cast<size_t>(gl::Reason::failure)], 0u);
}

const UnplacedCase kUnplaced[] = {
    {"Shrunk", 3, [](Gl gl) { scaledTriangle(gl, 1e-10); }},
    {"ShrunkBeyondFloats", 2, [](Gl gl) { scaledTriangle(gl, 1e-13); }},
    {"Enlarged", 3, [](Gl gl) { scaledTriangle(gl, 1e8); }},
    {"EnlargedBeyondFloats", 2, [](Gl gl) { scaledTriangle(gl, 1e20); }},
    {"ShrunkPoint", 2,  // all of one depth
     [](Gl gl) {
       gl.Translatef(0.8f, -0.4f, 0.5f), gl.Scaled(1e-13, 1e-13, 1e-13);
       send(gl, sphere(8, 12));
     }},
    {"Projective", 3,
     [](Gl gl) {
       constexpr GLfloat kPerspective[] = {1, 0, 0, 0, 0, 1, 0, 0.1f, 0, 0, 1, 0.05f, 0.3f, -0.2f, 0.8f, 1};
       gl.MultMatrixf(kPerspective), gl.Disable(GL_LIGHTING), gl.Color3f(1, 1, 0);
       gl.Begin(GL_TRIANGLES);
       gl.Vertex3f(-0.4f, -0.4f, 0.1f), gl.Vertex3f(0.4f, -0.4f, 0), gl.Vertex3f(0, 0.4f, -0.1f);
       gl.End(), gl.Enable(GL_LIGHTING);
     }},
};

INSTANTIATE_TEST_SUITE_P(All, UnplacedSurfaces, testing::ValuesIn(kUnplaced),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test::twenty_points
