// MuJoCo as this project uses it: errors as exceptions, handles that destroy what they own, files
// in memory.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <string>

namespace runtime {

// MuJoCo ends the program where it is told nothing else, and writes warnings to a file. From the
// first call on it throws UserError instead of the one, and does not do the other.
void UseMujoco();

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using MujocoModel = std::unique_ptr<mjModel, DeleteModel>;
using MujocoData = std::unique_ptr<mjData, DeleteData>;

// Files in memory, as MuJoCo takes them.
class MemoryFiles {
 public:
  MemoryFiles();
  ~MemoryFiles();
  MemoryFiles(const MemoryFiles&) = delete;
  MemoryFiles& operator=(const MemoryFiles&) = delete;

  // Throws UserError if there are too many.
  void Add(const std::string& name, const std::string& bytes);
  void Remove(const char* name);
  const mjVFS* get() const { return files_.get(); }

 private:
  std::unique_ptr<mjVFS> files_;
};

}  // namespace runtime
