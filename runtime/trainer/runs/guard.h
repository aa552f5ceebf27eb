// A process that does nothing but look after the one that trains.
#pragma once

#include <filesystem>
#include <functional>

namespace runtime {

// Runs `train` in a child process and waits for it: returns there and here, with its exit status,
// or passes its exception on there. Signals go to the child.
//
// Where a task crashes in the child, ends it, or does not return within 10 s of CPU time, the
// task goes into quarantine in the run's record and a new child runs `again`. So does one after the
// same while a plugin was being loaded, and after StartAgain(). Any other end is the end.
//
// Where episodes ran side by side, it cannot be told which of them has failed: the new child then
// repeats them one at a time, and no task goes into quarantine unless it fails there.
//
// A process that is being debugged is not guarded: the debugger gets the crash.
enum class Pace { kAsAsked, kOneAtATime };
int RunGuarded(const std::function<int()>& train,
               const std::function<int(const std::filesystem::path& run, Pace pace)>& again);

// In the child: the run that is being trained, from the moment on at which it could go on.
void TellGuard(const std::filesystem::path& run);
bool IsGuarded();
// Asks for a new child that continues from the last checkpoint, once this one has ended; returns
// the exit status with which it is to do that.
int StartAgain();

}  // namespace runtime
