#include "control/link/job.h"

#include <unistd.h>

#include <array>
#include <charconv>
#include <cstdlib>
#include <initializer_list>
#include <optional>

namespace gluray::control {
namespace {

constexpr int kMostRanks = 1 << 24;

/// What a launcher sets. Names of the job in order of preference; null: none.
struct Launcher {
  const char *rank, *ranks;
  std::array<const char*, 3> names;
};
constexpr Launcher kLaunchers[] = {
    {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", {"PMIX_NAMESPACE", "OMPI_MCA_ess_base_jobid", nullptr}},
    {"MV2_COMM_WORLD_RANK", "MV2_COMM_WORLD_SIZE", {"MPISPAWN_ID", "PMI_JOBID", nullptr}},
    {"PMI_RANK", "PMI_SIZE", {"PMI_JOBID", "PMI_PORT", nullptr}},
    {"PMIX_RANK", "SLURM_NTASKS", {"PMIX_NAMESPACE", nullptr, nullptr}},
};

std::optional<int> rankNumber(const std::string& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && number >= 0 && number <= kMostRanks ? std::optional(number) : std::nullopt;
}

/// A job of several ranks; nothing if the numbers are missing or wrong.
std::optional<Job> jobFrom(const std::string& rank, const std::string& ranks, const std::string& name) {
  const std::optional<int> place = rankNumber(rank), count = rankNumber(ranks);
  if (!place || !count || *count < 2 || *place >= *count) return std::nullopt;
  constexpr size_t kMostOfName = 200;
  return Job{*place, *count, name.substr(0, kMostOfName)};
}

std::string hostName() {
  char name[256] = {};
  return gethostname(name, sizeof name - 1) == 0 ? name : "";
}

}  // namespace

Job jobOf(const AskVariable& variable, const std::string& launcher) {
  for (const Launcher& l : kLaunchers) {
    std::string name;
    for (const char* const known : l.names)
      if (known && name.empty()) name = variable(known);
    if (name.empty()) name = launcher;
    if (auto job = jobFrom(variable(l.rank), variable(l.ranks), name)) return *job;
  }
  // Shells of batch jobs have SLURM_NTASKS, too, but no step of their own.
  const std::string id = variable("SLURM_JOB_ID"), step = variable("SLURM_STEP_ID");
  if (!id.empty() && rankNumber(step))
    if (auto job = jobFrom(variable("SLURM_PROCID"), variable("SLURM_NTASKS"), "slurm " + id + "." + step))
      return *job;
  return {};
}

Job jobOfThisProcess() {
  const auto variable = [](const char* name) {
    const char* const value = std::getenv(name);
    return std::string(value ? value : "");
  };
  return jobOf(variable, hostName() + " " + std::to_string(getppid()));
}

}  // namespace gluray::control
