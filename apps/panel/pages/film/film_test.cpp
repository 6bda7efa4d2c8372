#include "model/film.h"

#include "pages/film/film_dialog.h"
#include "testing/fake_program.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>

namespace gluray::panel {
namespace {

using nlohmann::json;

struct FilmTest : testing::Test {
  void SetUp() override { program.appear(); }
  FilmPlan plan(int frames) { return {folder.path(), "a", frames, "", 0, 0, false}; }
  Film& make(FilmPlan what) {
    film = std::make_unique<Film>(program.controls, std::move(what), nullptr);
    QObject::connect(film.get(), &Film::finished, film.get(), [this](const QString& why) { ended << why; });
    film->start();
    return *film;
  }
  QStringList files() const { return QDir(folder.path()).entryList(QDir::Files, QDir::Name); }

  QTemporaryDir folder;
  FakeProgram program;
  std::unique_ptr<Film> film;
  QStringList ended;
};

TEST_F(FilmTest, SavesOneImageAfterTheOther) {
  make(plan(3));
  ASSERT_TRUE(program.until([&] { return !ended.isEmpty(); }));
  EXPECT_EQ(ended, QStringList{""});
  EXPECT_EQ(files(), (QStringList{"a-0001.png", "a-0002.png", "a-0003.png"}));
  EXPECT_EQ(QImage(folder.filePath("a-0003.png")).size(), QSize(40, 30));
  EXPECT_EQ(program.calls("shot").size(), 3u);
  EXPECT_TRUE(program.sets().empty());
}

TEST_F(FilmTest, ASettingChangesOverTheFilmAndIsAfterwardsWhatItWas) {
  program.say("lights.azimuth", 12);
  FilmPlan what = plan(5);
  what.setting = "lights.azimuth", what.from = 10, what.to = 30;
  make(what);
  ASSERT_TRUE(program.until([&] { return !ended.isEmpty(); }));
  program.settle();
  std::vector<json> values;
  for (const json& set : program.sets()) {
    values.push_back(set["values"]["lights.azimuth"]);
    EXPECT_EQ(set["gesture"], program.sets()[0]["gesture"]);
  }
  EXPECT_EQ(values, (std::vector<json>{10.0, 15.0, 20.0, 25.0, 30.0, 12}));
}

TEST_F(FilmTest, CancelledInTheMiddleKeepsWhatIsThere) {
  FilmPlan what = plan(1000);
  what.setting = "spp", what.from = 1, what.to = 64, what.whole = true;
  Film& running = make(what);
  QObject::connect(&running, &Film::progressed, &running, [&](int saved) {
    if (saved == 4) running.stop();
  });
  ASSERT_TRUE(program.until([&] { return !ended.isEmpty(); }));
  EXPECT_EQ(ended, QStringList{""});
  const size_t shots = program.calls("shot").size();
  QTest::qWait(50);
  EXPECT_EQ(program.calls("shot").size(), shots) << "no further one";
  EXPECT_EQ(files().size(), 4);
  EXPECT_EQ(program.sets()[1]["values"]["spp"], 1) << "a whole number";
  EXPECT_EQ(program.sets().back()["values"], json({{"spp", nullptr}})) << "what the other layers say";
  EXPECT_EQ(ended.size(), 1);
}

TEST_F(FilmTest, EndsWithItsProgramOrAShotThatFails) {
  Film& running = make(plan(0));
  ASSERT_TRUE(program.until([&] { return running.saved() > 1; }));
  program.end();
  EXPECT_EQ(ended, QStringList{"the program has ended"});
  EXPECT_GE(files().size(), 2);
  ended.clear();
  program.appear();
  program.refusals["shot"] = "no frame came";
  FilmPlan what = plan(2);
  what.name = "b";
  make(what);
  ASSERT_TRUE(program.until([&] { return !ended.isEmpty(); }));
  EXPECT_EQ(ended, QStringList{"no frame came"});
}

TEST_F(FilmTest, ReplacesNoFile) {
  QFile other(folder.filePath("a-0002.png"));
  ASSERT_TRUE(other.open(QIODevice::WriteOnly));
  other.write("mine");
  other.close();
  make(plan(3));
  ASSERT_TRUE(program.until([&] { return !ended.isEmpty(); }));
  EXPECT_TRUE(ended[0].endsWith("a-0002.png exists already"));
  ASSERT_TRUE(other.open(QIODevice::ReadOnly));
  EXPECT_EQ(other.readAll(), "mine");
}

struct FilmDialogTest : FilmTest {
  void SetUp() override {
    FilmTest::SetUp();
    dialog.show();
    part<QLineEdit>("film-folder").setText(folder.path());
  }
  template <class Widget>
  Widget& part(const char* name) {
    return *dialog.findChild<Widget*>(name);
  }
  QString message() { return part<QLabel>("film-message").text(); }
  FilmDialog dialog{program.controls, nullptr};
};

TEST_F(FilmDialogTest, MakesAndCancels) {
  auto& start = part<QPushButton>("film-start");
  part<QSpinBox>("film-frames").setValue(100000);
  start.click();
  EXPECT_EQ(start.text(), "C&ancel");
  EXPECT_FALSE(part<QLineEdit>("film-name").isEnabled());
  auto* progress = dialog.findChild<QProgressBar*>();
  ASSERT_TRUE(program.until([&] { return progress->value() > 2; }));
  start.click();
  EXPECT_EQ(start.text(), "&Start");
  EXPECT_TRUE(message().contains("images are saved in " + folder.path())) << message().toStdString();
  EXPECT_TRUE(part<QLineEdit>("film-name").isEnabled());
  EXPECT_GE(files().size(), 3);
}

TEST_F(FilmDialogTest, SaysWhatIsWrongBeforeItBegins) {
  auto& start = part<QPushButton>("film-start");
  part<QLineEdit>("film-folder").setText(folder.filePath("none"));
  start.click();
  EXPECT_TRUE(message().startsWith("There is no folder"));
  part<QLineEdit>("film-folder").setText(folder.path());
  part<QLineEdit>("film-name").setText("a/b");
  start.click();
  EXPECT_EQ(message(), "Type a name without slashes.");
  part<QLineEdit>("film-name").setText("b");
  part<QComboBox>("film-setting").setCurrentText("Key light azimuth");
  EXPECT_EQ(part<QDoubleSpinBox>("film-to").maximum(), 360);
  EXPECT_EQ(part<QDoubleSpinBox>("film-from").value(), 30);
  part<QSpinBox>("film-frames").setValue(0);
  start.click();
  EXPECT_EQ(message(), "A varying setting needs a number of images.");
  program.end();
  start.click();
  EXPECT_EQ(message(), "No program is chosen.");
  EXPECT_TRUE(program.calls("shot").empty());
}

TEST_F(FilmDialogTest, ClosingItStopsTheFilm) {
  part<QSpinBox>("film-frames").setValue(0);
  part<QPushButton>("film-start").click();
  ASSERT_TRUE(program.until([&] { return files().size() > 1; }));
  dialog.close();
  QTest::qWait(20);
  const size_t shots = program.calls("shot").size();
  QTest::qWait(50);
  EXPECT_EQ(program.calls("shot").size(), shots);
}

}  // namespace
}  // namespace gluray::panel
