#include "intercept/capture/capture_plan.h"

#include "base/number_text.h"

namespace gluray::intercept {
namespace {

bool readWhen(std::string_view word, CapturePlan& plan) {
  using When = CapturePlan::When;
  const size_t colon = word.find(':');
  const std::string_view name = word.substr(0, colon);
  const std::string_view value = colon == word.npos ? "" : word.substr(colon + 1);
  if (name == "idle") return plan.when = When::idle, value.empty();
  if (name == "seconds")
    return plan.when = When::seconds, readNumber(value, plan.seconds) && plan.seconds >= 0;
  if (name != "frame" && name != "every") return false;
  plan.when = name == "frame" ? When::frame : When::every;
  return readNumber(value, plan.number) && plan.number > 0;
}

}  // namespace

std::optional<CapturePlan> readCapturePlan(std::string_view text) {
  const size_t blank = text.find(' ');
  if (blank == text.npos) return std::nullopt;
  CapturePlan plan;
  plan.folder = text.substr(blank + 1);
  if (plan.folder.empty() || plan.folder.front() != '/' || !readWhen(text.substr(0, blank), plan))
    return std::nullopt;
  return plan;
}

}  // namespace gluray::intercept
