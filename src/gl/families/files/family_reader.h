// Reads one [[family]] table of a family file. Keys that it does not read are mistakes. Private to
// family_file.cpp.
#pragma once
#include "gl/families/files/family_table.h"

#include <memory>
#include <string>
#include <vector>

namespace gluray::gl {

class FamilyReader : FamilyTable {
 public:
  /// Reads `table` of `file` into `family`.
  FamilyReader(const toml::table& table, const std::string& file, Family& family)
      : FamilyTable(table, file, family.mentioned, family.alternatives), family_(family) {}

  /// `known`: the families that it may inherit from. Throws FamilyError.
  void read(const std::vector<std::shared_ptr<const Family>>& known);

 private:
  /// Starts with a copy of the inherited family, if any.
  void inherit(const std::vector<std::shared_ptr<const Family>>& known);
  void readMatch();
  /// code = "any": shader programs of the family may have any statements.
  void readCode();
  void readVertex();
  void readPulling();
  void readInstance();
  void readTransform();
  void readNormals();
  void readColor();
  void readHeight();
  void readTextures();
  void readTextureUse();
  void readMaterial(FamilyMaterial& m);
  void readLights();
  void readHighlights();
  void readLightViewer();
  /// Adds the variables of named lights to those that the family mentions.
  void mentionNamedLights();
  void readPbr();
  void readFog();
  void readImpostors();
  void readShape();
  void readSentBillboards();
  void readEdges();
  void readPass();
  void readVolume();
  void readVolumeSpan(FamilyVolume& volume);
  void readVolumeLight(FamilyVolumeLight& light);

  Family& family_;
};

}  // namespace gluray::gl
