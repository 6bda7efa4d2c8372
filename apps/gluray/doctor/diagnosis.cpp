#include "doctor/diagnosis.h"

#include "base/printable.h"
#include "text_table.h"

#include <algorithm>
#include <cctype>

namespace gluray::launcher {
namespace {

const char* wordOf(Health health) {
  constexpr const char* words[] = {"ok", "limited", "BROKEN"};
  return words[static_cast<int>(health)];
}

}  // namespace

int Diagnosis::exitCode() const {
  Health worst = Health::ok;
  for (const Finding& finding : findings_) worst = std::max(worst, finding.health);
  return static_cast<int>(worst);
}

std::string Diagnosis::text() const {
  constexpr size_t kWidth = 90;
  size_t topic = 0;
  for (const Finding& finding : findings_) topic = std::max(topic, finding.topic.size());
  const std::string indent(topic + 2 + 7 + 2, ' ');
  std::string all;
  for (const Finding& finding : findings_) {
    std::string head = finding.topic;
    head.resize(topic + 2, ' ');
    head += wordOf(finding.health);
    head.resize(indent.size(), ' ');
    const std::string lines = wrapped(printable(finding.text), kWidth, indent);
    all += head + lines.substr(std::min(indent.size(), lines.size()));
    if (!finding.fix.empty()) all += indent + "fix: " + printable(finding.fix) + "\n";
  }
  constexpr const char* kSums[] = {"all is well", "it works with limitations", "it will not work"};
  return all + "\n" + kSums[exitCode()] + "\n";
}

nlohmann::json Diagnosis::json() const {
  nlohmann::json list = nlohmann::json::array();
  for (const Finding& f : findings_) {
    constexpr const char* names[] = {"ok", "limited", "broken"};
    nlohmann::json entry = {
        {"topic", f.topic}, {"health", names[static_cast<int>(f.health)]}, {"text", f.text}};
    if (!f.fix.empty()) entry["fix"] = f.fix;
    list.push_back(std::move(entry));
  }
  return {{"exitCode", exitCode()}, {"findings", list}};
}

}  // namespace gluray::launcher
