// Many runs at a glance.
#pragma once

#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/live/workers/supervisor.h"
#include "runtime/training/run/live_text.h"
#include "runtime/training/run/progress.h"

namespace runtime {

// "running"
std::string_view NameOf(RunProgressState state);

// A head and one line for each run, without colors:
//
//   run      state      episodes      last      best     left
//   seed1    running    340/1000     12.25     27.61    10:12
//
// Where they do not fit into `columns`, whole columns are left out, the last return first, and at
// last the beginnings of long names.
std::string RunTable(const std::vector<RunProgress>& runs, size_t columns = kAnyWidth);

// "2 running, 1 finished, 12 waiting   1340/15000 episodes   3:12:40 left", or what of it fits into
// `columns`. `jobs`: how many run at a time, for the time left.
std::string RunSummary(const std::vector<RunProgress>& runs, int jobs, size_t columns = kAnyWidth);

// Shows the table on a terminal, always up to date; elsewhere one line for each run that ends and
// one for all every half minute. With JSON, each worker's lines with the name of the run.
class RunTablePrinter : public SupervisorListener {
 public:
  RunTablePrinter(ProgressStyle style, int jobs, std::FILE* output, std::FILE* warnings);

  // `runs` are those of the supervisor, and live as long as this.
  void Follow(const std::vector<RunProgress>& runs);
  // The table as it is at the end.
  void Finish();
  // Takes the table off the terminal, to which something else is going to be printed.
  void Erase();

  void OnStart() override;
  void OnLine(const RunProgress& run, std::string_view json) override;
  void OnMessage(const RunProgress& run, std::string_view text) override;
  void OnStopping(bool at_once) override;

 private:
  void Refresh(bool at_once);
  std::string FittingTable() const;

  const ProgressStyle style_;
  const int jobs_;
  std::FILE* output_;
  std::FILE* warnings_;
  LiveText live_;
  const std::vector<RunProgress>* runs_ = nullptr;
  std::chrono::steady_clock::time_point last_ = {};
};

}  // namespace runtime
