// What a program shows, in a file: the batches of a frame, in the order of drawing, and what the window
// showed. Rendered again, they give the pictures that the program would have got. Any thread.
#pragma once
#include "saved/sections/saved_picture.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace gluray::saved {

/// A traced batch.
struct SavedBatch {
  scene::SnapshotPtr snapshot;
  glm::ivec2 place{0};                 // of the lower left corner of its framebuffer in the window, pixels
  bool strict = true;                  // surfaces of equal depth do not replace earlier batches
  std::vector<scene::Region> cleared;  // of its framebuffer: depths that were cleared before it
};

struct SavedScene {
  std::vector<SavedBatch> batches;
  glm::ivec2 window{0};  // size in pixels
  SavedPicture shown;    // empty: not known
  /// Facts for people: "program", "version", "host", "saved" (a time, ISO 8601); texts.
  nlohmann::json facts = nlohmann::json::object();
};

/// Writes the scene. Empty, or one line that says why it could not be written: then a file of this name stays
/// as it was. `given`: into an empty file that exists (SectionWriter::Given). Scenes with pages of other
/// processes (scene::Residence) and volumes are refused.
std::string saveScene(const SavedScene& scene, const std::string& path, bool given = false);

/// Reads a scene. Its arrays stay in the file and are read where they are used. Throws std::runtime_error
/// with one line.
SavedScene readScene(const std::string& path);

}  // namespace gluray::saved
