#include "runtime/live/client/find_trainer.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/base/user_error.h"
#include "runtime/live/client/client.h"
#include "runtime/training/run/run_database.h"

namespace runtime {
namespace {

using std::filesystem::directory_options;
using std::filesystem::recursive_directory_iterator;

}  // namespace

std::vector<std::string> TrainersUnder(const std::filesystem::path& root) {
  std::vector<std::string> folders;
  std::error_code error;
  for (auto entry =
           recursive_directory_iterator(root, directory_options::skip_permission_denied, error);
       !error && entry != recursive_directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    if (!entry->is_socket(ignored)) continue;
    const std::filesystem::path folder = entry->path().parent_path();
    // Who serves a folder of runs listens there, too.
    if (RunDatabase::Exists(folder) && HasTrainer(folder)) folders.push_back(folder.string());
  }
  std::ranges::sort(folders);
  return folders;
}

std::filesystem::path FindTrainer(const std::filesystem::path& root) {
  const std::vector<std::string> folders = TrainersUnder(root);
  if (folders.size() == 1) return folders.front();
  if (folders.empty()) {
    throw UserError(fmt::format(
        "no trainer is running for any run under `{}`; name the run's folder with `--run DIR`",
        root.string()));
  }
  std::string message = "several trainers are running; name the run's folder with `--run DIR`:";
  for (const std::string& folder : folders) message += "\n  --run " + folder;
  throw UserError(message);
}

}  // namespace runtime
