#include "runtime/trainer/ctl/trainer_end.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <thread>

#include "runtime/base/user_error.h"
#include "runtime/live/client/client.h"
#include "runtime/training/run/run_database.h"

namespace runtime {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks{100};
constexpr int kLooks = 100;  // 10 s: a trainer that starts again restores its checkpoint first

// What a trainer notes when it ends by itself; after a crash the run counts as running, also where
// its record cannot be read for a moment.
bool HasEndedByItself(const std::filesystem::path& run) {
  try {
    return RunDatabase::OpenToRead(run).ReadValue("state") != RunStateName(RunState::kRunning);
  } catch (const UserError&) {
    return false;
  }
}

bool ComesBack(const std::filesystem::path& run) {
  for (int look = 0; look < kLooks && !HasEndedByItself(run); ++look) {
    if (HasTrainer(run)) return true;
    std::this_thread::sleep_for(kBetweenLooks);
  }
  return false;
}

void WaitForEnd(const std::filesystem::path& run) {
  do {
    try {
      FollowEvents(run, [](const nlohmann::json&) {});
    } catch (const std::exception&) {
      // It has ended, or is only about to listen again.
    }
  } while (ComesBack(run));
}

}  // namespace

TrainerEnd::TrainerEnd(const std::filesystem::path& run) {
  if (!HasTrainer(run)) {
    throw UserError(
        fmt::format("{}: no trainer is running for this run; `trainer resume {}` continues it",
                    run.string(), run.string()));
  }
  std::array<int, 2> ends = {-1, -1};
  if (pipe(ends.data()) != 0) throw UserError("cannot make a pipe: too many files are open");
  end_ = Descriptor(ends[0]);
  // On its own until the program ends: it waits for the trainer, whoever else has given up.
  std::thread([run, end = Descriptor(ends[1])] { WaitForEnd(run); }).detach();
}

}  // namespace runtime
