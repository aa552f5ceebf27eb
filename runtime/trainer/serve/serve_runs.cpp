#include "runtime/trainer/serve/serve_runs.h"

#include <nlohmann/json.hpp>

#include "base/text/print.h"
#include "runtime/analysis/report/page.h"
#include "runtime/analysis/report/report.h"
#include "runtime/live/server/server.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/runs/many_runs.h"
#include "runtime/trainer/serve/runs_service.h"
#include "runtime/trainer/serve/task_files.h"
#include "runtime/training/simulation/profile.h"

namespace runtime {
namespace {

std::string RunsPage(const std::filesystem::path& folder, const std::string& nonce) {
  nlohmann::json data = {{"title", folder.filename().string() + " – runs"},
                         {"nonce", nonce},
                         {"tasks", TaskFilesBelow(std::filesystem::current_path())},
                         {"profiles", nlohmann::json::array()}};
  for (const Profile& each : kProfiles) data["profiles"].push_back(each.name);
  return MakePage(data, PageFolder("runs"));
}

// Of no other folder, whatever the name says.
std::filesystem::path FolderOf(const std::string& run, const std::filesystem::path& folder) {
  for (const std::filesystem::path& each : FindRuns(folder)) {
    if (each.lexically_relative(folder).string() == run) return each;
  }
  throw UserError(fmt::format("there is no run `{}` in {}", run, folder.string()));
}

PageMaker PagesOfRuns(const std::filesystem::path& folder) {
  return [folder](Page page, const std::string& nonce, const std::string& run) {
    switch (page) {
      case Page::kLive:
        return RunsPage(folder, nonce);
      case Page::kReport:
        return ReportPage(FolderOf(run, folder));
      case Page::kRecord:
        return RecordText(FolderOf(run, folder));
    }
    return std::string();
  };
}

}  // namespace

int ServeRuns(const std::filesystem::path& named, const std::filesystem::path& robots,
              const SessionOptions& options) {
  const std::filesystem::path folder = std::filesystem::canonical(named);
  WarnOfUnfinishedRuns(folder);
  const StopRequest stop(StopRequest::Second::kIsNoted);
  RunsService service(folder, JobsOrCores(options.jobs), robots);
  const Server server({.folder = folder, .port = options.port}, service, PagesOfRuns(folder));
  if (options.output.style() == ProgressStyle::kText) {
    text::Print("{}\n", server.page_address());
    std::fflush(stdout);
  }
  service.Run(stop);
  return kStoppedBySignal + stop.signal();
}

}  // namespace runtime
