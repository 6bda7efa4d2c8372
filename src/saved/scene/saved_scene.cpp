#include "saved/scene/saved_scene.h"

#include "cluster/stream/snapshot_decoder.h"
#include "cluster/stream/snapshot_encoder.h"
#include "saved/sections/section_file.h"
#include "scene/secondary_scene.h"

#include <algorithm>
#include <array>
#include <exception>
#include <optional>
#include <stdexcept>
#include <unordered_map>

namespace gluray::saved {
namespace {

using nlohmann::json;

/// Of the messages of snapshots (cluster/stream/scene_fields.h). Increase it when members change.
constexpr int kFormat = 1;

bool hasPages(const std::vector<scene::Instance>& instances) {
  return std::any_of(instances.begin(), instances.end(),
                     [](const scene::Instance& i) { return i.mesh->residence != nullptr; });
}

/// What a file cannot hold; empty: nothing.
std::string obstacleIn(const scene::Snapshot& s) {
  if (hasPages(s.instances) || (s.secondaryScene && hasPages(s.secondaryScene->instances)))
    return "parts of the scene are in other processes: save it in a program of one process";
  if (!s.volumes.empty()) return "volumes cannot be saved: hide them first";
  return "";
}

void addArray(const cluster::ArraySource& array, SectionWriter& out) {
  if (out.has(array.name)) return;
  out.add(Kind::array, 0, array.name, array.bytes(), [&](const SectionWriter::Write& write) {
    if (array.stride == array.element) return write({array.data, array.bytes()});
    constexpr uint32_t kPiece = 1 << 16;  // elements
    std::vector<std::byte> piece;
    for (uint32_t first = 0; first < array.count; first += kPiece) {
      cluster::ArraySource part = array;
      part.data += size_t{first} * array.stride, part.count = std::min(kPiece, array.count - first);
      piece.resize(part.bytes());
      part.copyTo(piece.data());
      write(piece);
    }
  });
}

std::span<const std::byte> bytesOf(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

std::string textIn(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// What a file says of batches beside their snapshots.
json describe(const SavedScene& scene) {
  json all = json::array();
  for (const SavedBatch& batch : scene.batches) {
    json cleared = json::array();
    for (const scene::Region& r : batch.cleared) cleared.push_back({r.x, r.y, r.width, r.height});
    all.push_back({{"place", {batch.place.x, batch.place.y}},
                   {"strict", batch.strict},
                   {"cleared", std::move(cleared)}});
  }
  return all;
}

void readDescription(const json& from, SavedBatch& batch) {
  batch.place = {from.at("place").at(0), from.at("place").at(1)};
  batch.strict = from.at("strict");
  for (const json& r : from.at("cleared")) batch.cleared.push_back({r.at(0), r.at(1), r.at(2), r.at(3)});
}

/// Finds the arrays of a file by name.
cluster::FindArray arraysOf(const SectionFile& file) {
  auto known = std::make_shared<std::unordered_map<Hash128, std::span<const std::byte>>>();
  for (const Section& s : file.sections())
    if (s.kind == Kind::array) known->emplace(s.name, file.content(s));
  return [known, owner = file.owner()](const Hash128& name) {
    const auto found = known->find(name);
    return found == known->end() ? cluster::Array{} : cluster::Array{owner, found->second};
  };
}

/// The section of a kind, and of a number. Throws if there is none.
const Section& sectionOf(const SectionFile& file, Kind kind, uint32_t number) {
  const auto found = std::find_if(file.sections().rbegin(), file.sections().rend(),
                                  [&](const Section& s) { return s.kind == kind && s.number == number; });
  if (found == file.sections().rend()) throw std::runtime_error("it is no saved scene");
  return *found;
}

SavedScene readFrom(const SectionFile& file) {
  SavedScene scene;
  const json head = json::parse(textIn(file.content(sectionOf(file, Kind::facts, 0))));
  if (head.at("format") != kFormat)
    throw std::runtime_error("GLuRay " + head.at("facts").value("version", "of another version") +
                             " has saved it in another form: use that version, or save the scene again");
  scene.window = {head.at("window").at(0), head.at("window").at(1)};
  scene.facts = head.at("facts");
  cluster::SnapshotDecoder decoder(arraysOf(file));
  uint32_t number = 0;
  for (const json& batch : head.at("batches")) {
    SavedBatch& read = scene.batches.emplace_back();
    read.snapshot = decoder.decode(file.content(sectionOf(file, Kind::snapshot, number++)));
    readDescription(batch, read);
  }
  for (const Section& s : file.sections())
    if (s.kind == Kind::picture) scene.shown = pictureIn(file.content(s));
  return scene;
}

void write(const SavedScene& scene, SectionWriter& out) {
  const json head = {{"format", kFormat},
                     {"window", {scene.window.x, scene.window.y}},
                     {"batches", describe(scene)},
                     {"facts", scene.facts}};
  out.add(Kind::facts, 0, {}, bytesOf(head.dump(-1, ' ', false, json::error_handler_t::replace)));
  cluster::SnapshotEncoder encoder;
  uint32_t number = 0;
  for (const SavedBatch& batch : scene.batches) {
    const cluster::EncodedSnapshot encoded = encoder.encode(*batch.snapshot);
    for (const cluster::ArraySource& array : encoded.arrays) addArray(array, out);
    out.add(Kind::snapshot, number++, {}, encoded.message);
  }
  if (!scene.shown.pixels.empty()) addPicture(scene.shown, out);
}

}  // namespace

std::string saveScene(const SavedScene& scene, const std::string& path, bool given) {
  for (const SavedBatch& batch : scene.batches)
    if (std::string why = obstacleIn(*batch.snapshot); !why.empty()) return why;
  try {
    std::optional<SectionWriter> out;
    given ? out.emplace(path, SectionWriter::Given{}) : out.emplace(path);
    write(scene, *out);
    return out->finish() ? "" : out->why();
  } catch (const std::exception& e) { return "the scene cannot be saved: " + std::string(e.what()); }
}

SavedScene readScene(const std::string& path) {
  const SectionFile file(path);
  try {
    return readFrom(file);
  } catch (const json::exception&) {
    throw std::runtime_error(path + ": it is damaged: save it again");
  } catch (const std::exception& e) { throw std::runtime_error(path + ": " + e.what()); }
}

}  // namespace gluray::saved
