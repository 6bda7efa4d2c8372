// MPI jobs as described by the variables of their launchers.
#include "control/link/job.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace gluray::control {
namespace {

Job jobWith(const std::map<std::string, std::string>& variables) {
  return jobOf(
      [&](const char* name) {
        const auto found = variables.find(name);
        return found == variables.end() ? "" : found->second;
      },
      "node7 4100");
}

void expectJob(const Job& job, int rank, int ranks, const std::string& name) {
  EXPECT_EQ(job.rank, rank);
  EXPECT_EQ(job.ranks, ranks);
  EXPECT_EQ(job.name, name);
}

TEST(Job, OneProcessIsNoJob) {
  expectJob(jobWith({}), 0, 1, "");
  expectJob(jobWith({{"OMPI_COMM_WORLD_RANK", "0"}, {"OMPI_COMM_WORLD_SIZE", "1"}}), 0, 1, "");
}

TEST(Job, OpenMpi) {
  expectJob(
      jobWith(
          {{"OMPI_COMM_WORLD_RANK", "3"}, {"OMPI_COMM_WORLD_SIZE", "8"}, {"PMIX_NAMESPACE", "prterun-7"}}),
      3, 8, "prterun-7");
  expectJob(
      jobWith(
          {{"OMPI_COMM_WORLD_RANK", "3"}, {"OMPI_COMM_WORLD_SIZE", "8"}, {"OMPI_MCA_ess_base_jobid", "99"}}),
      3, 8, "99");
  expectJob(jobWith({{"OMPI_COMM_WORLD_RANK", "3"}, {"OMPI_COMM_WORLD_SIZE", "8"}}), 0, 1, "");
}

TEST(Job, HydraAndMvapich) {
  expectJob(jobWith({{"PMI_RANK", "1"}, {"PMI_SIZE", "2"}, {"MPI_LOCALNRANKS", "2"}}), 1, 2, "node7 4100");
  expectJob(jobWith({{"PMI_RANK", "1"}, {"PMI_SIZE", "2"}, {"MPI_LOCALNRANKS", "1"}}), 0, 1, "");
  expectJob(jobWith({{"PMI_RANK", "1"}, {"PMI_SIZE", "2"}, {"PMI_PORT", "node1:99"}}), 1, 2, "node1:99");
  expectJob(jobWith({{"MV2_COMM_WORLD_RANK", "1"}, {"MV2_COMM_WORLD_SIZE", "2"}, {"MPISPAWN_ID", "0"}}), 1, 2,
            "0");
}

TEST(Job, SlurmStepsOfSeveralTasks) {
  std::map<std::string, std::string> variables = {
      {"SLURM_JOB_ID", "77"}, {"SLURM_NTASKS", "4"}, {"SLURM_PROCID", "2"}};
  expectJob(jobWith(variables), 0, 1, "");
  variables["SLURM_STEP_ID"] = "1";
  expectJob(jobWith(variables), 2, 4, "slurm 77.1");
  variables["SLURM_NTASKS"] = "1";
  expectJob(jobWith(variables), 0, 1, "");
}

TEST(Job, NonsenseIsNoJob) {
  for (const char* wrong : {"", "-1", "8", "x", "3 ", "99999999999999999999"})
    expectJob(jobWith({{"PMI_RANK", wrong}, {"PMI_SIZE", "8"}}), 0, 1, "");
  for (const char* wrong : {"", "0", "-8", "8.5"})
    expectJob(jobWith({{"PMI_RANK", "0"}, {"PMI_SIZE", wrong}}), 0, 1, "");
}

}  // namespace
}  // namespace gluray::control
