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

std::string installCommand(const std::string& name) {
  // Debian policy 8.1: the name without ".so", a dash if it ends in a digit, then the version.
  const size_t so = name.find(".so");
  if (so == name.npos) return "apt-file search " + name;
  std::string package = name.substr(0, so), version = name.substr(std::min(name.size(), so + 3));
  if (!version.empty()) version.erase(0, 1);
  std::transform(package.begin(), package.end(), package.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  std::replace(package.begin(), package.end(), '_', '-');
  if (version.empty()) return "apt-file search " + name;
  if (std::isdigit(static_cast<unsigned char>(package.back()))) package += "-";
  return "sudo apt install " + package + version;
}

}  // namespace gluray::launcher
