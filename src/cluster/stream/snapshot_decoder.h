// Reads the snapshots of SnapshotEncoder. The input is untrusted: the decoder checks all invariants of
// tracing.
#pragma once
#include "cluster/stream/byte_stream.h"
#include "cluster/stream/page_layout.h"
#include "cluster/stream/shared_arrays.h"
#include "scene/snapshot.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

namespace gluray::cluster {

/// Meshes and images of earlier snapshots, which later snapshots share if the content is equal.
class DecodedParts {
 public:
  struct Mesh {
    std::weak_ptr<const scene::Mesh> mesh;
    uint32_t materials = 0;  // that its vertices refer to: instances have at least as many
  };
  std::unordered_map<Hash128, Mesh> meshes;
  std::unordered_map<Hash128, std::weak_ptr<const scene::TextureImage>> images;
  /// Removes expired entries.
  void forgetGone();
};

/// One thread.
class SnapshotDecoder {
 public:
  /// `pages`: for snapshots with pages; null: these are Malformed.
  explicit SnapshotDecoder(FindArray arrays, PageSource* pages = nullptr)
      : arrays_(std::move(arrays)), pages_(pages) {}

  /// Throws Malformed if the message is invalid or uses unknown arrays; std::bad_alloc.
  std::shared_ptr<scene::Snapshot> decode(std::span<const std::byte> message);

 private:
  FindArray arrays_;
  PageSource* pages_;
  DecodedParts parts_;
  size_t partsAfterForgetting_ = 0;
};

}  // namespace gluray::cluster
