#include "tests/fuzz/stream.h"

#include <array>
#include <iterator>

namespace gluray::fuzz {
namespace {

class Grammar {
 public:
  Grammar(uint64_t seed, bool alone) : random_(seed) {
    static constexpr uint32_t kWeird[] = {0, 0, 1, 2, 10};
    stream_.weird = kWeird[random_.below(std::size(kWeird))];
    stream_.smallBuffers = random_.chance(25);
    stream_.askErrors = random_.chance(30);
    stream_.tame = stream_.weird == 0 && random_.chance(50);
    if (stream_.tame) stream_.smallBuffers = false;
    stream_.attributeSize = 1 + static_cast<int>(random_.below(4));
    if (alone) {
      constexpr Engine kEngines[] = {Engine::always,    Engine::always, Engine::always,   Engine::always,
                                     Engine::automatic, Engine::never,  Engine::automatic};
      stream_.engine = kEngines[random_.below(std::size(kEngines))];
      programs_ = random_.chance(60) ? 25 : 0;
      calm_ = random_.chance(80) ? 20 : 0;
    }
    length_ = 200 + random_.below(4000);
    // Each stream emphasises different kinds of calls.
    for (uint32_t& weight : weights_) weight = random_.chance(25) ? 0 : 1 + random_.below(10);
  }

  Stream make() {
    while (stream_.calls.size() < length_) block(0);
    return std::move(stream_);
  }

 private:
  static constexpr int kBlocks = 14;

  void add(Ops ops, uint32_t times = 1) {
    for (uint32_t i = 0; i < times; ++i) {
      uint32_t total = 0;
      for (const Op& op : ops) total += op.weight;
      uint32_t ticket = random_.below(total);
      const Op* chosen = ops.data();
      while (ticket >= chosen->weight) ticket -= (chosen++)->weight;
      stream_.calls.push_back({chosen, random_.next()});
    }
  }
  uint32_t few() { return 1 + random_.below(5); }

  /// glBegin, vertices with attributes, glEnd; rarely with a misplaced call between them.
  void primitive(int depth) {
    add(beginCalls());
    const uint32_t calls = random_.chance(5) ? random_.below(400) : random_.below(40);
    for (uint32_t i = 0; i < calls; ++i) {
      if (random_.chance(6))
        add(vertexCalls());
      else if (!stream_.tame && random_.below(300) == 0)
        block(depth + 1);
      else if (depth == 0 && random_.below(100) == 0)
        add(callAttributesCalls());
      else
        add(vertexAttributeCalls());
    }
    if (stream_.tame || !random_.chance(2)) add(endCalls());
  }

  void list(int depth) {
    add(newListCalls());
    for (uint32_t n = random_.below(6); n > 0; --n) block(depth + 1);
    if (stream_.tame || !random_.chance(2)) add(endListCalls());
  }

  void attributeList() {
    add(newAttributeListCalls());
    for (uint32_t n = random_.below(6); n > 0; --n) add(attributeCalls());
    add(endListCalls());
  }

  void arrays() {
    add(arrayCalls(), few() + 2);
    if (random_.chance(30)) add(bufferCalls(), few());
    add(drawCalls(), few());
  }

  void programs() {
    add(programCalls(), few() + 2);
    if (random_.chance(20)) add(bufferCalls(), few());
    add(drawCalls(), few());
  }

  void block(int depth) {
    if (depth > 3) return add(vertexAttributeCalls(), few());
    if (calm_ && random_.chance(calm_)) add(calmCalls());
    if (programs_ && random_.chance(programs_)) return programs();
    uint32_t total = 8;
    for (uint32_t weight : weights_) total += weight;
    uint32_t ticket = random_.below(total);
    int kind = 0;
    while (kind < kBlocks && ticket >= weights_[static_cast<size_t>(kind)])
      ticket -= weights_[static_cast<size_t>(kind++)];
    switch (kind) {
      case 0: return list(depth);
      case 1: return random_.chance(20) ? attributeList() : add(listCalls(), few());
      case 2: return arrays();
      case 3: return add(bufferCalls(), few());
      case 4: return add(stateCalls(), few());
      case 5: return add(lightCalls(), few());
      case 6: return add(matrixCalls(), few());
      case 7: return add(stackCalls(), few());
      case 8: return add(textureCalls(), few());
      case 9: return add(askCalls(), few());
      case 10: return stream_.tame ? primitive(depth) : add(pixelCalls(), few());
      case 11: return stream_.tame ? primitive(depth) : add(targetCalls(), few());
      case 12: return stream_.tame ? primitive(depth) : add(queryCalls(), few());
      case 13: return add(frameCalls());
      default: return primitive(depth);
    }
  }

  Random random_;
  Stream stream_;
  size_t length_ = 0;
  uint32_t programs_ = 0;  // percentage of blocks with shader programs
  uint32_t calm_ = 0;      // percentage of blocks that first reset the state so that surfaces are traced
  std::array<uint32_t, kBlocks> weights_{};
};

}  // namespace

Stream makeStream(uint64_t seed, bool alone) { return Grammar(seed, alone).make(); }

}  // namespace gluray::fuzz
