// Reads the snapshots that SnapshotEncoder writes. What it reads may come from anywhere: all that tracing
// relies on is checked.
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

/// Meshes and images of earlier snapshots, which later ones share while their content is the same.
class DecodedParts {
 public:
  struct Mesh {
    std::weak_ptr<const scene::Mesh> mesh;
    uint32_t materials = 0;  // that its vertices refer to: instances have at least as many
  };
  std::unordered_map<Hash128, Mesh> meshes;
  std::unordered_map<Hash128, std::weak_ptr<const scene::TextureImage>> images;
  /// Forgets what is gone.
  void forgetGone();
};

/// One thread.
class SnapshotDecoder {
 public:
  /// `pages`: for snapshots with pages; null: such are Malformed.
  explicit SnapshotDecoder(FindArray arrays, PageSource* pages = nullptr)
      : arrays_(std::move(arrays)), pages_(pages) {}

  /// Throws Malformed where the message is none of SnapshotEncoder or names arrays that are not known;
  /// std::bad_alloc.
  std::shared_ptr<scene::Snapshot> decode(std::span<const std::byte> message);

 private:
  FindArray arrays_;
  PageSource* pages_;
  DecodedParts parts_;
  size_t partsAfterForgetting_ = 0;
};

}  // namespace gluray::cluster
