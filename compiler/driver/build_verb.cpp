// taskc build FILE.task
#include <memory>

#include "compiler/driver/verb.h"
#include "compiler/emit/emit.h"
#include "compiler/toolchain/build_plugin.h"
#include "compiler/toolchain/file_io.h"
#include "compiler/toolchain/plugin_cache.h"

namespace compiler {
namespace {

struct BuildOptions {
  std::string task;
  std::filesystem::path output;        // empty: leave the plugin in the cache and print its path
  std::filesystem::path cache;         // empty: the default
  std::filesystem::path dependencies;  // empty: not written
};

// As make reads it.
std::string InMakefile(const std::filesystem::path& file) {
  std::string text;
  for (const char c : file.string()) {
    if (c == ' ' || c == '#') text += '\\';
    if (c == '$') text += '$';
    text += c;
  }
  return text;
}

// One rule: the plugin, and all files that it is made from.
void WriteDependencies(const BuildOptions& options, const Analysis& analysis) {
  std::string rule = InMakefile(options.output) + ":";
  for (const SourceFile& file : analysis.sources.files()) {
    rule += " \\\n  " + InMakefile(std::filesystem::absolute(file.path()));
  }
  if (analysis.robot)
    rule += " \\\n  " + InMakefile(std::filesystem::absolute(analysis.robot->file));
  ReplaceFile(options.dependencies, rule + "\n");
}

ExitStatus Build(const BuildOptions& options, Session& session) {
  if (!options.dependencies.empty() && options.output.empty())
    throw CallError("`--depfile` needs the name of the plugin: add `-o FILE.so`");
  Analysis analysis = session.Analyze(options.task);
  if (!analysis.task) return ExitStatus::kWrongTask;
  std::filesystem::path cache = options.cache.empty() ? DefaultCacheFolder() : options.cache;
  BuildResult built =
      BuildPlugin(analysis.task->name, Emit(*analysis.task, analysis.sources), cache);
  if (options.output.empty()) {
    session.Say(built.plugin.string() + "\n");
  } else {
    CopyWholeFile(built.plugin, options.output);
  }
  if (!options.dependencies.empty()) WriteDependencies(options, analysis);
  session.Result()["plugin"] = (options.output.empty() ? built.plugin : options.output).string();
  return ExitStatus::kOk;
}

}  // namespace

Action DeclareBuild(Command& command, Session& session) {
  auto options = std::make_shared<BuildOptions>();
  AddTask(command, options->task);
  AddOutput(command, options->output, "FILE.so",
            "where to put the plugin; otherwise it stays in the cache and its path is printed");
  command.AddOption("--cache", options->cache, "folder for built plugins").ValueName("DIR");
  command
      .AddOption("--depfile", options->dependencies,
                 "where to write a rule for make and ninja, with all files that the plugin is made "
                 "from")
      .ValueName("FILE.d");
  AddRobots(command, session);
  AddText(command, session);
  AddReport(command, session);
  return [options](Session& call) { return Build(*options, call); };
}

}  // namespace compiler
