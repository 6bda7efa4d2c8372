// Putting a traced image of 1024x1024 pixels into the program's framebuffer, over an OpenGL in memory.
#include "bench/micro/micro_mesh.h"
#include "bench/render/wavelet_snapshot.h"
#include "frame/tracing/renderer.h"
#include "intercept/present/write_back/texture_upload.h"
#include "intercept/present/write_back/write_back.h"
#include "intercept/windows/shm_window.h"
#include "tests/support/osmesa_context.h"

#include <GL/glext.h>
#include <benchmark/benchmark.h>

#include <vector>

namespace {

using namespace gluray;

/// An image like a frame of the Wavelet: half of its pixels are hits.
const Image& makeImage() {
  static const Image image = [] {
    scene::Snapshot s = bench::waveletSnapshot(bench::microMesh());
    bench::lookFrom(s, bench::orbitPose(0, 0));
    frame::Renderer renderer;
    scene::TraceCost statistics;
    std::string error;
    Image out;
    renderer.render(s, out, statistics, error);
    return out;
  }();
  return image;
}

/// A framebuffer of the benchmark's size with colour alone.
void bindColorOnly(const gl::RealGl& gl) {
  GLuint framebuffer = 0, color = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.GenRenderbuffers(1, &color);
  gl.BindRenderbuffer(GL_RENDERBUFFER, color);
  gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, bench::kImageSize, bench::kImageSize);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
}

enum class Case { depth, noDepthBuffer, unchanged };

void writeBack(benchmark::State& state, Case which) {
  const auto context = test::OsmesaContext::create({bench::kImageSize, bench::kImageSize});
  if (!context) return state.SkipWithError("no OpenGL in memory");
  const gl::RealGl& gl = context->real();
  if (which == Case::noDepthBuffer) bindColorOnly(gl);
  gl.Enable(GL_DEPTH_TEST);
  present::WriteBack writer(gl);
  present::PendingErrors pending;
  std::string why;
  if (!writer.ready(why)) return state.SkipWithError(why.c_str());
  uint64_t number = 0;
  for (auto _ : state) {
    state.PauseTiming();
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Finish();
    state.ResumeTiming();
    const uint64_t name = which == Case::unchanged ? 1 : ++number;
    if (!writer.write(makeImage(), {.imageId = name}, pending)) return state.SkipWithError("refused");
    gl.Finish();
  }
  state.SetItemsProcessed(state.iterations());
  writer.release();
}
BENCHMARK_CAPTURE(writeBack, depth, Case::depth)
    ->Name("write_back/depth")
    ->UseRealTime()
    ->Iterations(50)
    ->Repetitions(5);
BENCHMARK_CAPTURE(writeBack, none, Case::noDepthBuffer)
    ->Name("write_back/no_depth_buffer")
    ->UseRealTime()
    ->Iterations(50)
    ->Repetitions(5);
BENCHMARK_CAPTURE(writeBack, same, Case::unchanged)
    ->Name("write_back/unchanged")
    ->UseRealTime()
    ->Iterations(50)
    ->Repetitions(5);

/// A framebuffer of the benchmark's size with the textures that ParaView has.
void bindTextures(const gl::RealGl& gl) {
  constexpr int kSize = bench::kImageSize;
  GLuint framebuffer = 0, textures[2] = {};
  gl.GenTextures(2, textures);
  gl.BindTexture(GL_TEXTURE_2D, textures[0]);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl.BindTexture(GL_TEXTURE_2D, textures[1]);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, kSize, kSize, 0, GL_DEPTH_STENCIL,
                GL_UNSIGNED_INT_24_8, nullptr);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures[0], 0);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, textures[1], 0);
}

/// Uploads the image into textures that hold only their clear values.
void send(benchmark::State& state) {
  const auto context = test::OsmesaContext::create({bench::kImageSize, bench::kImageSize});
  if (!context) return state.SkipWithError("no OpenGL in memory");
  const gl::RealGl& gl = context->real();
  bindTextures(gl);
  const present::Features features = present::readFeatures(gl);
  present::TextureUpload put;
  present::PendingErrors pending;
  for (auto _ : state) {
    state.PauseTiming();
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Finish();
    state.ResumeTiming();
    if (!put.put(gl, features, makeImage(), 0, pending)) return state.SkipWithError("refused");
    gl.Finish();
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(send)->Name("write_back/sent")->UseRealTime()->Iterations(100)->Repetitions(5);

/// Converts the image for a window, without the X server.
void fillWindow(benchmark::State& state) {
  std::vector<uint32_t> pixels(size_t{bench::kImageSize} * bench::kImageSize);
  const float farthest = 1 - 0x1p-25f;
  for (auto _ : state)
    intercept::fillWindow({makeImage(), farthest, 1}, {bench::kImageSize, bench::kImageSize}, pixels.data());
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(fillWindow)->Name("write_back/window")->UseRealTime()->Iterations(200)->Repetitions(5);

}  // namespace
