// Requirements of a flush for its pictures. GL thread.
#pragma once

namespace gluray::gl {

struct PictureWish {
  bool mayRepeat = true;  // the last picture, if nothing has changed; false: the frame is being measured
  bool finished =
      false;             // light only with as little noise as the settings want: the program reads the pixels
  bool asShown = false;  // an earlier frame's picture with the noise that it had
};

}  // namespace gluray::gl
