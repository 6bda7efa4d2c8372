// What `gluray doctor` found out, as lines for people and for scripts.
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
  std::string mend;  // the line that mends it; empty: nothing to mend, or nothing to be done
};

class Diagnosis {
 public:
  void ok(std::string topic, std::string text) { add({Health::ok, std::move(topic), std::move(text), ""}); }
  void limited(std::string topic, std::string text, std::string mend = "") {
    add({Health::limited, std::move(topic), std::move(text), std::move(mend)});
  }
  void broken(std::string topic, std::string text, std::string mend = "") {
    add({Health::broken, std::move(topic), std::move(text), std::move(mend)});
  }
  void add(Finding finding) { findings_.push_back(std::move(finding)); }
  const std::vector<Finding>& findings() const { return findings_; }

  /// 0: all is well, 1: it works with a limitation, 2: it will not work.
  int exitCode() const;
  std::string text() const;
  nlohmann::json json() const;

 private:
  std::vector<Finding> findings_;
};

/// The line that installs what holds the library `name` on Debian and its derivatives.
std::string mendMissingLibrary(const std::string& name);

}  // namespace gluray::launcher
