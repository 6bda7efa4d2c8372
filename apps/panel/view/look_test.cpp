// Options of looks, and the command lines of pictures.
#include "view/look.h"

#include "view/saved_picture.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

namespace gluray::panel {
namespace {

using Texts = std::vector<std::string>;

const std::vector<Preset> kPresets{
    {"one", "", {{"spp", "2", "", ""}, {"ao", "true", "", ""}, {"spp", "3", "", ""}}},
    {"quality-good", "", {{"spp", "8", "", ""}, {"noise", "x", "", "wrong"}}}};

TEST(LookOptions, LaterValuesReplaceEarlierOnes) {
  EXPECT_EQ(LookOptions().settings(kPresets), Texts());
  EXPECT_EQ(LookOptions({"one", "", {}}).settings(kPresets), (Texts{"spp=3", "ao=true"}));
  EXPECT_EQ(LookOptions({"one", "good", {}}).settings(kPresets), (Texts{"spp=8", "ao=true"}));
  EXPECT_EQ(LookOptions({"one", "good", {{"ao", "false"}, {"noise", "0.1"}}}).settings(kPresets),
            (Texts{"spp=8", "ao=false", "noise=0.1"}));
  EXPECT_EQ(LookOptions({"one", "good", {{"ao", "false"}}}).words(),
            QStringList({"--preset", "one", "--quality", "good", "--set", "ao=false"}));
}

TEST(PictureWish, BecomesACommand) {
  PictureWish wish{
      .scene = "a scene.gluray", .file = "-it's.png", .size = {30, 20}, .look = {"--set", "ao=true"}};
  EXPECT_EQ(commandLine(renderWords(wish)),
            "gluray render 'a scene.gluray' './-it'\\''s.png' --size 30x20 --set ao=true");
  wish.camera = GlurayCamera{{0.1, 0, 5}, {0, 0, 0}, {0, 1, 0}, 30, 1}, wish.file = "x.png";
  EXPECT_EQ(renderWords(wish).mid(5), QStringList({"--path", "x.png.camera.json", "--set", "ao=true"}));
}

TEST(PictureWish, HasItsCameraInAFile) {
  const QTemporaryDir folder;
  PictureWish wish{.file = folder.filePath("x.png")};
  wish.camera = GlurayCamera{{0.1, 0, 5}, {0, 0, 0}, {0, 1, 0}, 30, 1};
  wish.saved = GlurayCamera{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0, 2};
  ASSERT_EQ(writeCameraFile(wish), "");
  QFile file(folder.filePath("x.png.camera.json"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QByteArray text = file.readAll();
  EXPECT_TRUE(text.contains("0.1") && text.contains("view_angle") && text.contains("parallel_scale"))
      << text.constData();
  wish.camera->position[0] = 1.0 / 3;
  EXPECT_EQ(writeCameraFile(wish), "") << "its own files are replaced";
  wish.file = folder.filePath("no/folder/x.png");
  EXPECT_NE(writeCameraFile(wish), "");
}

}  // namespace
}  // namespace gluray::panel
