// The findings of `gluray doctor`, as text and as JSON.
#pragma once
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace gluray::launcher {

enum class Health { ok, limited, broken };

struct Finding {
  Health health = Health::ok;
  std::string topic;  // "display", "program" ...
  std::string text;
  std::string fix;  // command that fixes it; empty: nothing to fix, or no fix known
};

class Diagnosis {
 public:
  void ok(std::string topic, std::string text) { add({Health::ok, std::move(topic), std::move(text), ""}); }
  void limited(std::string topic, std::string text, std::string fix = "") {
    add({Health::limited, std::move(topic), std::move(text), std::move(fix)});
  }
  void broken(std::string topic, std::string text, std::string fix = "") {
    add({Health::broken, std::move(topic), std::move(text), std::move(fix)});
  }
  void add(Finding finding) { findings_.push_back(std::move(finding)); }
  const std::vector<Finding>& findings() const { return findings_; }

  /// 0: all is well, 1: it works with limitations, 2: it will not work.
  int exitCode() const;
  std::string text() const;
  nlohmann::json json() const;

 private:
  std::vector<Finding> findings_;
};

}  // namespace gluray::launcher
