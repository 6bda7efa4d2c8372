// Names of a picture's surfaces, for layers of objects and materials. Any thread.
#pragma once
#include "saved/shot/shot.h"

#include <cstdint>
#include <string>
#include <vector>

namespace gluray::saved {

/// One entry per instance of all batches, in the order of drawing; after those of a batch one for its ground.
struct SurfaceNames {
  std::vector<std::string> objects;    // "object 3" by its number (`gluray objects`), "ground", "other"
  std::vector<std::string> materials;  // the kind and the own colour: "glass #c0ffff", "program by vertex"
  std::vector<size_t> first;           // of each batch
  bool numbered = false;               // some object has a number
};

SurfaceNames surfaceNames(const std::vector<Shot::Placed>& batches);

}  // namespace gluray::saved
