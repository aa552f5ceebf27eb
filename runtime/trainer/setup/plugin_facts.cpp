#include "runtime/trainer/setup/plugin_facts.h"

#include <sys/resource.h>

#include "runtime/base/sandbox.h"
#include "runtime/trainer/setup/apart.h"

namespace runtime {
namespace {

constexpr rlim_t kPatience = 10;  // [s] of CPU time

Words TellFacts(const std::filesystem::path& file) {
  const rlimit limit{kPatience, kPatience + 1};
  setrlimit(RLIMIT_CPU, &limit);
  EnterSandbox({.files = {.readable = {file}, .writable = {}}});
  const PluginFacts facts = FactsOf(Plugin(file));
  Words words = {facts.robot, facts.source_hash, facts.compiler};
  words.insert(words.end(), facts.sources.begin(), facts.sources.end());
  return words;
}

}  // namespace

PluginFacts FactsOf(const Plugin& plugin) {
  const taskc_plugin& table = plugin.table();
  PluginFacts facts{table.robot, table.source_hash, table.compiler, {}};
  for (uint32_t i = 0; i < table.source_count; ++i)
    facts.sources.emplace_back(table.sources[i].file);
  return facts;
}

PluginFacts ReadPluginFacts(const std::filesystem::path& plugin) {
  const Words words = RunApart(plugin.string(), [&] { return TellFacts(plugin); });
  return {words[0], words[1], words[2], {words.begin() + 3, words.end()}};
}

}  // namespace runtime
