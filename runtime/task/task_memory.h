#pragma once

#include <taskc/plugin.h>

#include <cstddef>
#include <iosfwd>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace runtime {

// The memory block of one instance of a task, aligned as the ABI wants it.
class TaskMemory {
 public:
  // All bytes are 0. `table` outlives this object.
  explicit TaskMemory(const taskc_plugin& table);

  void* data() { return blocks_.data(); }

  // Copies each variable that `old` has under the same name, type and unit: those that live as long
  // as the run, or all of them.
  void TakeOver(const TaskMemory& old, bool all);

  // The variables that live as long as the run: the only ones that survive an episode's boundary.
  void Save(std::ostream& stream) const;
  // Takes over each variable that the task still has under the same name, type and unit; the others
  // keep their values. Throws UserError if the stream ends early.
  void Load(std::istream& stream);

 private:
  struct alignas(16) Block {
    std::byte bytes[16];
  };

  std::span<std::byte> Bytes(const taskc_memory& variable);
  std::span<const std::byte> Bytes(const taskc_memory& variable) const;

  // The one among `variables` with this name, type and size in bytes, or null. `type`: with its
  // unit.
  static const taskc_memory* FindSame(std::span<const taskc_memory> variables,
                                      std::string_view name, const std::string& type, size_t size);

  std::span<const taskc_memory> variables_;
  std::vector<taskc_memory> kept_;  // those with the scope of the run
  std::vector<Block> blocks_;
};

}  // namespace runtime
