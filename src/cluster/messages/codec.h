// Serialises messages: fields() lists their members, and the archives of cluster/stream write them. A message
// is a struct with a number, kType. Any thread.
#pragma once
#include "base/hash.h"
#include "base/image.h"
#include "cluster/stream/archive.h"
#include "cluster/stream/tile_pixels.h"
#include "scene/trace_cost.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gluray::cluster {

void fields(auto& archive, Like<Hash128> auto& value) {
  auto& [low, high] = value;
  archive(low, high);
}
void fields(auto& archive, Like<LayerCounts> auto& value) {
  auto& [open, before] = value;
  archive(open, before);
}
void fields(auto& archive, Like<scene::TraceCost> auto& value) {
  auto& [buildSeconds, traceSeconds, blasBuilds, tlasBuilds, blasRefinements, bvhBytes, blasRefining,
         elsewhere, refined, loss] = value;
  archive(buildSeconds, traceSeconds, blasBuilds, tlasBuilds, blasRefinements, bvhBytes, blasRefining,
          elsewhere, refined, loss);
}

class WriteMessage : public WriteArchive<WriteMessage> {
 public:
  using WriteArchive::value;
  void value(const std::string& text) {
    out_.put(static_cast<uint64_t>(text.size()));
    out_.put(text.data(), text.size());
  }
  void value(const ImageShape& shape) { write(out_, shape); }
  void value(const std::vector<std::byte>& bytes) {
    out_.put(static_cast<uint64_t>(bytes.size()));
    out_.put(bytes.data(), bytes.size());
  }
  ByteWriter& out() { return out_; }
};

class ReadMessage : public ReadArchive<ReadMessage> {
 public:
  using ReadArchive::ReadArchive;
  using ReadArchive::value;
  void value(std::string& text) {
    const auto bytes = in_.readBytes(in_.count(1));
    text.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  }
  void value(ImageShape& shape) { shape = readShape(in_); }
  void value(std::vector<std::byte>& bytes) {
    const auto taken = in_.readBytes(in_.count(1));
    bytes.assign(taken.begin(), taken.end());
  }
  ByteReader& in() { return in_; }
};

/// Serialises the members only.
template <class M>
std::vector<std::byte> encoded(const M& message) {
  WriteMessage archive;
  archive(message);
  return archive.out().takeBytes();
}
/// Throws Malformed.
template <class M>
M decoded(std::span<const std::byte> bytes) {
  ReadMessage archive(bytes);
  M message;
  archive(message);
  if (archive.in().left() != 0) throw Malformed("it is too long");
  return message;
}

/// Serialises the number and the members, for messages between ranks.
template <class M>
std::vector<std::byte> forRanks(const M& message) {
  WriteMessage archive;
  archive.out().put(M::kType);
  archive(message);
  return archive.out().takeBytes();
}

}  // namespace gluray::cluster
