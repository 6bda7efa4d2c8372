// Shared by the tests of impostors whose billboards the program sends: programs of spheres and of sticks,
// their arrays, and their family files. For program_sent_impostors_test.cpp and
// program_sent_refused_test.cpp.
#pragma once
#include "tests/reference/programs/impostors/own_impostors.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace gluray::test {

/// Vertices of billboards: those of one impostor follow each other.
struct SentImpostors {
  bool sticks = false;
  std::vector<glm::vec4> places;  // with the radius
  std::vector<glm::vec3> paints, tips, tipPaints;
  std::vector<float> caps, corners;
  std::vector<GLushort> numbers;  // of triangles
  uint32_t cornersEach() const { return sticks ? 8 : 4; }
  GLsizei numbersEach() const { return sticks ? 36 : 6; }

  void addSphere(const glm::vec3& center, float radius, const glm::vec3& paint);
  /// `bits`: first end closed, second end closed, first round, second round, colours interpolated.
  void addStick(const glm::vec3& from, const glm::vec3& to, float radius, int bits, const glm::vec3& first,
                const glm::vec3& second);

 private:
  void addCorners();
};

/// Many spheres, and sticks of all kinds of ends, about the origin.
SentImpostors manySpheres();
SentImpostors manySticks();

struct SentView {
  View view = perspectiveView(35);
  bool parallel = false;
  float scale = 1;
  bool roundCaps = true;
  float blend = 0, opacity = 1;
};

/// Makes the program, uploads all, sets the view; draw with drawSent().
void prepareSent(Gl gl, const SentImpostors& sent, const SentView& look);
void drawSent(Gl gl, const SentImpostors& sent);
/// The family file of the program that prepareSent() makes.
std::string sentFamily(bool sticks, bool parallel);

}  // namespace gluray::test
