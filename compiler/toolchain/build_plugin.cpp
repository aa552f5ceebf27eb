#include "compiler/toolchain/build_plugin.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>

#include "base/cache/cache_folder.h"
#include "base/cache/entry_name.h"
#include "base/seal/seal.h"
#include "base/seal/sha256.h"
#include "compiler/source/diagnostic.h"
#include "compiler/toolchain/child_process.h"
#include "compiler/toolchain/clean_cache.h"
#include "compiler/toolchain/cxx_compiler.h"
#include "compiler/toolchain/file_io.h"
#include "compiler/toolchain/internal_error.h"
#include "compiler/toolchain/plugin_cache.h"
#include "compiler/toolchain/share_folder.h"

namespace compiler {
namespace {

namespace fs = std::filesystem;

std::string KeyOf(const std::string& cpp, const CxxCompiler& cxx) {
  std::string made_from = fmt::format("{}\n{}\n{}\n", cxx.identity, fmt::join(PluginFlags(), " "),
                                      fmt::join(PluginLibraries(), " "));
  // The hash of each text, so that no two pairs of texts look alike in a row.
  return seal::Sha256(made_from + seal::Sha256(ReadShareFile("include/taskc/plugin.h")) +
                      seal::Sha256(cpp))
      .substr(0, 32);
}

std::vector<std::string> CommandFor(const CxxCompiler& cxx, const fs::path& output) {
  std::vector<std::string> command = cxx.command;
  command.insert(command.end(), PluginFlags().begin(), PluginFlags().end());
  // From its standard input: then no name of a temporary folder gets into the plugin.
  command.insert(command.end(), {"-I", ShareFolder() / "include", "-x", "c++", "-", "-o", output});
  command.insert(command.end(), PluginLibraries().begin(), PluginLibraries().end());
  return command;
}

// Troubles of the machine that a compiler may report, and what they mean for the user.
struct Trouble {
  std::string_view sign;
  std::string_view meaning;
};
constexpr Trouble kTroubles[] = {
    {"No space left on device", "the disk is full"},
    {"Disk quota exceeded", "your disk quota is used up"},
    {"Killed signal terminated", "it was killed, probably because memory ran out"},
    {"out of memory", "memory ran out"},
    {"virtual memory exhausted", "memory ran out"},
    {"cannot execute", "its installation is incomplete; reinstall it"},
};

std::optional<std::string_view> FindTrouble(const fs::path& folder, const std::string& output) {
  for (const Trouble& trouble : kTroubles) {
    if (output.find(trouble.sign) != std::string::npos) return trouble.meaning;
  }
  constexpr uintmax_t kTooLittle = 256 * 1024;  // bytes: then even its messages may be lost
  std::error_code error;
  fs::space_info space = fs::space(folder, error);
  if (!error && space.available < kTooLittle) return kTroubles[0].meaning;
  return std::nullopt;
}

[[noreturn]] void Explain(const std::string& task_name, const ChildProcess& child, int status,
                          BuildFolder& folder, const fs::path& evidence) {
  const std::string& program = child.command.front();
  std::string output = ReadWholeFile(child.output).value_or("");
  if (auto trouble = FindTrouble(folder.path(), output)) {
    throw CallError(fmt::format("the C++ compiler {} failed: {}", program, *trouble));
  }
  if (status > 128) {
    throw CallError(
        fmt::format("the C++ compiler {} was terminated by signal {}", program, status - 128));
  }
  WriteWholeFile(folder.path() / "command.txt",
                 fmt::format("{}\nexit status {}\n", fmt::join(child.command, " "), status));
  folder.KeepAs(evidence);
  throw InternalError(
      fmt::format("the C++ compiler rejected what taskc generated from `{}`", task_name), evidence);
}

}  // namespace

BuildResult BuildPlugin(const std::string& task_name, const std::string& cpp,
                        const fs::path& cache_folder) {
  CxxCompiler cxx = FindCxxCompiler();
  std::string key = KeyOf(cpp, cxx);
  fs::path plugin = fs::absolute(cache_folder / cache::PluginName(task_name, key));
  if (IsIntact(plugin)) {
    NoteUse(plugin);
    return {.plugin = plugin, .from_cache = true};
  }

  BuildFolder folder(fs::absolute(cache_folder), cache::UnfinishedName(task_name, key));
  fs::path unsealed = folder.path() / "plugin.so";
  ChildProcess child{.command = CommandFor(cxx, unsealed),
                     .input = folder.path() / "plugin.cpp",
                     .output = folder.path() / "compiler-output.txt",
                     .scratch = folder.path()};
  WriteWholeFile(child.input, cpp);
  int status = Run(child);
  std::optional<std::string> bytes = ReadWholeFile(unsealed);
  if (status != 0 || !bytes) {
    Explain(task_name, child, status, folder,
            fs::absolute(cache_folder / cache::RefusalName(task_name, key)));
  }
  fs::path sealed = folder.path() / "sealed.so";
  WriteWholeFile(sealed, seal::Seal(std::move(*bytes)));
  folder.KeepFile(sealed, plugin);
  CleanCache(cache_folder);
  CleanCache(cache_folder / cache::kNets);
  return {.plugin = plugin, .from_cache = false};
}

}  // namespace compiler
