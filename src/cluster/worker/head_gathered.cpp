// Pictures that show the parts of several ranks of a program, between these ranks.
#include "cluster/worker/head.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace gluray::cluster {
namespace {

/// Gives misses of byte colours the receiver's colour.
void colorMisses(const PartPicture& picture, uint32_t color, std::byte* pixels) {
  const PlanePointers planes = planesIn(pixels, picture.shape);
  const bool isAverages = picture.shape.planes.has(Plane::centerDepth);
  if (!planes.color || isAverages || color == picture.missColor) return;
  for (size_t i = 0; i < picture.shape.pixels(); ++i) {
    float depth = 0;
    std::memcpy(&depth, planes.depth + i * sizeof depth, sizeof depth);
    if (depth == Image::kMiss) std::memcpy(planes.color + i * sizeof color, &color, sizeof color);
  }
}

}  // namespace

void Head::giveShown(ConnectedProgram& program) {
  const TraceRequest& request = *program.request;
  const PartPicture* const picture = peers_.gatherer(program.peer).picture();
  PictureDone done;
  done.id = request.id;
  done.shape = {1, 1, 1, Image::kPicture};
  const bool fits = picture && picture->shape.width == request.width &&
                    picture->shape.height == request.height &&
                    picture->pixels.size() == bytesOf(picture->shape);
  if (!fits) {
    done.error = picture ? "the picture of another rank has another size"
                         : "the picture of another rank is not kept any more";
    return program.send(done);
  }
  program.makeRoom(picture->pixels.size());
  std::memcpy(program.memory.at.get(), picture->pixels.data(), picture->pixels.size());
  colorMisses(*picture, request.missColor, program.memory.at.get());
  done.whole = done.gathered = true;
  done.shape = picture->shape, done.layers = picture->layers;
  done.cost.elsewhere = true, done.cost.refined = picture->finished;
  program.send(done);
}

void Head::takeShown(ConnectedProgram& program, const PictureShown& shown,
                     const control::Descriptor& memory) {
  if (!program.peer) throw Malformed("nobody gave it parts");
  const Array pixels = mapSealed(memory, bytesOf(shown.shape));
  PartPicture picture;
  picture.finished = shown.finished, picture.missColor = shown.missColor;
  picture.shape = shown.shape, picture.layers = shown.layers;
  picture.pixels.assign(pixels.bytes.begin(), pixels.bytes.end());
  peers_.gatherer(program.peer).show(shown.number, picture);
}

}  // namespace gluray::cluster
