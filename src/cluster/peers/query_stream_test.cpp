#include "cluster/peers/query_stream.h"

#include "cluster/peers/near_peer.h"
#include "cluster/peers/tile_record.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <random>

namespace gluray::cluster {
namespace {

constexpr int kLanes = accel::kLanes;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

class Random {
 public:
  explicit Random(uint32_t seed) : engine_(seed) {}
  float number() { return static_cast<float>(engine_() % 2001) / 1000 - 1; }
  glm::vec3 vector() {
    const float x = number(), y = number(), z = number();
    return {x, y, z};
  }
  uint32_t below(uint32_t n) { return static_cast<uint32_t>(engine_() % n); }

 private:
  std::mt19937 engine_;
};

QueryPacket packetOf(Random& random) {
  QueryPacket packet;
  packet.lanes = 1 + random.below(0xFFFF);
  packet.kind = random.below(2) ? accel::RayKind::shadow : accel::RayKind::occlusion;
  if (random.below(4) == 0) packet.lamp = random.vector();
  const bool endless = random.below(2) != 0;
  for (int i = 0; i < kLanes; ++i) {
    const glm::vec3 o = random.vector(), d = random.vector();
    accel::OcclusionRays& r = packet.rays;
    r.orgX[i] = o.x, r.orgY[i] = o.y, r.orgZ[i] = o.z, r.dirX[i] = d.x, r.dirY[i] = d.y, r.dirZ[i] = d.z;
    r.tNear[i] = 0, r.tFar[i] = endless ? kInfinity : random.number() + 1;
  }
  return packet;
}

void expectSame(const QueryPacket& a, const QueryPacket& b) {
  ASSERT_EQ(a.lanes, b.lanes);
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.lamp, b.lamp);
  for (int i = 0; i < kLanes; ++i) {
    if (!(a.lanes >> i & 1)) continue;
    const accel::OcclusionRays &r = a.rays, &s = b.rays;
    EXPECT_TRUE(r.orgX[i] == s.orgX[i] && r.orgY[i] == s.orgY[i] && r.orgZ[i] == s.orgZ[i]) << i;
    EXPECT_TRUE(r.dirX[i] == s.dirX[i] && r.dirY[i] == s.dirY[i] && r.dirZ[i] == s.dirZ[i]) << i;
    EXPECT_TRUE(r.tFar[i] == s.tFar[i] && s.tNear[i] == 0) << i;
  }
}

TEST(QueryStream, PacketsComeBackToTheBit) {
  Random random(1);
  std::vector<QueryPacket> packets;
  QueryWriter out;
  size_t rays = 0;
  for (int n = 0; n < 200; ++n) {
    QueryPacket packet = packetOf(random);
    // Several samples at the same points; sometimes of fewer lanes.
    if (n % 3) {
      const accel::OcclusionRays& last = packets.back().rays;
      for (int i = 0; i < kLanes; ++i)
        packet.rays.orgX[i] = last.orgX[i], packet.rays.orgY[i] = last.orgY[i],
        packet.rays.orgZ[i] = last.orgZ[i];
    }
    out.add(packet);
    rays += static_cast<size_t>(std::popcount(packet.lanes));
    packets.push_back(packet);
  }
  EXPECT_EQ(out.rays(), rays);
  const std::vector<std::byte> bytes = out.takeBytes();
  QueryReader in(bytes);
  QueryPacket packet;
  for (const QueryPacket& expected : packets) {
    ASSERT_TRUE(in.nextPacket(packet));
    expectSame(expected, packet);
  }
  EXPECT_FALSE(in.nextPacket(packet));
}

TEST(QueryStream, FourSamplesOfAPointTakeSixteenBytesARay) {
  Random random(2);
  QueryWriter out;
  for (int point = 0; point < 100; ++point) {
    QueryPacket packet = packetOf(random);
    packet.lanes = 0xFFFF, packet.lamp.reset();
    std::ranges::fill(packet.rays.tFar, 2.5f);
    for (int sample = 0; sample < 4; ++sample) {
      for (float& x : packet.rays.dirX) x = random.number();
      out.add(packet);
    }
  }
  EXPECT_LE(out.takeBytes().size(), size_t{16} * 100 * 4 * kLanes);
}

TEST(QueryStream, AnswersComeBack) {
  AnswerPacket some;
  some.blocked = 5, some.partly = 8;
  some.through[3] = {0.1f, 0.5f, 1};
  AnswerWriter out;
  out.add({3});
  out.add(some);
  const std::vector<std::byte> bytes = out.takeBytes();
  AnswerReader in(bytes);
  EXPECT_EQ(in.nextPacket(0xFF).blocked, 3u);
  const AnswerPacket read = in.nextPacket(0xFF);
  EXPECT_EQ(read.blocked, 5u);
  EXPECT_EQ(read.partly, 8u);
  EXPECT_EQ(read.through[3], some.through[3]);
  EXPECT_TRUE(in.atEnd());
}

TEST(QueryStream, WhatNobodyWritesIsRefused) {
  AnswerWriter out;
  out.add({0x10});
  const std::vector<std::byte> answers = out.takeBytes();
  AnswerReader in(answers);
  EXPECT_THROW(in.nextPacket(0xF), Malformed) << "a ray that was not asked about";

  Random random(3);
  QueryWriter queries;
  for (int i = 0; i < 20; ++i) queries.add(packetOf(random));
  const std::vector<std::byte> good = queries.takeBytes();
  int refused = 0;
  for (uint32_t n = 0; n < 20000; ++n) {
    std::vector<std::byte> bytes = good;
    for (uint32_t k = 0; k <= random.below(4); ++k)
      bytes[random.below(static_cast<uint32_t>(bytes.size()))] = static_cast<std::byte>(random.below(256));
    if (random.below(3) == 0) bytes.resize(random.below(static_cast<uint32_t>(bytes.size())));
    try {
      QueryReader reader(bytes);
      QueryPacket packet;
      while (reader.nextPacket(packet)) ASSERT_NE(packet.lanes, 0u);
    } catch (const Malformed&) { ++refused; }
  }
  EXPECT_GT(refused, 1000);
}

SceneHeld sceneAt(const glm::dmat4& eyeFromWorld) {
  SceneHeld scene;
  scene.eyeFromWorld = eyeFromWorld;
  scene.lower = {-1, -1, -1}, scene.upper = {1, 1, 1};
  return scene;
}

TEST(NearPeer, RaysThatMayMeetItsBoundsAreAsked) {
  const NearPeer peer(sceneAt(glm::dmat4(1)), sceneAt(glm::dmat4(1)), glm::dmat4(1));
  accel::OcclusionRays rays{};
  const auto set = [&](int i, const glm::vec3& o, const glm::vec3& d, float length) {
    rays.orgX[i] = o.x, rays.orgY[i] = o.y, rays.orgZ[i] = o.z;
    rays.dirX[i] = d.x, rays.dirY[i] = d.y, rays.dirZ[i] = d.z, rays.tFar[i] = length;
  };
  set(0, {0, 0, 5}, {0, 0, -1}, kInfinity);
  set(1, {0, 0, 5}, {0, 0, 1}, kInfinity);
  set(2, {0, 0, 5}, {0, 0, -1}, 3.9f);
  set(3, {0, 0, 5}, {0, 0, -1}, 4.1f);
  set(4, {3, 0, 5}, {0, 0, -1}, kInfinity);
  set(5, {0.5f, 0.5f, 0}, {1, 2, 3}, kInfinity);
  set(6, {5, 5, 5}, {-1, -1, -1}, kInfinity);
  EXPECT_EQ(peer.mayMeet(rays, 0x7F), 0b1101001u);
  EXPECT_EQ(peer.mayMeet(rays, 0x0F), 0b0001001u) << "of the lanes that are asked about";
}

TEST(NearPeer, QueriesComeToThePeersWorld) {
  const glm::dmat4 own = glm::dmat4(1),
                   other = glm::dmat4({0, 2, 0, 0}, {-2, 0, 0, 0}, {0, 0, 2, 0}, {0, 0, 4, 1});
  const NearPeer peer(sceneAt(own), sceneAt(other), glm::dmat4(1));
  EXPECT_NEAR(peer.bounds().lower.z, 2, 1e-5);
  EXPECT_NEAR(peer.bounds().upper.z, 6, 1e-5);
  alignas(64) int32_t valid[kLanes] = {-1};
  accel::OcclusionRays rays{};
  rays.orgZ[0] = 4, rays.dirX[0] = 2, rays.tFar[0] = 7;
  const QueryPacket packet = peer.packetOf({valid, rays, accel::RayKind::shadow}, 1);
  EXPECT_EQ(glm::vec3(packet.rays.orgX[0], packet.rays.orgY[0], packet.rays.orgZ[0]), glm::vec3(0));
  EXPECT_EQ(glm::vec3(packet.rays.dirX[0], packet.rays.dirY[0], packet.rays.dirZ[0]), glm::vec3(0, -1, 0));
  EXPECT_EQ(packet.rays.tFar[0], 7);
}

TEST(TileRecord, QueriesGetTheirAnswersInTheirOrder) {
  Random random(4);
  TileRecord record(2);
  QueryPacket packet = packetOf(random);
  packet.lanes = 0x0F;
  record.ask(record.add(0x10), 0, packet);
  record.add(0x20);
  record.ask(record.add(0), 1, packet);
  EXPECT_TRUE(record.asks());
  AnswerPacket some;
  some.partly = 2, some.through[1] = {0.5f, 0.25f, 1};
  AnswerWriter first, second;
  first.add({0x01}), second.add(some);
  const std::vector<std::byte> bytes = first.takeBytes();
  record.answer(1, second.takeBytes());
  record.answer(0, bytes);
  EXPECT_THROW(record.answer(0, bytes), Malformed) << "twice";
  record.replay();
  uint32_t blocked = 0;
  EXPECT_TRUE(record.recall(blocked));
  EXPECT_EQ(blocked, 0x11u);
  EXPECT_TRUE(record.recall(blocked));
  EXPECT_EQ(blocked, 0x20u);
  EXPECT_FALSE(record.recall(blocked)) << "parts pass";
  glm::vec3 through[kLanes];
  std::ranges::fill(through, glm::vec3(1));
  EXPECT_EQ(record.combine(0x4, {.colored = through}), 0x4u);
  EXPECT_EQ(through[1], some.through[1]);
}

}  // namespace
}  // namespace gluray::cluster
