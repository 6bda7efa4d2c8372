#include "saved/export/export_scene.h"

#include "base/printable.h"
#include "saved/export/formats/glb_writer.h"
#include "saved/export/formats/obj_writer.h"
#include "saved/export/formats/ply_writer.h"
#include "saved/export/gather/gather_scene.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <exception>
#include <new>

namespace gluray::saved {
namespace {

Abilities abilitiesOf(SceneFormat format) {
  Abilities abilities;
  if (format == SceneFormat::glb) return abilities;
  const bool obj = format == SceneFormat::obj;
  abilities.textures = abilities.lines = obj;
  abilities.otherViews = abilities.camera = abilities.instances = false;
  abilities.materials = obj ? Abilities::Materials::classic : Abilities::Materials::none;
  return abilities;
}

/// What to do about an error of the system.
std::string adviceFor(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG: return "; free some space, or choose another folder";
    case ENOENT:
    case ENOTDIR: return "; make the folder first";
    case EACCES:
    case EPERM:
    case EROFS: return "; choose a folder and a file that you may write";
    default: return "";
  }
}

std::string write(const ExportedScene& scene, const std::string& file, SceneFormat format) {
  std::string why;
  files::Draft draft(file);
  if (draft.why().empty()) {
    if (format == SceneFormat::glb) why = writeGlb(scene, draft);
    if (format == SceneFormat::ply) why = writePly(scene, draft);
    if (format == SceneFormat::obj) why = writeObj(scene, file, draft);
    if (why.empty() && format != SceneFormat::obj) draft.place();
  }
  return why.empty() && !draft.why().empty() ? draft.why() + adviceFor(draft.error()) : why;
}

}  // namespace

std::optional<SceneFormat> sceneFormatOf(std::string_view fileName) {
  const size_t dot = fileName.rfind('.');
  if (dot == std::string_view::npos) return {};
  std::string ending(fileName.substr(dot + 1));
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (ending == "glb") return SceneFormat::glb;
  if (ending == "obj") return SceneFormat::obj;
  if (ending == "ply") return SceneFormat::ply;
  return {};
}

ExportResult exportScene(const std::vector<scene::SnapshotPtr>& batches, const std::string& file,
                         SceneFormat format, const PngEncoder& png) {
  ExportResult result;
  try {
    ExportedScene scene = gatherScene(batches, abilitiesOf(format));
    scene.png = png;
    result.notes.assign(scene.notes.begin(), scene.notes.end());
    const bool empty = std::all_of(scene.views.begin(), scene.views.end(),
                                   [](const ExportedView& view) { return view.nodes.empty(); });
    result.why = empty ? "the frame shows no surface that can be written" : write(scene, file, format);
  } catch (const std::bad_alloc&) {
    result.why = "memory ran out; show less, or free some memory";
  } catch (const std::exception& error) { result.why = error.what(); }
  result.written = result.why.empty();
  if (!result.written) result.why = "cannot write " + printable(file) + ": " + result.why;
  return result;
}

}  // namespace gluray::saved
