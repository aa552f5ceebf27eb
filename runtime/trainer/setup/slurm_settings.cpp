#include "runtime/trainer/setup/slurm_settings.h"

namespace runtime {

void SlurmSettings::AddTo(command_line::Command& command) {
  command.AddOption("--partition", partition, "with Slurm: where the runs are trained");
  command.AddOption("--account", account, "with Slurm: who pays for it");
  command.AddOption("--time", time, "with Slurm: limit of one run, for example 12:00:00")
      .ValueName("TIME");
  command.AddOption("--memory", memory, "with Slurm: what one run needs, for example 2G")
      .ValueName("SIZE");
  command.AddOption("--sbatch", options, "with Slurm: an option for sbatch; may be repeated")
      .OneAtATime();
}

SlurmSettings SlurmSettings::OverriddenBy(const SlurmSettings& stronger) const {
  SlurmSettings merged = *this;
  for (std::string SlurmSettings::*text : {&SlurmSettings::partition, &SlurmSettings::account,
                                           &SlurmSettings::time, &SlurmSettings::memory}) {
    if (!(stronger.*text).empty()) merged.*text = stronger.*text;
  }
  // sbatch takes the last of two.
  merged.options.insert(merged.options.end(), stronger.options.begin(), stronger.options.end());
  return merged;
}

}  // namespace runtime
