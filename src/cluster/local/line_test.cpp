#include "cluster/local/line.h"

#include "cluster/stream/byte_stream.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <thread>
#include <utility>
#include <vector>

namespace gluray::cluster {
namespace {

constexpr int kPatienceMs = 20000;

std::pair<Line, Line> ends() {
  std::array<int, 2> sockets{};
  EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()), 0);
  return {Line(Descriptor(sockets[0])), Line(Descriptor(sockets[1]))};
}

std::vector<std::byte> numbered(size_t size) {
  std::vector<std::byte> bytes(size);
  for (size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::byte>(i * 7 + i / 256);
  return bytes;
}

TEST(Line, MessagesArriveInOrderWhateverTheirSize) {
  auto [here, there] = ends();
  const std::vector<size_t> sizes{0, 1, 70000, 3, size_t{9} << 20, 0};
  std::thread sender([&line = here, &sizes] {
    for (size_t i = 0; i < sizes.size(); ++i)
      EXPECT_TRUE(line.send(static_cast<uint16_t>(i), numbered(sizes[i]), -1, kPatienceMs));
  });
  for (size_t i = 0; i < sizes.size(); ++i) {
    const auto message = there.receive(kPatienceMs);
    ASSERT_TRUE(message);
    EXPECT_EQ(message->type, i);
    EXPECT_TRUE(message->body == numbered(sizes[i]));
    EXPECT_LT(message->attached.get(), 0);
  }
  sender.join();
  EXPECT_FALSE(there.receive());
}

TEST(Line, SealedMemoryGoesWithMessages) {
  auto [here, there] = ends();
  const std::vector<std::byte> content = numbered(100000);
  const Descriptor memory =
      sealedMemory(content.size(), [&](std::byte* to) { std::memcpy(to, content.data(), content.size()); });
  ASSERT_TRUE(here.send(1, {}, memory.get(), kPatienceMs));
  ASSERT_TRUE(here.send(2, numbered(10), -1, kPatienceMs));
  Array array;
  {
    const auto message = there.receive(kPatienceMs);
    ASSERT_TRUE(message && message->attached.get() >= 0);
    EXPECT_THROW(mapSealed(message->attached, content.size() - 1), Malformed);
    array = mapSealed(message->attached, content.size());
  }
  EXPECT_EQ(std::memcmp(array.bytes.data(), content.data(), content.size()), 0);
  EXPECT_EQ(array.bytes.data()[content.size() + kArrayPadding - 1], std::byte{0});
  const auto second = there.receive(kPatienceMs);
  ASSERT_TRUE(second);
  EXPECT_EQ(second->type, 2);
  EXPECT_LT(second->attached.get(), 0);
  EXPECT_LT(pwrite(memory.get(), "x", 1, 0), 0);  // sealed at this end, too
}

size_t mappings() {
  std::ifstream file("/proc/self/maps");
  return static_cast<size_t>(
      std::count(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>(), '\n'));
}

TEST(Line, ManySmallArraysTakeFewMappings) {
  const std::vector<std::byte> content = numbered(5000);
  const Descriptor memory =
      sealedMemory(content.size(), [&](std::byte* to) { std::memcpy(to, content.data(), content.size()); });
  const size_t before = mappings();
  std::vector<Array> arrays;
  for (int i = 0; i < 1000; ++i) arrays.push_back(mapSealed(memory, content.size()));
  EXPECT_LT(mappings(), before + 100);
  for (const Array& array : arrays) {
    EXPECT_EQ(array.bytes.size(), content.size());
    EXPECT_EQ(std::memcmp(array.bytes.data(), content.data(), content.size()), 0);
    EXPECT_EQ(array.bytes.data()[content.size() + kArrayPadding - 1], std::byte{0});
  }
}

TEST(Line, MemoryThatMayChangeIsRefused) {
  Descriptor open(memfd_create("test", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  ASSERT_EQ(ftruncate(open.get(), 4096 + kArrayPadding), 0);
  EXPECT_THROW(mapSealed(open, 4096), Malformed);
  std::array<int, 2> pipes{};
  ASSERT_EQ(pipe(pipes.data()), 0);
  EXPECT_THROW(mapSealed(Descriptor(pipes[0]), 0), Malformed);
  close(pipes[1]);
}

TEST(Line, WhatIsNoMessageEndsIt) {
  for (const char* const said : {"GET / HTTP/1.1\r\n\r\n", "yRLG0123456789abcdef", ""}) {
    auto [here, there] = ends();
    ASSERT_EQ(::send(here.descriptor(), said, std::strlen(said), 0), static_cast<ssize_t>(std::strlen(said)));
    here = Line(Descriptor());
    EXPECT_FALSE(there.receive(kPatienceMs)) << said;
    EXPECT_TRUE(there.isBroken());
  }
}

TEST(Line, AnEndThatSaysNothingOrReadsNothingIsGivenUp) {
  auto [here, there] = ends();
  EXPECT_FALSE(there.receive(30));
  EXPECT_FALSE(there.isBroken());
  EXPECT_FALSE(here.send(1, numbered(size_t{16} << 20), -1, 30));
}

/// The host program closes our socket and gets its number for one of its own.
TEST(Line, AnotherSocketWithTheSameNumberIsLeftAlone) {
  std::array<int, 2> theirs{};
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, theirs.data()), 0);
  int number = -1;
  {
    auto [here, there] = ends();
    number = here.descriptor();
    ASSERT_EQ(dup2(theirs[0], number), number);
    ASSERT_EQ(::write(theirs[1], "theirs", 6), 6);
    EXPECT_FALSE(here.send(1, numbered(10), -1, kPatienceMs));
    EXPECT_FALSE(here.receive(kPatienceMs));
    EXPECT_TRUE(here.isBroken());
  }
  EXPECT_GE(fcntl(number, F_GETFD), 0) << "the host's socket was closed";
  std::array<char, 16> text{};
  EXPECT_EQ(recv(number, text.data(), text.size(), MSG_DONTWAIT), 6);
  EXPECT_EQ(recv(theirs[1], text.data(), text.size(), MSG_DONTWAIT), -1) << "the host's peer got our bytes";
  for (const int socket : {number, theirs[0], theirs[1]}) close(socket);
}

TEST(Line, AMessageThatPromisesMoreThanItHasTakesNoMemory) {
  auto [here, there] = ends();
  const std::array<uint64_t, 2> head{0x7952'4c47, Line::kMaxBytes};
  ASSERT_EQ(::send(here.descriptor(), head.data(), sizeof head, 0), static_cast<ssize_t>(sizeof head));
  here = Line(Descriptor());
  EXPECT_FALSE(there.receive(kPatienceMs));
}

}  // namespace
}  // namespace gluray::cluster
