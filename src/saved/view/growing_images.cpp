#include "saved/view/growing_images.h"

#include "frame/images/traced_images.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace gluray::saved {
namespace {

bool areEqual(const std::shared_ptr<const scene::Layers>& a, const std::shared_ptr<const scene::Layers>& b) {
  return a == b || (a && b && *a == *b);
}

}  // namespace

/// In one step, as TracedImages does it.
void GrowingImages::traceWhole(const scene::Snapshot& snapshot, Entry& entry) {
  bool stopped = false;
  frame::TracedImages images(frame::Tracer{
      .trace = [&](const scene::Snapshot& s, Image& image, scene::TraceCost& cost, std::string& error) {
        const bool made = trace_(s, image, cost, error);
        stopped = !made && error.empty();
        return made;
      }});
  const auto made = images.imageOf(snapshot, {.mayRepeat = false, .finished = true});
  if (stopped) throw Stopped();
  if (!made.cached) throw std::runtime_error("it cannot be traced: " + made.why);
  entry.image = made.cached->image;
  entry.finished = true;
}

void GrowingImages::refine(Entry& entry) {
  frame::Refiner& refiner = *entry.refiner;
  bool changed = false;
  while (!entry.finished && entry.refinement.passes() < most_) {
    scene::TraceCost cost;
    std::string error;
    if (!refiner.pass(trace_, entry.image.missColor, cost, error)) {
      if (error.empty()) throw Stopped();
      if (entry.refinement.passes() == 0) throw std::runtime_error("it cannot be traced: " + error);
      entry.finished = true;  // it keeps its noise
      return;
    }
    changed = true;
    entry.finished = refiner.finished();
  }
  if (changed) refiner.show(entry.image);
}

const Image& GrowingImages::imageOf(const scene::Snapshot& snapshot) {
  if (next_ == entries_.size()) entries_.emplace_back();
  std::unique_ptr<Entry>& place = entries_[next_++];
  if (!place || !areEqual(place->layers, snapshot.layers)) {
    place = std::make_unique<Entry>(snapshot);
    if (frame::isRefinable(snapshot))
      place->refiner = std::make_unique<frame::Refiner>(snapshot, place->refinement);
  }
  if (place->refiner)
    refine(*place);
  else if (!place->finished)
    traceWhole(snapshot, *place);
  return place->image;
}

bool GrowingImages::finished() const {
  return std::all_of(entries_.begin(), entries_.end(),
                     [](const auto& entry) { return entry && entry->finished; });
}

uint32_t GrowingImages::passes() const {
  uint32_t most = 0;
  for (const auto& entry : entries_)
    if (entry) most = std::max(most, std::max(entry->refinement.passes(), entry->finished ? 1u : 0u));
  return most;
}

double GrowingImages::noise() const {
  double most = 0;
  for (const auto& entry : entries_)
    if (entry && entry->refiner) most = std::max(most, entry->refinement.noise());
  return most;
}

}  // namespace gluray::saved
