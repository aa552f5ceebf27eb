// On which machines a run was trained, in its database.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "runtime/training/run/machine.h"

namespace runtime {

struct MachineRecord {
  int64_t episode = 0;  // from 1: from this one on
  MachineFacts facts;
};

// Of the run in `folder`, ascending; none where an older version has trained it. Throws UserError.
std::vector<MachineRecord> ReadMachines(const std::filesystem::path& folder);

// Those of the machine on which this episode was trained; none where `machines`, ascending, do not
// say.
MachineFacts FactsAt(const std::vector<MachineRecord>& machines, int64_t episode);

// From its episode on the run is trained there; what stands there of later ones goes. For the
// trainer that works on the run. Throws UserError.
void SetMachine(const std::filesystem::path& folder, const MachineRecord& machine);

}  // namespace runtime
