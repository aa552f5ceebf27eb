#include "runtime/training/simulation/mujoco_library.h"

#include <fmt/format.h>

#include <cstring>
#include <mutex>

#include "runtime/base/user_error.h"

namespace runtime {

void UseMujoco() {
  static std::once_flag once;
  std::call_once(once, [] {
    mju_user_error = [](const char* message) {
      throw UserError(fmt::format("MuJoCo: {}", message));
    };
    mju_user_warning = [](const char*) {};
  });
}

MemoryFiles::MemoryFiles() : files_(std::make_unique<mjVFS>()) { mj_defaultVFS(files_.get()); }
MemoryFiles::~MemoryFiles() { mj_deleteVFS(files_.get()); }

void MemoryFiles::Add(const std::string& name, const std::string& bytes) {
  if (mj_makeEmptyFileVFS(files_.get(), name.c_str(), static_cast<int>(bytes.size())) != 0) {
    throw UserError(fmt::format("the model has more than {} meshes", mjMAXVFS - 1));
  }
  const int index = mj_findFileVFS(files_.get(), name.c_str());
  std::memcpy(files_->filedata[index], bytes.data(), bytes.size());
}

void MemoryFiles::Remove(const char* name) { mj_deleteFileVFS(files_.get(), name); }

}  // namespace runtime
