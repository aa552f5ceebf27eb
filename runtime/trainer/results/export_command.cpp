#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "base/text/print.h"
#include "runtime/analysis/export/c_header.h"
#include "runtime/analysis/export/csv.h"
#include "runtime/analysis/export/episode_table.h"
#include "runtime/analysis/export/mcap_episode.h"
#include "runtime/analysis/export/onnx.h"
#include "runtime/analysis/export/tensorboard.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/results/learned_policy.h"
#include "runtime/trainer/results/motion_agent.h"
#include "runtime/trainer/results/recorded_episode.h"
#include "runtime/trainer/runs/kept_run.h"
#include "runtime/trainer/runs/many_runs.h"
#include "runtime/trainer/setup/apart.h"
#include "runtime/trainer/setup/sandbox_rules.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

using command_line::CallError;
using Files = std::vector<std::filesystem::path>;

struct ExportOptions {
  std::filesystem::path folder;
  std::filesystem::path csv;
  std::filesystem::path tensorboard;
  std::filesystem::path mcap;
  std::filesystem::path motion;
  std::filesystem::path onnx;
  std::filesystem::path c_header;
  std::filesystem::path decisions;
  int64_t episode = 0;  // 0: the last that was recorded
  bool json = false;
};

// The runs with their names in `folder`; of a run itself the name is ".".
std::vector<TableOfRun> ReadTables(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> runs = FindRuns(folder);
  if (runs.empty()) runs = {folder};
  std::vector<TableOfRun> tables;
  for (const std::filesystem::path& run : runs) {
    tables.push_back(
        {run.lexically_relative(folder).string(), ReadEpisodeTable(RunDatabase::OpenToRead(run))});
  }
  return tables;
}

void Write(const std::filesystem::path& file, const char* what, const std::string& bytes,
           Files& files) {
  WriteOutput(file, what, bytes);
  files.push_back(file);
}

// Each run in a folder of its own, which TensorBoard takes for the run's name.
void WriteEvents(const std::filesystem::path& folder, const std::vector<TableOfRun>& runs,
                 Files& files) {
  for (const auto& [run, table] : runs) {
    const std::filesystem::path file = (folder / run / kEventFile).lexically_normal();
    MakeRunFolder(file.parent_path());
    Write(file, "the events", TensorBoardEvents(table), files);
  }
}

void WriteTables(const ExportOptions& options, Files& files) {
  const std::vector<TableOfRun> runs = ReadTables(options.folder);
  if (!options.csv.empty()) Write(options.csv, "the table", CsvOf(runs), files);
  if (!options.tensorboard.empty()) WriteEvents(options.tensorboard, runs, files);
}

// As ONNX, as C and as decisions, each empty where it is not wanted. In the sandbox: a policy is
// found by the run's own code.
Words PolicyTexts(const ExportOptions& options) {
  const RunRecord run = RunDatabase::OpenToRead(options.folder).ReadRun();
  const CommandSandbox sandbox(RulesOf(AgentOfRun(options.folder, run), options.folder));
  LearnedPolicy policy(options.folder);
  return {options.onnx.empty() ? "" : OnnxOf(policy.exported()),
          options.c_header.empty() ? "" : CHeaderOf(policy.exported()),
          options.decisions.empty() ? "" : policy.RunEpisode()};
}

void WritePolicy(const ExportOptions& options, Files& files) {
  WarnWhereSandboxIsWeak();
  const Words texts = RunApart(options.folder.string(), [&] { return PolicyTexts(options); });
  if (!options.onnx.empty()) Write(options.onnx, "the policy", texts[0], files);
  if (!options.c_header.empty()) Write(options.c_header, "the policy", texts[1], files);
  if (!options.decisions.empty()) Write(options.decisions, "the decisions", texts[2], files);
}

std::string ReadMcap(const std::filesystem::path& folder, int64_t wanted) {
  const RunDatabase database = RunDatabase::OpenToRead(folder);
  const int64_t number = ChooseRecordedEpisode(folder, database, wanted);
  const auto [run, episodes] = database.ReadRunAndEpisodes();
  const RecordedBody body = ReadBody(folder, run);
  const Motion motion = ReadRecordedMotion(folder, database, number, body.parts.size());
  return McapOf(run, episodes.at(static_cast<size_t>(number - 1)), motion, body.parts);
}

void Print(const Files& files, bool is_json) {
  if (is_json) {
    nlohmann::json names = nlohmann::json::array();
    for (const std::filesystem::path& file : files) names.push_back(file.string());
    const nlohmann::json json = {{"files", names}};
    text::Print("{}\n", json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    return;
  }
  for (const std::filesystem::path& file : files) text::Print("{}\n", file.string());
}

void Export(const ExportOptions& options) {
  const bool wants_tables = !options.csv.empty() || !options.tensorboard.empty();
  const bool wants_policy =
      !options.onnx.empty() || !options.c_header.empty() || !options.decisions.empty();
  if (!wants_tables && !wants_policy && options.mcap.empty() && options.motion.empty()) {
    throw CallError(
        "say what to write: --csv FILE, --tensorboard DIR, --mcap FILE, --motion FILE, "
        "--onnx FILE, --c-header FILE or --decisions FILE");
  }
  if (options.episode != 0 && options.mcap.empty())
    throw CallError("--episode says which one --mcap writes, which is not given");
  Files files;
  if (wants_tables) WriteTables(options, files);
  if (!options.mcap.empty())
    Write(options.mcap, "the episode", ReadMcap(options.folder, options.episode), files);
  if (!options.motion.empty())
    Write(options.motion, "the agent", MotionAgent(options.folder), files);
  if (wants_policy) WritePolicy(options, files);
  Print(files, options.json);
}

}  // namespace

void AddExportCommand(command_line::Command& program) {
  const auto options = std::make_shared<ExportOptions>();
  command_line::Command& command = program.AddCommand(
      "export",
      "Writes for other programs what a run has recorded, as tables or MCAP, or what it has "
      "learned, as ONNX or C.");
  command.AddOption("DIR", options->folder, "folder of the run, or of many runs").Required();
  command
      .AddOption("--csv", options->csv,
                 "write every number of every episode as comma-separated values")
      .ValueName("FILE");
  command
      .AddOption("--tensorboard", options->tensorboard,
                 "write the same as events for TensorBoard into this folder")
      .ValueName("DIR");
  command
      .AddOption("--mcap", options->mcap,
                 "write a recorded episode of the run as MCAP, for Foxglove and others")
      .ValueName("FILE");
  command
      .AddOption("--motion", options->motion,
                 "write an agent file that learns on top of the best motion of a motion search")
      .ValueName("FILE");
  command
      .AddOption("--episode", options->episode,
                 "number of the episode for --mcap; by default the last that is recorded")
      .Positive();
  command
      .AddOption("--onnx", options->onnx,
                 "write what the run has learned as an ONNX model: from what the robot observes to "
                 "its joints' targets")
      .ValueName("FILE");
  command
      .AddOption("--c-header", options->c_header,
                 "write the same as a C header that needs no library")
      .ValueName("FILE");
  command
      .AddOption("--decisions", options->decisions,
                 "let it act for an episode, and write what it observed and did as comma-separated "
                 "values, to check what runs elsewhere")
      .ValueName("FILE");
  command.AddFlag("--json", options->json, "print the files' names as JSON");
  AddSandboxOption(command);
  command.OnRun([options] {
    Export(*options);
    return kSuccess;
  });
}

}  // namespace runtime
