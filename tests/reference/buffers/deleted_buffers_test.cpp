// Buffers that are deleted while a vertex array object that is not bound, or another context's, still holds
// them: they live on there (OpenGL 4.6, 5.1.2 and 5.1.3), and their names may be reused.
#include "tests/reference/hostile/habits.h"
#include "tests/reference/programs/program_stage.h"
#include "tests/reference/triangle_field.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

namespace gluray::test {
namespace {

using namespace triangle_field;
using namespace twenty_points;

constexpr GLsizeiptr kIndexBytes = kVertices * sizeof(GLushort);

/// Every triangle, or every second one twice.
std::vector<GLushort> order(int step) {
  std::vector<GLushort> all;
  for (int i = 0; i < kVertices; ++i) all.push_back(static_cast<GLushort>(i / 3 / step * step * 3 + i % 3));
  return all;
}

void fillTriangles(Gl gl, GLenum target, GLuint name, float lean) {
  gl.BindBuffer(target, name);
  if (target == GL_ELEMENT_ARRAY_BUFFER)
    gl.BufferData(target, kIndexBytes, order(lean > 0.5f ? 1 : 2).data(), GL_STATIC_DRAW);
  else
    gl.BufferData(target, kBytes, field(lean).data(), GL_STATIC_DRAW);
}

struct Place {
  const char* name;
  /// Puts positions and indices into the bound vertex array object.
  void (*attach)(Gl gl, GLuint array, GLuint positions, GLuint indices);
};
void PrintTo(const Place& p, std::ostream* out) { *out << p.name; }

const Place kPlaces[] = {
    {"VertexPointer",
     [](Gl gl, GLuint, GLuint positions, GLuint indices) {
       gl.BindBuffer(GL_ARRAY_BUFFER, positions), gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
       gl.VertexPointer(3, GL_FLOAT, 0, nullptr), gl.EnableClientState(GL_VERTEX_ARRAY);
     }},
    {"InterleavedArrays",
     [](Gl gl, GLuint, GLuint positions, GLuint indices) {
       gl.BindBuffer(GL_ARRAY_BUFFER, positions), gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
       gl.InterleavedArrays(GL_V3F, 0, nullptr);
     }},
};

class DeletedBuffers : public testing::TestWithParam<Place> {};

void expectDeletedOneIsDrawn(const Place& place, bool drawnBefore, bool indices) {
  const gl::Statistics s = expectSame(
      [&](Gl gl, Seen& seen) {
        stage(gl);
        GLuint array = 0, buffers[2] = {};
        gl.GenVertexArrays(1, &array), gl.GenBuffers(2, buffers);
        fillTriangles(gl, GL_ARRAY_BUFFER, buffers[0], 0.3f);
        gl.BindVertexArray(array), fillTriangles(gl, GL_ELEMENT_ARRAY_BUFFER, buffers[1], 0.3f);
        place.attach(gl, array, buffers[0], buffers[1]);
        const auto draw = [&](float x) {
          gl.PushMatrix(), gl.Translatef(x, 0, 0), gl.Scalef(0.3f, 0.3f, 0.3f);
          gl.DrawElements(GL_TRIANGLES, kVertices, GL_UNSIGNED_SHORT, nullptr);
          gl.PopMatrix();
        };
        if (drawnBefore) draw(-0.7f);
        gl.BindVertexArray(0);
        const GLuint old = buffers[indices ? 1 : 0];
        gl.DeleteBuffers(1, &old);
        seen.push_back(gl.IsBuffer(old));
        fillTriangles(gl, indices ? GL_ELEMENT_ARRAY_BUFFER : GL_ARRAY_BUFFER, old,
                      1);  // the name is reused
        gl.BindVertexArray(array), draw(0);
        place.attach(gl, array, buffers[0], buffers[1]), draw(0.7f);
        gl.Finish();
      },
      {.traced = drawnBefore ? 2u : 1u});
  EXPECT_EQ(s.rasterisedBecause[static_cast<size_t>(gl::Reason::deletedBuffer)], 1u);
}

TEST_P(DeletedBuffers, LiveOnInAVertexArrayObject) {
  for (const bool drawnBefore : {true, false}) expectDeletedOneIsDrawn(GetParam(), drawnBefore, false);
}
TEST_P(DeletedBuffers, LiveOnAsItsIndices) {
  for (const bool drawnBefore : {true, false}) expectDeletedOneIsDrawn(GetParam(), drawnBefore, true);
}

INSTANTIATE_TEST_SUITE_P(All, DeletedBuffers, testing::ValuesIn(kPlaces),
                         [](const auto& info) { return std::string(info.param.name); });

/// How a program's vertex array object gets its positions.
struct ProgramPlace {
  const char* name;
  void (*attach)(Gl gl, GLuint array, GLuint location, GLuint positions);
};
void PrintTo(const ProgramPlace& p, std::ostream* out) { *out << p.name; }

constexpr GLsizei kStride = 3 * sizeof(float);
const ProgramPlace kProgramPlaces[] = {
    {"VertexAttribPointer",
     [](Gl gl, GLuint, GLuint location, GLuint positions) {
       gl.BindBuffer(GL_ARRAY_BUFFER, positions);
       gl.VertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
     }},
    {"BindVertexBuffer",
     [](Gl gl, GLuint, GLuint location, GLuint positions) {
       gl.VertexAttribFormat(location, 3, GL_FLOAT, GL_FALSE, 0), gl.VertexAttribBinding(location, 7);
       gl.BindVertexBuffer(7, positions, 0, kStride);
     }},
    {"BindVertexBuffers",
     [](Gl gl, GLuint, GLuint location, GLuint positions) {
       const GLintptr offsets[2] = {};
       const GLsizei strides[2] = {kStride, kStride};
       const GLuint names[2] = {0, positions};
       gl.VertexAttribFormat(location, 3, GL_FLOAT, GL_FALSE, 0), gl.VertexAttribBinding(location, 7);
       gl.BindVertexBuffers(6, 2, names, offsets, strides);
     }},
    {"VertexArrayVertexBuffer",
     [](Gl gl, GLuint array, GLuint location, GLuint positions) {
       gl.VertexArrayAttribFormat(array, location, 3, GL_FLOAT, GL_FALSE, 0);
       gl.VertexArrayAttribBinding(array, location, 7);
       gl.VertexArrayVertexBuffer(array, 7, positions, 0, kStride);
     }},
};

class DeletedProgramBuffers : public testing::TestWithParam<ProgramPlace> {};

TEST_P(DeletedProgramBuffers, LiveOnInAVertexArrayObject) {
  const Surface surface{.lights = Surface::Lights::none};
  test::expectSame(
      std::string("deleted_") + GetParam().name,
      [&](Gl gl) {
        beginFrame(gl);
        const GLuint program = makeProgram(gl, surface);
        ProgramMesh mesh = ball(12);
        Upload up = upload(gl, mesh, program);
        const auto location = static_cast<GLuint>(gl.GetAttribLocation(program, "vertexMC"));
        const auto place = [&](double x) {
          View view = perspectiveView(20);
          for (int c = 0; c < 3; ++c) view.eyeFromObject[c] *= 0.4;
          view.eyeFromObject[3][0] += x;
          gl.UseProgram(program), drawSurface(gl, program, up, mesh, view, surface);
        };
        gl.BindVertexArray(up.array), GetParam().attach(gl, up.array, location, up.positions);
        place(-1);
        gl.BindVertexArray(0), gl.DeleteBuffers(1, &up.positions);
        for (glm::vec3& p : mesh.positions) p *= glm::vec3(0.5f, 1, 0.5f);
        gl.GenBuffers(1, &up.positions), gl.BindBuffer(GL_ARRAY_BUFFER, up.positions);
        gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.positions.size() * kStride),
                      mesh.positions.data(), GL_STATIC_DRAW);
        place(0);
        gl.BindVertexArray(up.array), GetParam().attach(gl, up.array, location, up.positions);
        place(1);
      },
      2, coreWish(4, 5));
}

INSTANTIATE_TEST_SUITE_P(All, DeletedProgramBuffers, testing::ValuesIn(kProgramPlaces),
                         [](const auto& info) { return std::string(info.param.name); });

// --- Buffers that another context has bound when they are deleted
// --------------------------------------------

class BoundElsewhere : public testing::TestWithParam<GLenum> {};

using Contents = std::array<float, 4>;

/// One context has a buffer bound, the other deletes it and gives its name to a new one; both are written to.
/// Compares their contents, and errors.
template <class MakeCurrent>
std::vector<float> writeBoth(const gl::RealGl* const (&contexts)[2], MakeCurrent makeCurrent, GLenum target) {
  constexpr GLuint kName = 7;
  std::vector<float> seen;
  const auto fill = [](Gl gl, GLenum at, const Contents& c) {
    gl.BufferData(at, sizeof c, c.data(), GL_STATIC_DRAW);
  };
  const auto ask = [&](Gl gl, GLenum at) {
    Contents c{};
    gl.GetBufferSubData(at, 0, sizeof c, c.data());
    seen.insert(seen.end(), c.begin(), c.end()), seen.push_back(static_cast<float>(gl.GetError()));
  };
  Gl first = *contexts[0], second = *contexts[1];
  makeCurrent(0), first.BindBuffer(target, kName), fill(first, target, {1, 2, 3, 4});
  makeCurrent(1), second.BindBuffer(target, kName), ask(second, target);
  makeCurrent(0), first.DeleteBuffers(1, &kName), first.BindBuffer(target, kName);
  fill(first, target, {5, 6, 7, 8});
  const Contents part{10, 20};
  makeCurrent(1), second.BufferSubData(target, 4, 8, part.data()), ask(second, target);
  if (void* mapped = second.MapBuffer(target, GL_WRITE_ONLY)) std::memcpy(mapped, part.data(), 4);
  second.UnmapBuffer(target), ask(second, target);
  makeCurrent(0), ask(first, target), first.BufferSubData(target, 8, 8, part.data()), ask(first, target);
  makeCurrent(1), fill(second, target, {0.5f, 0.25f, 1, 2}), ask(second, target);
  second.BindBuffer(target, kName), ask(second, target), fill(second, target, {9, 9, 9, 9});
  makeCurrent(0), ask(first, target);
  return seen;
}

TEST_P(BoundElsewhere, IsNotTheOneThatHasItsNameNow) {
  std::vector<float> expected, got;
  {
    const auto a = OsmesaContext::create({32, 32}), b = OsmesaContext::create({32, 32}, a.get());
    expected = writeBoth(
        {&a->real(), &b->real()}, [&](int i) { (i ? b : a)->makeCurrent(); }, GetParam());
  }
  TracedContext a({32, 32}), b({32, 32}, TracedContext::vertexShading(), nullptr, &a);
  got = writeBoth(
      {&a.gl(), &b.gl()}, [&](int i) { (i ? b : a).makeCurrent(); }, GetParam());
  a.makeCurrent();
  EXPECT_EQ(got, expected);
}

INSTANTIATE_TEST_SUITE_P(All, BoundElsewhere,
                         testing::Values(GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER, GL_COPY_READ_BUFFER,
                                         GL_UNIFORM_BUFFER));

// --- Renderbuffers and textures in framebuffer objects that are not bound ----------------------------------

struct DeletedImage {
  const char* name;
  GLuint (*make)(Gl gl, GLuint name, GLsizei size);  // attached to the bound framebuffer object
  void (*remove)(Gl gl, GLuint name);
  GLboolean (*exists)(Gl gl, GLuint name);
};
void PrintTo(const DeletedImage& i, std::ostream* out) { *out << i.name; }

const DeletedImage kDeletedImages[] = {
    {"Renderbuffer",
     [](Gl gl, GLuint name, GLsizei size) {
       if (!name) gl.GenRenderbuffers(1, &name);
       gl.BindRenderbuffer(GL_RENDERBUFFER, name);
       gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size, size);
       gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, name);
       gl.BindRenderbuffer(GL_RENDERBUFFER, 0);
       return name;
     },
     [](Gl gl, GLuint name) { gl.DeleteRenderbuffers(1, &name); },
     [](Gl gl, GLuint name) { return gl.IsRenderbuffer(name); }},
    {"Texture",
     [](Gl gl, GLuint name, GLsizei size) {
       if (!name) gl.GenTextures(1, &name);
       gl.BindTexture(GL_TEXTURE_2D, name);
       gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
       gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name, 0);
       gl.BindTexture(GL_TEXTURE_2D, 0);
       return name;
     },
     [](Gl gl, GLuint name) { gl.DeleteTextures(1, &name); },
     [](Gl gl, GLuint name) { return gl.IsTexture(name); }},
};

class DeletedImages : public testing::TestWithParam<DeletedImage> {};

TEST_P(DeletedImages, LiveOnInAFramebufferObject) {
  for (const bool reused : {false, true})
    expectSame(
        [&](Gl gl, Seen& seen) {
          constexpr GLsizei kLarge = 96, kSmall = 8;
          stage(gl);
          GLuint framebuffers[2] = {}, depth = 0;
          gl.GenFramebuffers(2, framebuffers), gl.GenRenderbuffers(1, &depth);
          gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers[0]);
          const GLuint image = GetParam().make(gl, 0, kLarge);
          gl.BindRenderbuffer(GL_RENDERBUFFER, depth);
          gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, kLarge, kLarge);
          gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
          gl.BindRenderbuffer(GL_RENDERBUFFER, 0);
          gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers[1]);
          GetParam().remove(gl, image);
          if (reused) GetParam().make(gl, image, kSmall);  // reuses the name
          gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers[0]);
          gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
          GLuint buffer = 0;
          gl.GenBuffers(1, &buffer), fillTriangles(gl, GL_ARRAY_BUFFER, buffer, 0.7f);
          gl.VertexPointer(3, GL_FLOAT, 0, nullptr), gl.EnableClientState(GL_VERTEX_ARRAY);
          gl.DrawArrays(GL_TRIANGLES, 0, kVertices);
          std::vector<GLubyte> colors(4 * kLarge * kLarge);
          gl.ReadPixels(0, 0, kLarge, kLarge, GL_RGBA, GL_UNSIGNED_BYTE, colors.data());
          for (size_t i = 0; i < colors.size(); i += 4 * 64) seen.push_back(colors[i] > 0);
          seen.push_back(GetParam().exists(gl, image));
          gl.BindFramebuffer(GL_FRAMEBUFFER, 0), gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        },
        {.traced = 1});
}

INSTANTIATE_TEST_SUITE_P(All, DeletedImages, testing::ValuesIn(kDeletedImages),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test
