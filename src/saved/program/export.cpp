#include "saved/export/export_scene.h"
#include "saved/program/render.h"
#include "saved/scene/saved_scene.h"

#include <cstdio>
#include <exception>
#include <stdexcept>

namespace gluray::saved {
namespace {

std::string png(const GlurayExportRequest& request, const PngPixels& pixels) {
  std::string file;
  const auto take = [](void* into, const void* bytes, unsigned long size) {
    static_cast<std::string*>(into)->assign(static_cast<const char*>(bytes), size);
  };
  if (!request.png(request.user, pixels.width, pixels.height, pixels.alpha ? 4 : 3, pixels.bytes.data(), take,
                   &file))
    throw std::runtime_error("an image cannot be made a PNG file");
  return file;
}

/// Throws std::runtime_error with one line.
void exportSaved(const GlurayExportRequest& request) {
  if (request.version != kGlurayRenderVersion)
    throw std::runtime_error("install GLuRay again: its library is of another version");
  const std::optional<SceneFormat> format = sceneFormatOf(request.file);
  if (!format) throw std::runtime_error("use a name that ends in .glb, .obj or .ply");
  const SavedScene scene = readScene(request.scene);
  std::vector<scene::SnapshotPtr> batches;
  for (const SavedBatch& batch : scene.batches) batches.push_back(batch.snapshot);
  const ExportResult result = exportScene(batches, request.file, *format,
                                          [&](const PngPixels& pixels) { return png(request, pixels); });
  if (!result.written) throw std::runtime_error(result.why);
  for (const std::string& line : result.notes) request.note(request.user, line.c_str());
}

}  // namespace
}  // namespace gluray::saved

__attribute__((visibility("default"))) int glurayExport(const GlurayExportRequest* request, char* why,
                                                        unsigned long whyBytes) {
  std::snprintf(why, whyBytes, "%s", "");
  try {
    gluray::saved::exportSaved(*request);
    return 1;
  } catch (const std::exception& e) {
    std::snprintf(why, whyBytes, "%s", e.what());
    return 0;
  }
}
