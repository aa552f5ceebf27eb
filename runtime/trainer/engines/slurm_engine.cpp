#include "runtime/trainer/engines/slurm_engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "base/text/print.h"
#include "base/text/shell_word.h"
#include "runtime/base/child_process.h"
#include "runtime/base/user_error.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/engines/slurm_jobs.h"
#include "runtime/trainer/engines/slurm_queue.h"
#include "runtime/trainer/runs/many_runs.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

constexpr size_t kLargestArray = 1000;  // what a cluster allows unless it was told otherwise
constexpr int kSecondsToSave = 120;     // before the limit of its time a task is told

class SlurmEngine : public Engine {
 public:
  explicit SlurmEngine(SlurmSettings settings) : settings_(std::move(settings)) {}

  int Train(const StudyRuns& study, const OutputOptions& output) override {
    const std::filesystem::path folder = std::filesystem::absolute(study.folder);
    const SlurmTasks queued = QueuedTasks(ReadSlurmArrays(folder));
    std::vector<std::string> waiting;
    size_t in_queue = 0;
    for (const RunProgress& run : RunsToTrain(study.folder, study.runs)) {
      if (run.state != RunProgressState::kWaiting) continue;
      if (queued.contains(run.name)) {
        ++in_queue;
      } else {
        waiting.push_back(run.name);
      }
    }
    const std::vector<SlurmArray> submitted = SubmitAll(folder, waiting);
    Say(study, submitted, in_queue, study.runs.size() - waiting.size() - in_queue, output);
    return kSuccess;
  }

 private:
  std::vector<SlurmArray> SubmitAll(const std::filesystem::path& folder,
                                    const std::vector<std::string>& runs) const {
    std::vector<SlurmArray> submitted;
    for (size_t first = 0; first < runs.size(); first += kLargestArray) {
      const size_t count = std::min(kLargestArray, runs.size() - first);
      const auto begin = runs.begin() + static_cast<std::ptrdiff_t>(first);
      SlurmArray array{0, {begin, begin + static_cast<std::ptrdiff_t>(count)}};
      array.job = Submit(folder, array.runs);
      AddSlurmArray(folder, array);
      submitted.push_back(std::move(array));
    }
    return submitted;
  }

  // Returns the job's id.
  int64_t Submit(const std::filesystem::path& folder, const std::vector<std::string>& runs) const {
    const size_t number = ReadSlurmArrays(folder).size() + 1;
    const std::filesystem::path files = SlurmFolder(folder);
    MakeRunFolder(files);
    std::string list;
    for (const std::string& run : runs) list += (folder / run).string() + "\n";
    const std::filesystem::path list_file = files / fmt::format("runs-{}.txt", number);
    const std::filesystem::path script = files / fmt::format("job-{}.sh", number);
    const std::string trainer = std::filesystem::read_symlink("/proc/self/exe").string();
    WriteFile(list_file, list);
    WriteFile(script, SlurmScript(trainer, list_file.string(), settings_));
    std::vector<std::string> words = WordsOf(folder, runs.size());
    words.push_back(script.string());
    const ChildResult result = RunChild(std::move(words), Captured::kOutput);
    if (result.error) {
      throw UserError(fmt::format("cannot run `sbatch`: {}; is this a machine of the cluster?",
                                  result.error.message()));
    }
    int64_t job = 0;  // "123" or, with several clusters, "123;name"
    const std::string& id = result.captured;
    const bool is_id = std::from_chars(id.data(), id.data() + id.size(), job).ec == std::errc();
    if (result.is_success && is_id) return job;
    throw UserError("`sbatch` has refused the runs: nothing more was submitted");
  }

  std::vector<std::string> WordsOf(const std::filesystem::path& folder, size_t count) const {
    std::vector<std::string> words = {"sbatch",
                                      "--parsable",
                                      "--requeue",
                                      "--open-mode=append",
                                      "--ntasks=1",
                                      "--job-name=" + folder.filename().string(),
                                      "--output=" + (SlurmFolder(folder) / "%A_%a.out").string(),
                                      fmt::format("--cpus-per-task={}", settings_.cpus),
                                      fmt::format("--signal=B:USR1@{}", kSecondsToSave)};
    std::string array = fmt::format("--array=0-{}", count - 1);
    if (settings_.at_once > 0) array += fmt::format("%{}", settings_.at_once);
    words.push_back(array);
    const auto add = [&](const char* option, const std::string& value) {
      if (!value.empty()) words.push_back(fmt::format("--{}={}", option, value));
    };
    add("partition", settings_.partition);
    add("account", settings_.account);
    add("time", settings_.time);
    add("mem", settings_.memory);
    words.insert(words.end(), settings_.options.begin(), settings_.options.end());
    return words;
  }

  static void Say(const StudyRuns& study, const std::vector<SlurmArray>& submitted, size_t in_queue,
                  size_t over, const OutputOptions& output) {
    if (output.style() == ProgressStyle::kJson) {
      nlohmann::ordered_json jobs = nlohmann::ordered_json::array();
      for (const SlurmArray& array : submitted) {
        jobs.push_back({{"job", array.job}, {"runs", array.runs}});
      }
      const nlohmann::ordered_json json = {
          {"submitted", jobs}, {"in_queue", in_queue}, {"over", over}};
      return text::Print("{}\n",
                         json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    }
    if (output.style() == ProgressStyle::kQuiet) return;
    for (const SlurmArray& array : submitted) {
      text::Print("{} run{} submitted as job {}\n", array.runs.size(),
                  array.runs.size() == 1 ? "" : "s", array.job);
    }
    if (in_queue > 0) text::Print("{} in the queue already\n", in_queue);
    if (over > 0) text::Print("{} finished, or cannot be read\n", over);
    text::Print("`trainer study status {}` shows how far they are\n", study.folder.string());
  }

  const SlurmSettings settings_;
};

}  // namespace

std::string SlurmScript(const std::string& trainer, const std::string& list,
                        const SlurmSettings& settings) {
  std::string script =
      "#!/bin/bash\n"
      "# Made by `trainer study`. Each task of the array trains one run from its last "
      "checkpoint.\n";
  for (const std::string& module : settings.modules) {
    script += fmt::format("module load {} || exit 1\n", text::ShellWord(module));
  }
  script +=
      fmt::format("run=$(sed -n \"$((SLURM_ARRAY_TASK_ID + 1))p\" {})\n", text::ShellWord(list));
  script += fmt::format("{} resume \"$run\" --quiet --jobs \"${{SLURM_CPUS_PER_TASK:-1}}\" &\n",
                        text::ShellWord(trainer));
  script +=
      "trainer=$!\n"
      "requeue=no\n"
      "# Its time is nearly up: it saves after the current episode, and goes on later.\n"
      "trap 'requeue=yes; kill -TERM $trainer 2>/dev/null' USR1\n"
      "# It makes room, or was cancelled: then Slurm knows what comes next.\n"
      "trap 'kill -TERM $trainer 2>/dev/null' TERM\n"
      "wait $trainer\n"
      "status=$?\n"
      "while kill -0 $trainer 2>/dev/null; do\n"
      "  wait $trainer\n"
      "  status=$?\n"
      "done\n"
      "if [ $requeue = yes ] && [ $status -ne 0 ]; then\n"
      "  scontrol requeue \"${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID\"\n"
      "fi\n"
      "exit $status\n";
  return script;
}

std::unique_ptr<Engine> MakeSlurmEngine(SlurmSettings settings) {
  return std::make_unique<SlurmEngine>(std::move(settings));
}

}  // namespace runtime
