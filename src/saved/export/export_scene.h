// Scenes as files of other programs: glTF 2.0 (binary), OBJ with MTL, PLY. What a frame shows, with its own
// colours, without GLuRay's light (docs/export.md). Any thread.
#pragma once
#include "saved/export/arrays/png_encoder.h"
#include "scene/snapshot.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::saved {

enum class SceneFormat : uint8_t { glb, obj, ply };

/// The format that the ending of the file's name means, in capitals or not; nullopt: none of them.
std::optional<SceneFormat> sceneFormatOf(std::string_view fileName);

struct ExportResult {
  bool written = false;
  std::string why;                 // one line: what went wrong, and what to do
  std::vector<std::string> notes;  // one line for each kind of thing that was left out or approximated
};

/// Writes what a frame shows: its batches in the order of drawing. Positions are those of the object space of
/// the first batch's first instance, so that the scenes of a time series fit together. Writes to new files
/// beside `file` (OBJ: and its MTL file and images) and renames them at the end: after a failure the earlier
/// files stay. Throws nothing.
ExportResult exportScene(const std::vector<scene::SnapshotPtr>& batches, const std::string& file, SceneFormat,
                         const PngEncoder& png);

}  // namespace gluray::saved
