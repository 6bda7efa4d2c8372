#include "gl/stream_weld.h"

#include "gl/mesh_builder.h"
#include "gl/vertex_stream.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <new>
#include <random>
#include <vector>

namespace gluray::gl {
namespace {

using Welding = VertexStream::Welding;
constexpr uint32_t kNever = VertexStream::kNever, kWeldFrom = 1u << 16;
constexpr uint32_t kSide = 180;  // squares a side: corners enough to be welded while they arrive

/// Calls send(x, y) for every corner of a grid of squares, two triangles each.
template <class Send>
void forEachCorner(uint32_t side, Send&& send) {
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x) {
      send(x, y), send(x + 1, y), send(x + 1, y + 1);
      send(x, y), send(x + 1, y + 1), send(x, y + 1);
    }
}

float height(uint32_t x, uint32_t y) { return std::sin(static_cast<float>(x * 31 + y)); }

void sendGrid(VertexStream& stream, uint32_t side) {
  forEachCorner(side, [&](uint32_t x, uint32_t y) {
    const float normal[3] = {height(x, y), 0, 1};
    if (stream.has(kNormal)) stream.set(kNormal, normal);
    // As the leaf path does.
    if (stream.hasRoom())
      stream.vertex(static_cast<float>(x), static_cast<float>(y), height(y, x));
    else
      stream.vertexSlow(static_cast<float>(x), static_cast<float>(y), height(y, x), 1);
  });
}

Captured grid(uint32_t side, uint32_t weldFrom, SlotMask slots = bit(kPosition) | bit(kNormal),
              Welding where = Welding::here) {
  VertexStream stream;
  stream.start(slots, initialSlotValues(), weldFrom, where);
  stream.begin(GL_TRIANGLES);
  sendGrid(stream, side);
  stream.end();
  return stream.take();
}

/// The vertices as they were sent, through the indices where there are any.
std::vector<float> expanded(const Captured& c) {
  std::vector<float> floats;
  for (const Primitive& p : c.primitives)
    for (uint32_t i = p.first; i < p.first + p.count; ++i) {
      const float* v = c.vertex(c.indices.empty() ? i : c.indices[i]);
      floats.insert(floats.end(), v, v + c.layout.stride);
    }
  return floats;
}

/// On the calling thread, and on another.
class StreamWeld : public testing::TestWithParam<Welding> {};
INSTANTIATE_TEST_SUITE_P(Ways, StreamWeld, testing::Values(Welding::here, Welding::behind),
                         [](const auto& way) { return way.param == Welding::here ? "here" : "behind"; });

TEST_P(StreamWeld, LargeSoupsAreWeldedWhileTheyArrive) {
  for (const SlotMask slots :
       {bit(kPosition), bit(kPosition) | bit(kNormal), bit(kPosition) | bit(kNormal) | bit(kColor),
        bit(kPosition) | bit(kFogCoord)}) {
    const Captured soup = grid(kSide, kNever, slots), welded = grid(kSide, kWeldFrom, slots, GetParam());
    EXPECT_TRUE(soup.indices.empty());
    EXPECT_EQ(welded.indices.size(), 6u * kSide * kSide);
    EXPECT_EQ(welded.vertexCount, (kSide + 1) * (kSide + 1));
    EXPECT_EQ(welded.primitives, soup.primitives);
    EXPECT_EQ(expanded(welded), expanded(soup));
  }
}

TEST(StreamWelder, SmallSoupsAreLeftAlone) {
  EXPECT_TRUE(grid(20, kWeldFrom).indices.empty());
  EXPECT_TRUE(grid(kSide, 1'000'000).indices.empty());
}

TEST(StreamWelder, WhatHasArrivedBeforeIsWeldedToo) {
  const Captured soup = grid(kSide, kNever), welded = grid(kSide, 6 * kSide * kSide - 1000);
  EXPECT_EQ(welded.indices.size(), 6u * kSide * kSide);
  EXPECT_EQ(welded.vertexCount, (kSide + 1) * (kSide + 1));
  EXPECT_EQ(expanded(welded), expanded(soup));
}

TEST_P(StreamWeld, IncompleteTrianglesAreDropped) {
  for (const uint32_t extra : {1u, 2u})
    for (const bool numbered : {false, true}) {
      VertexStream stream;
      stream.start(bit(kPosition), initialSlotValues(), kWeldFrom, GetParam());
      stream.begin(GL_TRIANGLES);
      sendGrid(stream, kSide);
      for (uint32_t i = 0; i < extra; ++i) stream.vertexSlow(-5, static_cast<float>(i), 0, 1);
      if (numbered) stream.captured();  // gives numbers to the extra vertices too
      stream.end();
      stream.begin(GL_TRIANGLES);
      for (int i = 0; i < 3; ++i) stream.vertexSlow(-7, static_cast<float>(i), 0, 1);
      stream.end();
      const Captured c = stream.take();
      ASSERT_EQ(c.primitives, (std::vector<Primitive>{{GL_TRIANGLES, 0, 6 * kSide * kSide + 3}}));
      ASSERT_EQ(c.indices.size(), 6u * kSide * kSide + 3);
      EXPECT_EQ(c.vertex(c.indices[6 * kSide * kSide])[0], -7);
      EXPECT_EQ(c.vertex(c.indices[6 * kSide * kSide + 2])[1], 2);
    }
}

TEST_P(StreamWeld, OtherFiguresFollow) {
  VertexStream plain, welding;
  for (VertexStream* stream : {&plain, &welding}) {
    stream->start(bit(kPosition), initialSlotValues(), stream == &welding ? kWeldFrom : kNever, GetParam());
    stream->begin(GL_TRIANGLES), sendGrid(*stream, kSide), stream->end();
    stream->begin(GL_TRIANGLE_STRIP), sendGrid(*stream, 3), stream->end();
    stream->begin(GL_TRIANGLES), sendGrid(*stream, kSide), stream->end();
  }
  const Captured expected = plain.take(), got = welding.take();
  EXPECT_LT(got.vertexCount, expected.vertexCount);
  EXPECT_EQ(got.primitives, expected.primitives);
  EXPECT_EQ(expanded(got), expanded(expected));
  EXPECT_EQ(buildMesh(expected).mesh->geometryId, buildMesh(got).mesh->geometryId);
}

TEST_P(StreamWeld, ASlotSetLaterEndsTheWelding) {
  VertexStream stream;
  stream.start(bit(kPosition), initialSlotValues(), kWeldFrom, GetParam());
  stream.begin(GL_TRIANGLES), sendGrid(stream, kSide), stream.end();
  const uint32_t before = stream.captured().vertexCount;
  const float earlier[4] = {0, 0, 1, 0};
  stream.addSlot(kNormal, earlier);
  stream.begin(GL_TRIANGLES), sendGrid(stream, kSide), stream.end();
  const Captured c = stream.take();
  const uint32_t at = c.layout.offset[kNormal], half = 6 * kSide * kSide;
  ASSERT_EQ(c.indices.size(), 2u * half);
  for (uint32_t i = 0; i < half; ++i) {
    ASSERT_LT(c.indices[i], before) << "earlier vertices keep to themselves";
    ASSERT_GE(c.indices[half + i], before);
    ASSERT_EQ(c.vertex(c.indices[i])[at + 2], 1);
    ASSERT_EQ(c.vertex(c.indices[half + i])[0], c.vertex(c.indices[i])[0]);
  }
}

TEST_P(StreamWeld, MeshesTakeTheArraysOver) {
  Captured soup = grid(kSide, kNever),
           welded = grid(kSide, kWeldFrom, bit(kPosition) | bit(kNormal), GetParam());
  const KnownMesh expected = buildMesh(soup), got = buildMesh(std::move(welded));
  ASSERT_TRUE(got.mesh);
  EXPECT_EQ(welded.vertices.data(), nullptr);
  EXPECT_EQ(welded.indices.size(), 0u);
  EXPECT_EQ(got.mesh->positions.stride, 24u);
  EXPECT_EQ(got.mesh->geometryId, expected.mesh->geometryId);
  EXPECT_EQ(got.mesh->upper, expected.mesh->upper);
  EXPECT_EQ(got.mesh->triangleCount, expected.mesh->triangleCount);
  EXPECT_LE(got.mesh->sizeBytes, expected.mesh->sizeBytes);
  for (uint32_t t = 0; t < got.mesh->triangleCount; t += 7)
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t a = expected.mesh->corner(t, k), b = got.mesh->corner(t, k);
      ASSERT_EQ(expected.mesh->position(a), got.mesh->position(b));
      ASSERT_EQ(scene::fetch(expected.mesh->normals, a), scene::fetch(got.mesh->normals, b));
    }
}

TEST(StreamWelder, VerticesFarApartInTimeMayStayDouble) {
  StreamWelder welder;
  GrowingArray<uint32_t> indices;
  GrowingArray<float> vertices;
  constexpr uint32_t kCount = 1u << 21;
  vertices.resize(size_t{kCount} * 3);
  for (uint32_t i = 0; i < kCount; ++i)
    for (uint32_t k = 0; k < 3; ++k)
      vertices[size_t{i} * 3 + k] = static_cast<float>((i % (kCount / 2)) * (k + 1));
  const uint32_t kept = welder.weld(vertices.data(), 3, 0, vertices.data(), kCount, indices);
  EXPECT_GE(kept, kCount / 2);
  for (uint32_t i = 0; i < kCount; ++i)
    ASSERT_EQ(vertices[size_t{indices[i]} * 3 + 1], static_cast<float>((i % (kCount / 2)) * 2));
}

// Looked at, added to, aborted and begun again at every place within the pieces.
TEST_P(StreamWeld, RunsMayBeLookedAtWhileTheyArrive) {
  const Captured soup = grid(kSide, kNever);
  VertexStream stream;
  for (const uint32_t step : {1000u, 8192u, 9001u, 50'000u}) {
    stream.start(bit(kPosition) | bit(kNormal), initialSlotValues(), kWeldFrom, GetParam());
    stream.begin(GL_TRIANGLES);
    sendGrid(stream, kSide);  // given up
    stream.start(bit(kPosition) | bit(kNormal), initialSlotValues(), kWeldFrom, GetParam());
    EXPECT_TRUE(stream.empty());
    stream.begin(GL_TRIANGLES);
    uint32_t sent = 0;
    forEachCorner(kSide, [&](uint32_t x, uint32_t y) {
      const float normal[3] = {height(x, y), 0, 1};
      stream.set(kNormal, normal);
      stream.vertexSlow(static_cast<float>(x), static_cast<float>(y), height(y, x), 1);
      ASSERT_EQ(stream.openPrimitive().count, ++sent);
      if (sent % step == 0) { ASSERT_GT(stream.captured().vertexCount, 0u); }
    });
    stream.end();
    EXPECT_FALSE(stream.empty());
    const Captured c = stream.take();
    EXPECT_EQ(c.primitives, soup.primitives);
    EXPECT_EQ(c.vertexCount, (kSide + 1) * (kSide + 1));
    EXPECT_EQ(expanded(c), expanded(soup));
    EXPECT_TRUE(stream.empty());
  }
}

/// Vertices of a walk that often comes back to where it was, in primitives of all kinds, looked at now and
/// then.
Captured walk(Welding where, uint32_t seed) {
  constexpr GLenum kModes[] = {GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_QUADS};
  std::mt19937 random(seed);
  VertexStream stream;
  stream.start(bit(kPosition), initialSlotValues(), 5000, where);
  const uint32_t kinds = random() % 2 ? 3 : 5, addsAt = random() % 12;
  uint32_t place = 0;
  for (uint32_t figure = 0; figure < 12; ++figure) {
    const float up[4] = {0, 0, 1, 0};
    if (figure == addsAt) stream.addSlot(kNormal, up);
    stream.begin(kModes[random() % kinds]);
    for (uint32_t i = random() % 30'000; i > 0; --i) {
      place = random() % 3 ? place + 1 : place - std::min<uint32_t>(place, random() % 50);
      stream.vertexSlow(static_cast<float>(place), static_cast<float>(place % 7), 0, 1);
      if (random() % 40'000 == 0) stream.captured();
    }
    stream.end();
  }
  return stream.take();
}

TEST(WeldBehind, GivesWhatTheCallingThreadWouldWhateverComes) {
  for (uint32_t seed = 1; seed <= 15; ++seed) {
    const Captured here = walk(Welding::here, seed), behind = walk(Welding::behind, seed);
    ASSERT_EQ(behind.primitives, here.primitives) << seed;
    ASSERT_EQ(behind.vertexCount, here.vertexCount) << seed;
    ASSERT_TRUE(
        std::equal(behind.indices.begin(), behind.indices.end(), here.indices.begin(), here.indices.end()))
        << seed;
    ASSERT_EQ(expanded(behind), expanded(here)) << seed;
  }
}

/// What `body` returns in a forked child; -1 where it takes a minute or dies.
template <class Body>
int inChild(Body&& body) {
  const pid_t child = fork();
  if (child == 0) {
    alarm(60);
    _exit(body());
  }
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kMemoryCanBeLimited = false;  // sanitizers reserve most of the address space
#else
constexpr bool kMemoryCanBeLimited = true;
#endif

void limitMemory(rlim_t moreBytes) {
  std::ifstream file("/proc/self/statm");
  rlim_t pages = 0;
  file >> pages;
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = moreBytes ? pages * static_cast<rlim_t>(getpagesize()) + moreBytes : limit.rlim_max;
  setrlimit(RLIMIT_AS, &limit);
}

TEST(WeldBehind, NothingIsLostWhereMemoryIsShortForAWhile) {
  if (!kMemoryCanBeLimited) GTEST_SKIP() << "not with sanitizers";
  constexpr uint32_t kLarge = 600;
  const Captured soup = grid(kLarge, kNever, bit(kPosition));
  const auto shortOfMemory = [&] {
    VertexStream stream;
    stream.start(bit(kPosition), initialSlotValues(), kWeldFrom, Welding::behind);
    stream.begin(GL_TRIANGLES);
    uint32_t sent = 0, failures = 0;
    forEachCorner(kLarge, [&](uint32_t x, uint32_t y) {
      if (++sent == 2 * kWeldFrom) limitMemory(1 << 20);
      const auto send = [&] {
        stream.vertexSlow(static_cast<float>(x), static_cast<float>(y), height(y, x), 1);
      };
      try {
        send();
      } catch (const std::bad_alloc&) {
        ++failures;
        limitMemory(0);
        send();
      }
    });
    stream.end();
    return failures == 1 && expanded(stream.take()) == expanded(soup) ? 7 : 1;
  };
  EXPECT_EQ(inChild(shortOfMemory), 7);
}

TEST(WeldBehind, AForkedChildRefusesRatherThanWaits) {
  VertexStream stream;
  stream.start(bit(kPosition), initialSlotValues(), kWeldFrom, Welding::behind);
  stream.begin(GL_TRIANGLES);
  sendGrid(stream, kSide);
  const auto goOn = [&] {
    try {
      stream.captured();
    } catch (const std::exception&) {
      stream.start(bit(kPosition), initialSlotValues());
      return 7;
    }
    return 1;
  };
  EXPECT_EQ(inChild(goOn), 7);
  EXPECT_EQ(stream.captured().indices.size(), 6u * kSide * kSide);  // the parent goes on
}

}  // namespace
}  // namespace gluray::gl
