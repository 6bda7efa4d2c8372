// Requirements of a flush for its images. GL thread.
#pragma once

namespace gluray::gl {

struct ImageWish {
  bool mayRepeat = true;  // the last image, if nothing has changed; false: the frame is being measured
  bool finished =
      false;             // light only with as little noise as the settings want: the program reads the pixels
  bool asShown = false;  // an earlier frame's image with the noise that it had
  bool anew = false;     // no visibility of earlier frames: their scene was another one
};

}  // namespace gluray::gl
