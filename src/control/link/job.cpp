#include "control/link/job.h"

#include "base/environment_variable.h"
#include "control/messages/members.h"
#include "control/process_start.h"

#include <unistd.h>

#include <array>
#include <charconv>
#include <initializer_list>
#include <optional>
#include <string_view>

namespace gluray::control {
namespace {

/// The variables of a launcher. `names`: of the job, in order of preference; null: none.
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
  return whole && number >= 0 && number <= kMaxRanks ? std::optional(number) : std::nullopt;
}

/// A job with several ranks; nullopt if the numbers are missing or invalid.
std::optional<Job> jobFrom(const std::string& rank, const std::string& ranks, const std::string& name) {
  const std::optional<int> place = rankNumber(rank), count = rankNumber(ranks);
  if (!place || !count || *count < 2 || *place >= *count) return std::nullopt;
  constexpr size_t kMaxNameBytes = 200;
  return Job{*place, *count, name.substr(0, kMaxNameBytes)};
}

/// Host and process id of MPICH's launcher on this host, which may have started the rank through a shell;
/// empty if there is none.
std::string launcherOfThisProcess() {
  char host[256] = {};
  if (gethostname(host, sizeof host - 1) != 0) return "";
  constexpr int kMaxGenerations = 8;
  pid_t process = getppid();
  for (int i = 0; i < kMaxGenerations && process > 1; ++i) {
    const ProcessStat stat = statOf(process);
    const std::string_view name = stat.name;
    if (name.starts_with("hydra_") || name.starts_with("mpiexec"))
      return std::string(host).append(" ").append(std::to_string(process));
    process = stat.parent;
  }
  return "";
}

}  // namespace

Job jobOf(const AskVariable& variable, const std::string& launcher) {
  for (const Launcher& l : kLaunchers) {
    std::string name;
    for (const char* const known : l.names)
      if (known && name.empty()) name = variable(known);
    // If all ranks run on one host, the launcher's process is the same for all of them.
    if (name.empty() && variable("MPI_LOCALNRANKS") == variable(l.ranks)) name = launcher;
    // Ranks that cannot determine their job count as separate programs.
    if (name.empty()) continue;
    if (auto job = jobFrom(variable(l.rank), variable(l.ranks), name)) return *job;
  }
  // Shells of batch jobs also have SLURM_NTASKS, but no step.
  const std::string id = variable("SLURM_JOB_ID"), step = variable("SLURM_STEP_ID");
  if (!id.empty() && rankNumber(step))
    if (auto job = jobFrom(variable("SLURM_PROCID"), variable("SLURM_NTASKS"), "slurm " + id + "." + step))
      return *job;
  return {};
}

Job jobOfThisProcess() { return jobOf(environmentVariable, launcherOfThisProcess()); }

}  // namespace gluray::control
