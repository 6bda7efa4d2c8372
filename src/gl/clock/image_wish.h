// What a flush requires of its image. GL thread.
#pragma once

namespace gluray::gl {

struct ImageWish {
  bool mayRepeat = true;  // the last image, if nothing has changed; false: the frame is being measured
  bool finished = false;  // the noise is as low as the settings demand: the program reads the pixels
  bool asShown = false;   // an earlier frame's image, with the noise that it had
  bool anew = false;      // no visibility of earlier frames: their scene was another one
  bool averages = true;   // of an image that is made anew: pixels average samples if settings ask for it
};

}  // namespace gluray::gl
