#include "runtime/trainer/engines/slurm_queue.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <optional>

#include "runtime/base/child_process.h"
#include "runtime/base/user_error.h"

namespace runtime {
namespace {

std::vector<std::string> Split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find(separator, begin), text.size());
    parts.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::optional<int64_t> Whole(std::string_view text) {
  int64_t number = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || rest != text.data() + text.size()) return std::nullopt;
  return number;
}

// The run of a task; null where that is none of the study's.
const std::string* RunOf(std::string_view job, std::string_view index,
                         const std::vector<SlurmArray>& arrays) {
  const std::optional<int64_t> id = Whole(job);
  const std::optional<int64_t> task = Whole(index);
  for (const SlurmArray& array : arrays) {
    if (array.job != id || !task) continue;
    const bool is_one = *task >= 0 && *task < static_cast<int64_t>(array.runs.size());
    return is_one ? &array.runs[static_cast<size_t>(*task)] : nullptr;
  }
  return nullptr;
}

std::string NotNone(const std::string& text) {
  return text == "None" || text == "(null)" || text == "None assigned" ? "" : text;
}

}  // namespace

SlurmTasks ParseQueue(std::string_view text, const std::vector<SlurmArray>& arrays) {
  SlurmTasks tasks;
  for (const std::string& line : Split(text, '\n')) {
    const std::vector<std::string> fields = Split(line, '|');
    if (fields.size() != 5) continue;
    const std::string* run = RunOf(fields[0], fields[1], arrays);
    if (run != nullptr) tasks[*run] = {fields[2], NotNone(fields[3]), NotNone(fields[4])};
  }
  return tasks;
}

SlurmTasks ParseAccounts(std::string_view text, const std::vector<SlurmArray>& arrays) {
  SlurmTasks tasks;
  for (const std::string& line : Split(text, '\n')) {
    const std::vector<std::string> fields = Split(line, '|');
    const size_t underscore = fields[0].find('_');
    if (fields.size() != 3 || underscore == std::string::npos) continue;
    const std::string* run = RunOf(std::string_view(fields[0]).substr(0, underscore),
                                   std::string_view(fields[0]).substr(underscore + 1), arrays);
    if (run != nullptr) tasks[*run] = {fields[1], NotNone(fields[2]), ""};
  }
  return tasks;
}

SlurmTasks QueuedTasks(const std::vector<SlurmArray>& arrays) {
  if (arrays.empty()) return {};
  const ChildResult result = RunChild(
      {"squeue", "--noheader", "--array", "--me", "--format", kQueueFormat}, Captured::kOutput);
  if (result.error || !result.is_success) {
    throw UserError(
        fmt::format("`squeue` cannot say which runs are in the queue{}{}; is this a "
                    "machine of the cluster?",
                    result.error ? ": " : "", result.error.message()));
  }
  return ParseQueue(result.captured, arrays);
}

SlurmTasks EndedTasks(const std::vector<SlurmArray>& arrays) {
  if (arrays.empty()) return {};
  std::vector<std::string> jobs;
  for (const SlurmArray& array : arrays) jobs.push_back(std::to_string(array.job));
  const ChildResult result =
      RunChild({"sacct", "--noheader", "--allocations", "--parsable2",
                "--format=JobID,State,NodeList", fmt::format("--jobs={}", fmt::join(jobs, ","))},
               Captured::kOutputOnly);
  if (result.error || !result.is_success) return {};
  return ParseAccounts(result.captured, arrays);
}

}  // namespace runtime
