// Exports snapshots in tests: into a folder of their own, read again and checked.
#pragma once
#include "accel/testing/test_scene.h"
#include "base/testing/temporary_folder.h"
#include "saved/export/export_scene.h"
#include "saved/testing/glb_checker.h"
#include "saved/testing/libpng_encoder.h"
#include "scene/srgb.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace gluray::saved::test {

using gluray::test::makeMesh;
using gluray::test::makeSnapshot;
using gluray::test::MeshData;
using gluray::test::squareData;
using gluray::test::textOf;

/// A temporary folder, and the names of the files in it.
struct TemporaryFolderFiles : gluray::test::TemporaryFolder {
  std::set<std::string> names() const {
    std::set<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(path())) all.insert(entry.path().filename());
    return all;
  }
};

/// The file that the batches become, which the checker has nothing against. `notes`: if not null, those of
/// the export.
inline GlbFile exported(const std::vector<scene::Snapshot>& batches,
                        std::vector<std::string>* notes = nullptr) {
  const gluray::test::TemporaryFolder folder;
  std::vector<scene::SnapshotPtr> frozen;
  for (const scene::Snapshot& s : batches) frozen.push_back(std::make_shared<const scene::Snapshot>(s));
  const ExportResult result = exportScene(frozen, folder.file("a.glb"), SceneFormat::glb, test::encodePng);
  EXPECT_TRUE(result.written) << result.why;
  if (notes) *notes = result.notes;
  GlbFile file = GlbFile::parse(textOf(folder.file("a.glb")));
  EXPECT_EQ(GlbChecker(file).problems(), std::vector<std::string>());
  return file;
}
inline GlbFile exported(const scene::Snapshot& s, std::vector<std::string>* notes = nullptr) {
  return exported(std::vector<scene::Snapshot>{s}, notes);
}

/// The bytes that a program displays for linear light.
inline glm::ivec3 displayed(const glm::vec4& linear) {
  glm::ivec3 out;
  for (int c = 0; c < 3; ++c) out[c] = static_cast<int>(std::lround(255 * scene::encodedSrgb(linear[c])));
  return out;
}

}  // namespace gluray::saved::test
