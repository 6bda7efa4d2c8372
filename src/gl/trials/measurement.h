// Measures one of the ways between which EngineChoice, FrameTrials and CullingTrials choose (adr/0096). The
// fastest of some times counts, because noise only adds time. Calls no OpenGL and reads no clock. GL thread.
#pragma once
#include <algorithm>

namespace gluray::gl {

class Measurement {
 public:
  /// `times`: how many times are to be measured.
  explicit Measurement(int times) : left_(times) {}
  /// Reports a time. Returns whether it was the last one.
  bool add(double seconds) {
    seconds_ = isKnown() ? std::min(seconds_, seconds) : seconds;
    return --left_ <= 0;
  }
  /// Reports a failure, such as a frame of another load. Returns whether there were `most` of them.
  bool fails(int most) { return ++failures_ >= most; }
  bool isKnown() const { return seconds_ >= 0; }
  /// The fastest time; negative if there is none.
  double seconds() const { return seconds_; }

 private:
  double seconds_ = -1;
  int left_, failures_ = 0;
};

}  // namespace gluray::gl
