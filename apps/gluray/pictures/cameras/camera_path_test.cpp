// Cameras of films, and the files that they come from.
#include "base/testing/temporary_folder.h"
#include "pictures/cameras/camera_files.h"
#include "pictures/cameras/xml_elements.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace gluray::launcher {
namespace {

TEST(Splines, GoThroughTheirValuesAndRestAtTheEnds) {
  const std::vector<double> times = {0, 0.4, 1}, values = {3, -3, -5};
  for (size_t i = 0; i < times.size(); ++i) EXPECT_DOUBLE_EQ(splineAt(times, values, times[i]), values[i]);
  EXPECT_EQ(splineAt(times, values, -1), 3);
  EXPECT_EQ(splineAt(times, values, 2), -5);
  // Of ParaView 5.11, from the same keys.
  EXPECT_NEAR(splineAt(times, values, 0.1), 2.2125, 1e-12);
  EXPECT_NEAR(splineAt(times, values, 0.2), 0.4, 1e-12);
  EXPECT_NEAR(splineAt(times, values, 0.5), -3.7037037037037037, 1e-12);
  EXPECT_NEAR(splineAt(times, values, 0.9), -4.962962962962963, 1e-12);
  // Between two values: smoothly from rest to rest.
  for (const double t : {0.1, 0.5, 0.7}) EXPECT_NEAR(splineAt({0, 1}, {0, 1}, t), t * t * (3 - 2 * t), 1e-12);
}

TEST(Splines, HaveSlopesWithoutJumps) {
  const std::vector<double> times = {0, 1, 1.5, 4}, values = {0, 2, -1, 3};
  const double h = 1e-6;
  for (const double t : {1.0, 1.5}) {
    const double before = (splineAt(times, values, t) - splineAt(times, values, t - h)) / h,
                 after = (splineAt(times, values, t + h) - splineAt(times, values, t)) / h;
    EXPECT_NEAR(before, after, 1e-3) << t;
  }
}

CameraPath twoKeys() {
  CameraPath path;
  path.keys = {{0, {{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 30, 1}}, {1, {{5, 0, 0}, {0, 0, 1}, {0, 0, 2}, 40, 1}}};
  path.end = 1;
  return path;
}

TEST(CameraPaths, HaveTheirKeysAtBothEnds) {
  const CameraPath path = twoKeys();
  const std::vector<PathCamera> five = path.cameras(5);
  ASSERT_EQ(five.size(), 5u);
  EXPECT_EQ(five.front(), path.keys[0].camera);
  EXPECT_EQ(five.back(), path.keys[1].camera);
  EXPECT_NEAR(five[2].position[0], 2.5, 1e-12);
  EXPECT_NEAR(five[1].viewAngle, 30 + 10 * (3 * 0.0625 - 2 * 0.015625), 1e-12);
  EXPECT_EQ(path.cameras(0).size(), 2u);
  EXPECT_EQ(path.cameras(1).front(), path.keys[0].camera);
}

TEST(CameraPaths, TurnUpwardDirectionsEvenly) {
  const CameraPath path = twoKeys();
  for (const double t : {0.25, 0.5, 0.9}) {
    const Vector3 up = path.at(t).up;
    EXPECT_NEAR(std::hypot(up[0], up[1], up[2]), 1, 1e-12);
    EXPECT_NEAR(std::atan2(up[2], up[1]), t * M_PI / 2, 1e-12);
  }
}

TEST(CameraPaths, CanBeStraight) {
  CameraPath path = twoKeys();
  path.between = CameraPath::Between::linear;
  EXPECT_NEAR(path.at(0.25).position[0], 1.25, 1e-12);
}

struct CameraFiles : testing::Test {
  gluray::test::TemporaryFolder folder;
  std::string refusalOf(const std::string& name, const std::string& text) {
    try {
      readCameraPath({folder.write(name, text)});
    } catch (const std::runtime_error& e) {
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
      return e.what();
    }
    return "";
  }
};

const char* const kCamera =
    R"("position": [1, 2, 3], "focal_point": [0, 0, 0.5], "up": [0, 1, 0], "view_angle": 25)";

TEST_F(CameraFiles, OfJsonHaveTimesOrFrames) {
  const std::string c = kCamera;
  const CameraPath timed = readCameraPath(
      {folder.write("a.json", "{\"cameras\": [{\"time\": 2," + c + "}, {\"time\": 5," + c +
                                  "}], \"between\": \"linear\", \"saved_camera\": {" + c + "}}")});
  EXPECT_EQ(timed.begin, 2);
  EXPECT_EQ(timed.end, 5);
  EXPECT_EQ(timed.pictures, 0);
  EXPECT_EQ(timed.between, CameraPath::Between::linear);
  ASSERT_EQ(timed.saved.size(), 1u);
  EXPECT_EQ(timed.saved[0], (PathCamera{{1, 2, 3}, {0, 0, 0.5}, {0, 1, 0}, 25, 1}));
  const CameraPath counted = readCameraPath(
      {folder.write("b.json", "{\"cameras\": [{\"frame\": 1," + c + "}, {\"frame\": 30," + c + "}]}")});
  EXPECT_EQ(counted.cameras(0).size(), 30u);
  EXPECT_TRUE(counted.saved.empty());
  const CameraPath plain =
      readCameraPath({folder.write("c.json", "{\"cameras\": [{" + c + "}, {" + c + "}]}")});
  EXPECT_EQ(plain.cameras(0).size(), 2u);
  EXPECT_EQ(plain.end, 1);
}

TEST_F(CameraFiles, WithMistakesGetOneLine) {
  const std::string c = kCamera;
  const auto with = [&](const std::string& cameras) {
    return refusalOf("x.json", "{\"cameras\": [" + cameras + "]}");
  };
  EXPECT_NE(refusalOf("x.json", "{").find("no JSON"), std::string::npos);
  EXPECT_NE(refusalOf("x.json", "[]").find("use an object"), std::string::npos);
  EXPECT_NE(with("").find("no cameras"), std::string::npos);
  EXPECT_NE(with("{" + c + "}, 5").find("camera 2"), std::string::npos);
  EXPECT_NE(with("{" + c + ", \"roll\": 1}").find("\"roll\""), std::string::npos);
  EXPECT_NE(with("{" + c + ", \"parallel_scale\": 1}").find("view_angle"), std::string::npos);
  EXPECT_NE(with("{\"time\": 1, " + c + "}, {\"time\": 1, " + c + "}").find("not after"), std::string::npos);
  EXPECT_NE(with("{\"time\": 1, " + c + "}, {" + c + "}").find("all cameras"), std::string::npos);
  EXPECT_NE(with("{\"frame\": 1.5, " + c + "}").find("whole"), std::string::npos);
  EXPECT_NE(with("{\"position\": [1, 2], \"focal_point\": [0,0,0], \"up\": [0,1,0], \"view_angle\": 9}")
                .find("three"),
            std::string::npos);
  EXPECT_NE(
      with("{\"position\": [1e999, 2, 0], \"focal_point\": [0,0,0], \"up\": [0,1,0], \"view_angle\": 9}"),
      "");
  EXPECT_NE(refusalOf("x.txt", "").find("use one .json"), std::string::npos);
  EXPECT_NE(refusalOf("x.pvcc", "<a>").find("no XML"), std::string::npos);
  EXPECT_NE(refusalOf("x.pvsm", "<a/>").find("no state"), std::string::npos);
  EXPECT_THROW(readCameraPath({folder.file("missing.json")}), std::runtime_error);
}

/// A property as ParaView writes it.
std::string property(const std::string& name, std::initializer_list<const char*> values) {
  std::string text = "<Property name=\"" + name + "\" number_of_elements=\"3\">";
  int index = 0;
  for (const char* value : values)
    text += "<Element index=\"" + std::to_string(index++) + "\" value=\"" + value + "\"/>\n";
  return text + "<Domain name=\"range\"/></Property>";
}

std::string view(const char* parallel) {
  return "<Proxy group=\"views\" type=\"RenderView\" id=\"277\" servers=\"21\">" +
         property("CameraPosition", {"3", "2", "5e0"}) + property("CameraFocalPoint", {"0.1", "0.2", "0.3"}) +
         property("CameraViewUp", {"0", "1", "0.1"}) + property("CameraViewAngle", {"25"}) +
         property("CameraParallelScale", {"1.73"}) + property("CameraParallelProjection", {parallel}) +
         "</Proxy>";
}

std::string pvcc(const char* parallel) {
  return "<?xml version=\"1.0\"?>\n<!-- a <camera> -->\n<PVCameraConfiguration description='&quot;' "
         "version=\"1.0\">" +
         view(parallel) + "</PVCameraConfiguration>\n";
}

TEST_F(CameraFiles, OfParaViewAreKeys) {
  const std::string one = folder.write("a.pvcc", pvcc("0")), flat = folder.write("b.pvcc", pvcc("1"));
  EXPECT_EQ(readCamera(one), (PathCamera{{3, 2, 5}, {0.1, 0.2, 0.3}, {0, 1, 0.1}, 25, 1.73}));
  EXPECT_EQ(readCamera(flat).viewAngle, 0);
  const CameraPath path = readCameraPath({one, one, one});
  EXPECT_EQ(path.keys.size(), 3u);
  EXPECT_EQ(path.end, 2);
  EXPECT_THROW(readCameraPath({one, flat}), std::runtime_error);
  EXPECT_THROW(readCamera(folder.write("c.pvcc", "<PVCameraConfiguration/>")), std::runtime_error);
}

std::string key(const char* id, const char* time, const char* x) {
  return std::string("<Proxy group=\"animation_keyframes\" type=\"CameraKeyFrame\" id=\"") + id + "\">" +
         property("KeyTime", {time}) + property("Position", {x, "2", "5"}) +
         property("FocalPoint", {"0", "0", "0"}) + property("ViewUp", {"0", "1", "0"}) +
         property("ViewAngle", {"30"}) + property("ParallelScale", {"1"}) + "</Proxy>";
}

std::string state(const char* mode) {
  return "<ParaView><ServerManagerState version=\"5.11.0\"><Proxy type=\"AnimationScene\" id=\"1\">" +
         property("NumberOfFrames", {"11"}) +
         "</Proxy><Proxy group=\"animation\" type=\"CameraAnimationCue\" id=\"2\">" +
         "<Property name=\"AnimatedProxy\"><Proxy value=\"277\"/></Property>" + property("Mode", {mode}) +
         property("Interpolation", {"1"}) +
         "<Property name=\"KeyFrames\"><Proxy value=\"6\"/><Proxy value=\"7\"/><Proxy "
         "value=\"8\"/></Property></Proxy>" +
         key("6", "0", "3") + key("7", "0.4", "-3") + key("8", "1", "-5") + view("0") +
         "</ServerManagerState></ParaView>";
}

TEST_F(CameraFiles, OfParaViewsAnimationsPlayAsThere) {
  const CameraPath path = readCameraPath({folder.write("a.pvsm", state("0"))});
  const std::vector<PathCamera> cameras = path.cameras(0);
  ASSERT_EQ(cameras.size(), 11u);
  EXPECT_NEAR(cameras[1].position[0], 2.2125, 1e-12);
  EXPECT_NEAR(cameras[9].position[0], -4.962962962962963, 1e-12);
  ASSERT_EQ(path.saved.size(), 1u);
  EXPECT_EQ(path.saved[0].viewAngle, 25);
  std::string twice = state("0"), mixed = twice;
  twice.replace(twice.find("0.4"), 3, "1");
  EXPECT_NE(refusalOf("b.pvsm", twice).find("same time"), std::string::npos);
  const std::string order = "\"6\"/><Proxy value=\"7\"";
  mixed.replace(mixed.find(order), order.size(), "\"7\"/><Proxy value=\"6\"");
  EXPECT_EQ(readCameraPath({folder.write("c.pvsm", mixed)}).cameras(0), cameras);
  EXPECT_NE(refusalOf("b.pvsm", state("1")).find("not supported"), std::string::npos);
  EXPECT_NE(refusalOf("b.pvsm", state("2")).find("not supported"), std::string::npos);
}

TEST(Xml, IsRefusedWhenItIsBroken) {
  EXPECT_EQ(readXml("<a b='&lt;&amp;'><c/> text </a>")["b"], "<&");
  for (const char* wrong :
       {"", "text", "<", "<a", "<a b", "<a b=>", "<a b='>", "<a></b>", "<a/><b/>", "<a><!-- </a>"})
    EXPECT_THROW(readXml(wrong), std::runtime_error) << wrong;
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_THROW(readXml(deep), std::runtime_error);
}

}  // namespace
}  // namespace gluray::launcher
