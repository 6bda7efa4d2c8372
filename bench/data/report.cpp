#include "bench/data/report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

namespace gluray::bench {

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

std::pair<double, double> quartiles(std::vector<double> values) {
  if (values.empty()) return {0, 0};
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    const double place = share * double(values.size() - 1);
    const auto low = static_cast<size_t>(place);
    const size_t high = std::min(low + 1, values.size() - 1);
    return values[low] + (place - double(low)) * (values[high] - values[low]);
  };
  return {at(0.25), at(0.75)};
}

ResidentBytes residentBytes() {
  ResidentBytes out;
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    size_t kib = 0;
    if (word == "VmRSS:" && status >> kib) out.now = kib * 1024;
    if (word == "RssAnon:" && status >> kib) out.anonymous = kib * 1024;
    if (word == "VmHWM:" && status >> kib) out.highest = kib * 1024;
  }
  return out;
}

void forgetHighest() { std::ofstream("/proc/self/clear_refs") << "5"; }

std::string jsonLine(const Measurement& m, const ResidentBytes& resident) {
  const auto [low, high] = quartiles(m.frameSeconds);
  nlohmann::json line = {{"program", m.program},
                         {"path", m.path},
                         {"renderer", m.renderer},
                         {"triangles", m.triangles},
                         {"first_image_s", m.firstImageSeconds},
                         {"frame_s", median(m.frameSeconds)},
                         {"frame_low_s", low},
                         {"frame_high_s", high},
                         {"frames", m.frameSeconds.size()},
                         {"build_s", m.buildSeconds},
                         {"rss_bytes", resident.now},
                         {"rss_anon_bytes", resident.anonymous},
                         {"peak_bytes", resident.highest},
                         {"own_bytes", m.ownBytes}};
  if (!m.allSeconds.empty()) line["all_s"] = m.allSeconds;
  if (m.cpuSeconds > 0) line["cpu_s"] = m.cpuSeconds;
  return line.dump();
}

}  // namespace gluray::bench
