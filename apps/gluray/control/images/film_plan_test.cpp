#include "control/images/film_plan.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace gluray::launcher {
namespace {

FilmName nameOf(const std::string& text) {
  FilmName name;
  EXPECT_EQ(readFilmName(text, name), "");
  return name;
}

TEST(FilmPlan, FilesAreNumbered) {
  EXPECT_EQ(nameOf("a/turn-%04d.png").file(7), "a/turn-0007.png");
  EXPECT_EQ(nameOf("turn%d-x.png").file(12), "turn12-x.png");
  EXPECT_EQ(nameOf("turn.png").file(1), "turn-0001.png");
  EXPECT_EQ(nameOf("turn_.png").file(12345), "turn_12345.png");
  EXPECT_EQ(nameOf("turn.png").pattern(), "turn-%04d.png");
  EXPECT_EQ(nameOf("%d.png").pattern(), "%d.png");
}

TEST(FilmPlan, WrongNamesAreRefused) {
  FilmName name;
  for (const char* text : {"turn.jpg", ".png", "a/.png", "turn-%04d", "turn-%s.png", "%d%d.png", "%4d.png",
                           "%%d.png", "%00d.png", "%010d.png", "turn%.png", "100%.png"})
    EXPECT_NE(readFilmName(text, name), "") << text;
}

TEST(FilmPlan, RampsAreLinear) {
  Ramp ramp;
  EXPECT_EQ(readRamp("lights.azimuth=-90..90", ramp), "");
  EXPECT_EQ(ramp.value(1, 3), -90.0);
  EXPECT_EQ(ramp.value(2, 3), 0.0);
  EXPECT_EQ(ramp.value(3, 3), 90.0);
  EXPECT_EQ(ramp.value(1, 1), -90.0);
  EXPECT_TRUE(ramp.value(2, 3).is_number_float());
  EXPECT_EQ(readRamp("ao.samples=1..4", ramp), "");
  EXPECT_EQ(ramp.value(2, 3), 3);
  EXPECT_TRUE(ramp.value(2, 3).is_number_integer());
  EXPECT_EQ(readRamp("ao.radius=.5..1.25", ramp), "");
  EXPECT_EQ(ramp.from, 0.5);
  EXPECT_EQ(ramp.to, 1.25);
}

TEST(FilmPlan, WrongRampsAreRefused) {
  Ramp ramp;
  for (const auto& [text, why] :
       {std::pair("ao.samples=1", "use NAME=FROM..TO"), std::pair("1..2", "use NAME=FROM..TO"),
        std::pair("ao.sample=1..2", "did you mean 'ao.samples'"),
        std::pair("ao.samples=0..4", "from 1 to 4096"), std::pair("ao.samples=1..x", "from 1 to 4096"),
        std::pair("ao=0..1", "one number"), std::pair("lights.azimuth=..5", "lights.azimuth")})
    EXPECT_NE(readRamp(text, ramp).find(why), std::string::npos) << text << ": " << readRamp(text, ramp);
}

TEST(FilmPlan, AProgramMakesAFilm) {
  EXPECT_EQ(filmCommand(nameOf("turn.png"), 20, false, false),
            "ffmpeg -framerate 25 -i turn-%04d.png -pix_fmt yuv420p turn.mp4");
  EXPECT_EQ(filmCommand(nameOf("a b/%d.png"), 20, true, true),
            "ffmpeg -framerate 25 -i 'a b/%d.png' -frames:v 20 -vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2' -pix_fmt "
            "yuv420p 'a b/film.mp4'");
  EXPECT_EQ(filmCommand(nameOf("-it's.png"), 2, false, false),
            "ffmpeg -framerate 25 -i './-it'\\''s-%04d.png' -pix_fmt yuv420p './-it'\\''s.mp4'");
}

}  // namespace
}  // namespace gluray::launcher
