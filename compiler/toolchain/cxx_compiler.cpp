#include "compiler/toolchain/cxx_compiler.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <optional>
#include <sstream>

#include "compiler/source/diagnostic.h"

namespace compiler {
namespace {

std::vector<std::string> Split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) {
    if (!part.empty()) parts.push_back(part);
  }
  return parts;
}

bool IsProgram(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) &&
         access(path.c_str(), X_OK) == 0;
}

// As a shell finds it.
std::optional<std::string> FindProgram(const std::string& name) {
  if (name.find('/') != std::string::npos) {
    return IsProgram(name) ? std::optional(name) : std::nullopt;
  }
  const char* path = std::getenv("PATH");
  for (const std::string& folder : Split(path == nullptr ? "/usr/bin:/bin" : path, ':')) {
    std::string candidate = folder + "/" + name;
    if (IsProgram(candidate)) return candidate;
  }
  return std::nullopt;
}

// A new version of a program has another size or another time.
std::string IdentityOf(const std::vector<std::string>& command) {
  std::string identity;
  for (const std::string& word : command) {
    identity += word;
    if (std::optional<std::string> program = FindProgram(word)) {
      struct stat status {};
      stat(program->c_str(), &status);
      identity += fmt::format(" {} {} {}.{}", *program, status.st_size, status.st_mtim.tv_sec,
                              status.st_mtim.tv_nsec);
    }
    identity += '\n';
  }
  return identity;
}

CxxCompiler MakeCompiler(std::vector<std::string> command, const std::string& program) {
  command.front() = program;
  std::string identity = IdentityOf(command);
  return {.command = std::move(command), .identity = std::move(identity)};
}

}  // namespace

CxxCompiler FindCxxCompiler() {
  const char* wanted = std::getenv("CXX");
  std::vector<std::string> command = Split(wanted == nullptr ? "" : wanted, ' ');
  if (!command.empty()) {
    if (auto program = FindProgram(command.front())) return MakeCompiler(command, *program);
    throw CallError(fmt::format(
        "the environment variable CXX names `{}`, which is not a program; correct it or unset it",
        command.front()));
  }
  for (const char* name : {"g++", "c++"}) {
    if (auto program = FindProgram(name)) return MakeCompiler({name}, *program);
  }
  throw CallError(
      "no C++ compiler found; install one (on Debian: `apt install g++`) or name yours in the "
      "environment variable CXX");
}

const std::vector<std::string>& PluginFlags() {
  static const std::vector<std::string> flags = {
      "-O2", "-std=c++20", "-shared", "-fPIC", "-pipe", "-w",
      // A debugger steps through the .task file; DWARF 5 would show it our file's name instead.
      "-g1", "-gdwarf-4", "-fvisibility=hidden", "-fno-exceptions", "-fno-rtti",
      // The same bits on every machine and at every level of optimization; no undefined overflow.
      "-ffp-contract=off", "-fno-builtin", "-fno-math-errno", "-fwrapv",
      // Or else g++ loads all of a long sum before it adds, and runs out of registers.
      "-fno-tree-ter",
      // Nothing of the C++ runtime is needed, and the link is faster without.
      "-nostdlib", "-fno-use-linker-plugin", "-Wl,-z,defs"};
  return flags;
}

const std::vector<std::string>& PluginLibraries() {
  static const std::vector<std::string> libraries = {"-lm", "-lc", "-lgcc"};
  return libraries;
}

}  // namespace compiler
