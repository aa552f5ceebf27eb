// C++ text to shared object, through a cache.
#pragma once

#include <filesystem>
#include <string>

namespace compiler {

struct BuildResult {
  std::filesystem::path plugin;  // the shared object
  bool from_cache = false;
};

// Compiles `cpp` into a shared object. The cache's key is the SHA-256 of the C++ text, the ABI
// header and the compiler's command. A finished plugin is written under a temporary name and
// renamed, never changed in place; several processes can build into one cache. A damaged entry is
// built anew. The cache stays below a size (compiler/toolchain/clean_cache.h). Throws CallError
// where the cache cannot be written or the C++ compiler cannot be run, and InternalError
// (compiler/toolchain/internal_error.h) where it refuses the text: that is our bug, never the
// user's.
BuildResult BuildPlugin(const std::string& task_name, const std::string& cpp,
                        const std::filesystem::path& cache);

}  // namespace compiler
