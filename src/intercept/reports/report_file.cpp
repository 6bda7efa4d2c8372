#include "intercept/reports/report_file.h"

#include "base/files.h"
#include "base/log.h"
#include "intercept/reports/report_of_ranks.h"
#include "intercept/session/session.h"

#include <nlohmann/json.hpp>

namespace gluray::intercept {
namespace {

std::string chosenPath() {
  const std::string& file = session().reportFile;
  const control::Job& job = jobOfReport();
  if (job.ranks < 2 || files::isStream(file)) return fileOfThisProcess(file);
  return job.rank == 0 ? file : file + ".rank" + std::to_string(job.rank);
}

}  // namespace

const std::string& reportPath() {
  // Never destroyed: the exit handler that writes the last report was registered before this string was
  // constructed.
  static const std::string& path = *new std::string(chosenPath());
  return path;
}

void writeReportText(const nlohmann::json& report) {
  // Names of programs and drivers may be invalid UTF-8.
  const std::string text = report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  if (const std::string why = files::replace(reportPath(), text); !why.empty())
    log::once(log::Level::error, "report", "cannot write the report " + reportPath() + ": " + why);
}

}  // namespace gluray::intercept
