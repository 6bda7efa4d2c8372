// The file of the report. Any thread.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include <string>

namespace gluray::intercept {

/// The report's file name, chosen at the first call. Rank 0 of an MPI program writes the session's file,
/// other ranks that write a report of their own FILE.rankN.
const std::string& reportPath();

/// Replaces the file. One line in the log if that fails.
void writeReportText(const nlohmann::json& report);

}  // namespace gluray::intercept
