#include "runtime/trainer/runs/loop_detector.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

namespace runtime {
namespace {

// [s] of CPU time that the thread has used; 0 where it has ended.
double CpuTime(pid_t process, pid_t thread) {
  std::ifstream file(fmt::format("/proc/{}/task/{}/stat", process, thread));
  std::string text;
  std::getline(file, text);
  const size_t name_end = text.rfind(')');  // a name may hold anything
  if (name_end == std::string::npos) return 0;
  std::istringstream fields(text.substr(name_end + 1));
  constexpr int kFieldsBefore = 11;  // from the state to the major faults, see proc(5)
  std::string ignored;
  for (int i = 0; i < kFieldsBefore; ++i) fields >> ignored;
  double user = 0;
  double system = 0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace

bool LoopDetector::Stay::IsTooLong(int64_t what_now, double now) {
  if (what_now == 0 || what_now != what) {
    what = what_now;
    since = now;
  }
  return what != 0 && now - since > kPatience;
}

bool LoopDetector::IsLooping(const PluginWatch& watch) {
  bool is_call_too_long = false;
  for (size_t i = 0; i < calls_.size(); ++i) {
    const PluginWatch::Thread& thread = watch.threads[i];
    const pid_t id = i == 0 ? process_ : thread.id.load();
    const int64_t call = thread.running != 0 ? thread.calls + 1 : 0;
    is_call_too_long |= calls_[i].IsTooLong(call, call == 0 ? 0 : CpuTime(process_, id));
  }
  const pid_t loader = watch.loading_thread;
  const bool is_loading_too_long = loading_.IsTooLong(loader == 0 ? 0 : watch.loads + 1,
                                                      loader == 0 ? 0 : CpuTime(process_, loader));
  return is_call_too_long || is_loading_too_long;
}

}  // namespace runtime
