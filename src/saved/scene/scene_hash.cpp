#include "saved/scene/scene_hash.h"

#include "base/hash.h"
#include "cluster/stream/snapshot_encoder.h"

#include <array>
#include <cstdio>

namespace gluray::saved {

std::string hashOf(const SavedScene& scene) {
  cluster::SnapshotEncoder encoder;
  HashStream stream;
  const auto add = [&](const auto& value) { stream.add(&value, sizeof value); };
  add(scene.window);
  for (const SavedBatch& batch : scene.batches) {
    scene::Snapshot s = *batch.snapshot;
    s.frame = s.view = s.viewFrame = s.swaps = s.number = 0;  // count what the program has shown before
    // The message names arrays by their content.
    const cluster::EncodedSnapshot encoded = encoder.encode(s);
    stream.add(encoded.message.data(), encoded.message.size());
    add(batch.place), add(batch.strict);
    for (const scene::Region& box : batch.cleared)
      add(std::array<int, 4>{box.x, box.y, box.width, box.height});
  }
  add(scene.shown.width), add(scene.shown.height);
  stream.add(scene.shown.pixels.data(), scene.shown.pixels.size() * sizeof(scene.shown.pixels[0]));
  const Hash128 hash = stream.finishHash();
  char text[33];
  std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(hash.high),
                static_cast<unsigned long long>(hash.low));
  return text;
}

}  // namespace gluray::saved
