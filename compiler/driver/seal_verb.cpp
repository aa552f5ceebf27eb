// taskc seal FILE.so...
#include <fmt/format.h>

#include <memory>

#include "base/file/read.h"
#include "base/seal/seal.h"
#include "compiler/driver/verb.h"
#include "compiler/toolchain/file_io.h"

namespace compiler {
namespace {

ExitStatus SealFile(const std::string& file, const Session& session) {
  file::Reading reading = file::Read(file);
  if (!reading.problem.empty()) {
    throw CallError(fmt::format("cannot read `{}`: {}", file, reading.problem));
  }
  if (!reading.bytes.starts_with("\x7f"
                                 "ELF")) {
    throw CallError(
        fmt::format("`{}` is not a shared object; build one against the ABI, or build a "
                    "task with `taskc build`",
                    file));
  }
  switch (seal::StateOf(reading.bytes)) {
    case seal::State::kIntact:
      session.Say(fmt::format("{}: already sealed\n", file));
      return ExitStatus::kOk;
    case seal::State::kBroken:
      throw CallError(fmt::format("`{}` has changed since it was sealed; rebuild it", file));
    case seal::State::kAbsent:
      break;
  }
  RewriteFile(file, seal::Seal(std::move(reading.bytes)));
  return ExitStatus::kOk;
}

}  // namespace

Action DeclareSeal(Command& command, Session&) {
  auto files = std::make_shared<std::vector<std::string>>();
  command.AddOption("FILE.so", *files, "plugins that you trust").Required().ValueName("...");
  return [files](Session& call) {
    return ForEachTask(*files, call, [&](const std::string& file) { return SealFile(file, call); });
  };
}

}  // namespace compiler
