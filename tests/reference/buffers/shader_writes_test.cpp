// Writes by shaders and queries into buffers while draws are pending: counters, shader storage, images and
// query results must equal those of the real OpenGL, which draws everything in order.
#include "tests/reference/hostile/habits.h"
#include "tests/reference/programs/program_stage.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

namespace gluray::test::twenty_points {
namespace {

/// A rectangle across the view at `z`, 2 `half` high, of more triangles than are captured one by one.
void card(Gl gl, float z, float half) {
  std::vector<float> all;
  for (int i = 0; i < 80; ++i) {
    const float x = -0.8f + 0.02f * static_cast<float>(i), right = x + 0.02f;
    all.insert(all.end(),
               {x, -half, z, right, -half, z, right, half, z, x, -half, z, right, half, z, x, half, z});
  }
  gl.EnableClientState(GL_VERTEX_ARRAY), gl.VertexPointer(3, GL_FLOAT, 0, all.data());
  gl.DrawArrays(GL_TRIANGLES, 0, 480);
  gl.DisableClientState(GL_VERTEX_ARRAY);
}

/// A buffer of four numbers that have not been sent to the real OpenGL yet.
GLuint numbers(Gl gl) {
  constexpr std::array<GLuint, 4> kBefore = {7, 11, 13, 17};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof kBefore, kBefore.data(), GL_DYNAMIC_COPY);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  return buffer;
}

void tell(Gl gl, GLuint buffer, bool mapped, Seen& seen) {
  std::array<GLuint, 4> got{};
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  if (mapped) {
    const void* at = gl.MapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
    ASSERT_NE(at, nullptr);
    std::memcpy(got.data(), at, sizeof got);
    gl.UnmapBuffer(GL_ARRAY_BUFFER);
  } else {
    gl.GetBufferSubData(GL_ARRAY_BUFFER, 0, sizeof got, got.data());
  }
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  for (const GLuint v : got) seen.push_back(static_cast<float>(v));
}

/// The counter of a fragment program, and how it counts.
struct Counter {
  const char* name;
  GLenum target;
  const char* declaration;
  const char* count;
};
void PrintTo(const Counter& c, std::ostream* out) { *out << c.name; }

const Counter kCounters[] = {
    {"AtomicCounter", GL_ATOMIC_COUNTER_BUFFER, "layout(binding = 1, offset = 4) uniform atomic_uint n;",
     "atomicCounterIncrement(n);"},
    {"ShaderStorage", GL_SHADER_STORAGE_BUFFER, "layout(std430, binding = 1) buffer N { uint n[]; };",
     "atomicAdd(n[1], 1u);"},
};

GLuint countingProgram(Gl gl, const Counter& counter) {
  const char* const vertex = "#version 430 compatibility\nvoid main() { gl_Position = ftransform(); }\n";
  return makeProgram(gl, vertex,
                     std::string("#version 430 compatibility\nlayout(early_fragment_tests) in;\n") +
                         counter.declaration + "\nvoid main() { " + counter.count +
                         " gl_FragColor = vec4(1, 0.5, 0, 1); }\n");
}

class ShaderWrites : public testing::TestWithParam<Counter> {};

/// A traced rectangle hides part of the program's surface behind it: those fragments must not be counted.
TEST_P(ShaderWrites, CountOnlyFragmentsNotHiddenByTracedSurfaces) {
  for (const bool mapped : {false, true})
    expectSame(
        [&](Gl gl, Seen& seen) {
          stage(gl);
          const GLuint program = countingProgram(gl, GetParam()), buffer = numbers(gl);
          gl.BindBufferBase(GetParam().target, 1, buffer);
          card(gl, 0.5f, 0.4f);
          gl.UseProgram(program), card(gl, -0.5f, 0.8f), gl.UseProgram(0);
          card(gl, 0.6f, 0.2f);
          gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
          tell(gl, buffer, mapped, seen);
          EXPECT_GT(seen[1], 100);
        },
        {.seenTolerance = 0, .traced = 2});
}

/// The same program twice, with the buffer written by the program in between.
TEST_P(ShaderWrites, FollowTheProgramsOwnWrites) {
  expectSame(
      [&](Gl gl, Seen& seen) {
        stage(gl);
        const GLuint program = countingProgram(gl, GetParam()), buffer = numbers(gl);
        gl.BindBufferBase(GetParam().target, 1, buffer);
        for (const float z : {-0.5f, 0.2f}) {
          gl.UseProgram(program), card(gl, z, 0.6f), gl.UseProgram(0);
          gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
          tell(gl, buffer, false, seen);
          const GLuint fresh = 1000;
          gl.BindBuffer(GL_COPY_WRITE_BUFFER, buffer);
          gl.BufferSubData(GL_COPY_WRITE_BUFFER, 4, 4, &fresh);
          card(gl, z + 0.1f, 0.3f);
        }
        tell(gl, buffer, true, seen);
      },
      {.seenTolerance = 0, .traced = 2});
}

INSTANTIATE_TEST_SUITE_P(All, ShaderWrites, testing::ValuesIn(kCounters),
                         [](const auto& info) { return std::string(info.param.name); });

/// A program of a family that also counts: tracing would lose its counts.
TEST(ShaderWritesOfFamilies, AreNeverTraced) {
  for (const Counter& counter : kCounters) {
    std::array<GLuint, 2> counts{};
    size_t run = 0;
    test::expectSame(
        std::string("family_") + counter.name,
        [&](Gl gl) {
          beginFrame(gl);
          const Surface surface{.version = "#version 430\n"};
          std::string fragment = fragmentText(surface);
          fragment.insert(fragment.find('\n') + 1, std::string(counter.declaration) + "\n");
          fragment.insert(fragment.rfind('}'), std::string("  ") + counter.count + "\n");
          const GLuint program = makeProgram(gl, vertexText(surface), fragment), buffer = numbers(gl);
          gl.BindBufferBase(counter.target, 1, buffer);
          const ProgramMesh mesh = ball(12);
          const Upload up = upload(gl, mesh, program);
          gl.UseProgram(program), drawSurface(gl, program, up, mesh, perspectiveView(20), surface);
          gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
          std::array<GLuint, 4> got{};
          gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
          gl.GetBufferSubData(GL_ARRAY_BUFFER, 0, sizeof got, got.data());
          counts[run++ % 2] = got[1];
        },
        0, coreWish(4, 5));
    EXPECT_EQ(counts[0], counts[1]) << counter.name;
    EXPECT_GT(counts[0], 100u);
  }
}

/// How the result of a query gets into a buffer.
struct Asking {
  const char* name;
  void (*ask)(Gl gl, GLuint query, GLuint buffer);
};
void PrintTo(const Asking& a, std::ostream* out) { *out << a.name; }

void* placeAt(size_t offset) { return reinterpret_cast<void*>(offset); }
const Asking kAskings[] = {
    {"GetQueryObjectuiv",
     [](Gl gl, GLuint query, GLuint buffer) {
       gl.BindBuffer(GL_QUERY_BUFFER, buffer);
       gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, static_cast<GLuint*>(placeAt(4)));
       gl.BindBuffer(GL_QUERY_BUFFER, 0);
     }},
    {"GetQueryObjectui64v",
     [](Gl gl, GLuint query, GLuint buffer) {
       gl.BindBuffer(GL_QUERY_BUFFER, buffer);
       gl.GetQueryObjectui64v(query, GL_QUERY_RESULT, static_cast<GLuint64*>(placeAt(8)));
       gl.BindBuffer(GL_QUERY_BUFFER, 0);
     }},
    {"GetQueryBufferObjectuiv",
     [](Gl gl, GLuint query, GLuint buffer) {
       gl.GetQueryBufferObjectuiv(query, buffer, GL_QUERY_RESULT, 4);
     }},
    {"GetQueryBufferObjecti64v",
     [](Gl gl, GLuint query, GLuint buffer) {
       gl.GetQueryBufferObjecti64v(query, buffer, GL_QUERY_RESULT, 8);
     }},
};

class QueryBuffers : public testing::TestWithParam<Asking> {};

TEST_P(QueryBuffers, HoldWhatTheRealOneCounts) {
  if (const auto real = OsmesaContext::create({kWidth, kHeight}); !real->real().GetQueryBufferObjectuiv)
    GTEST_SKIP() << "no query buffers";
  for (const bool mapped : {false, true})
    expectSame(
        [&](Gl gl, Seen& seen) {
          stage(gl);
          const GLuint buffer = numbers(gl);
          GLuint query = 0;
          gl.GenQueries(1, &query);
          card(gl, 0.5f, 0.4f);
          gl.BeginQuery(GL_SAMPLES_PASSED, query), card(gl, -0.5f, 0.8f), gl.EndQuery(GL_SAMPLES_PASSED);
          card(gl, 0.6f, 0.2f);
          GetParam().ask(gl, query, buffer);
          tell(gl, buffer, mapped, seen);
          EXPECT_GT(seen[1] + seen[2], 124);  // more than was there
        },
        {.seenTolerance = 0, .traced = 2});
}

INSTANTIATE_TEST_SUITE_P(All, QueryBuffers, testing::ValuesIn(kAskings),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test::twenty_points
