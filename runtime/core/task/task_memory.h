#pragma once

#include <taskc/plugin.h>

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plugins/host/task_frame.h"

namespace runtime {

// The variables of one instance of a task, in the memory block of its host.
class TaskMemory {
 public:
  // Refers to `host`, which must outlive this.
  explicit TaskMemory(host::TaskFrame& host);

  // Copies each variable that `old` has under the same name, type and unit: those that live as long
  // as the run, or all of them.
  void TakeOver(const TaskMemory& old, bool all);

  // Whether an episode can depend on those before it: whether the task itself has variables that
  // live as long as the run, besides its goals and how it starts, which every episode draws anew.
  bool outlives_episodes() const;

  // The variables that live as long as the run: the only ones that survive an episode's boundary.
  void Save(std::ostream& stream) const;
  // Takes over each variable that the task still has under the same name, type and unit; the others
  // keep their values. Throws UserError if the stream ends early.
  void Load(std::istream& stream);

 private:
  // The one among `variables` with this name, type and size in bytes, or null. `type`: with its
  // unit.
  static const taskc_memory* FindSame(std::span<const taskc_memory> variables,
                                      std::string_view name, const std::string& type, size_t size);

  host::TaskFrame& host_;
  std::span<const taskc_memory> variables_;
  std::vector<taskc_memory> kept_;  // those with the scope of the run
};

}  // namespace runtime
