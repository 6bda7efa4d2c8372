// Images that show the parts of several ranks of a program, between these ranks.
#include "cluster/worker/head.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace gluray::cluster {
namespace {

/// Gives misses of byte colours the receiver's colour.
void colorMisses(const PartImage& image, uint32_t color, std::byte* pixels) {
  const PlanePointers planes = planesIn(pixels, image.shape);
  const bool isAverages = image.shape.planes.has(Plane::centerDepth);
  if (!planes.color || isAverages || color == image.missColor) return;
  for (size_t i = 0; i < image.shape.pixels(); ++i) {
    float depth = 0;
    std::memcpy(&depth, planes.depth + i * sizeof depth, sizeof depth);
    if (depth == Image::kMiss) std::memcpy(planes.color + i * sizeof color, &color, sizeof color);
  }
}

}  // namespace

void Head::giveShown(ConnectedProgram& program) {
  const TraceRequest& request = *program.request;
  const PartImage* const image = peers_.gatherer(program.peer).image();
  ImageDone done;
  done.id = request.id;
  done.shape = {1, 1, 1, Image::kColorDepth};
  const bool fits = image && image->shape.width == request.width && image->shape.height == request.height &&
                    image->pixels.size() == bytesOf(image->shape);
  if (!fits) {
    done.error = image ? "the image of another rank has another size"
                       : "the image of another rank is not kept any more";
    return program.send(done);
  }
  program.makeRoom(image->pixels.size());
  std::memcpy(program.memory.at.get(), image->pixels.data(), image->pixels.size());
  colorMisses(*image, request.missColor, program.memory.at.get());
  done.whole = done.gathered = true;
  done.shape = image->shape, done.layers = image->layers;
  done.cost.elsewhere = true, done.cost.refined = image->finished;
  program.send(done);
}

void Head::takeShown(ConnectedProgram& program, const ImageShown& shown, const control::Descriptor& memory) {
  if (!program.peer) throw Malformed("nobody gave it parts");
  const Array pixels = mapSealed(memory, bytesOf(shown.shape));
  PartImage image;
  image.finished = shown.finished, image.missColor = shown.missColor;
  image.shape = shown.shape, image.layers = shown.layers;
  image.pixels.assign(pixels.bytes.begin(), pixels.bytes.end());
  peers_.gatherer(program.peer).show(shown.number, image);
}

}  // namespace gluray::cluster
