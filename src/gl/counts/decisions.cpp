#include "gl/counts/decisions.h"

#include "base/log.h"
#include "gl/batch/batch.h"
#include "gl/batch/present_result.h"

namespace gluray::gl {
namespace {

std::string_view nameOf(BatchKey::Layers layers) {
  switch (layers) {
    case BatchKey::Layers::none: return "opaque";
    case BatchKey::Layers::peeled: return "peeled";
    case BatchKey::Layers::summed: return "summed";
    case BatchKey::Layers::drawn: return "blended";
    case BatchKey::Layers::visibility: return "visibility";
  }
  return "";
}

std::string_view nameOf(PresentResult::Outcome outcome) {
  switch (outcome) {
    case PresentResult::traced: return "traced";
    case PresentResult::rasterised: return "rasterised";
    case PresentResult::failed: return "failed";
  }
  return "";
}

std::string operator&(std::string line, std::string_view word) {
  line += ' ';
  return line += word;
}

std::string operator&(std::string line, uint64_t number) { return std::move(line) & std::to_string(number); }

}  // namespace

void Decisions::write(std::string line) const {
  log::write(log::Level::trace, std::move(line) & "in" & command_);
}

void Decisions::draw(Reason reason, DrawPath path, PrimitiveClass primitive, uint64_t triangles,
                     uint32_t state) {
  std::string line = std::string("draw") & ++draws_ & describe(path) & describe(primitive) & triangles;
  for (const std::string_view one : describeStates(state)) line += ", " + std::string(one);
  write(std::move(line) & (reason == Reason::traced ? "->" : "-> rasterised:") & describe(reason));
}

void Decisions::detail(std::string_view what, std::string_view why) {
  std::string line = std::string("draw") & draws_ & what;
  write(why.empty() ? std::move(line) : std::move(line) & why);
}

void Decisions::batch(const BatchKey& key, size_t instances, std::string_view how) {
  write(std::string("batch") & ++batches_ & nameOf(key.layers) & "instances" & instances & "framebuffer" &
        key.framebuffer & "->" & how);
}

void Decisions::relit(size_t instances) { write(std::string("lit again") & "instances" & instances); }

void Decisions::presented(const PresentResult& result, bool known) {
  std::string line = std::string("presented") & nameOf(result.outcome);
  if (known) line = std::move(line) & "known";
  if (result.repeated) line = std::move(line) & "repeated";
  if (result.averages) line = std::move(line) & "averages";
  write(std::move(line));
}

}  // namespace gluray::gl
