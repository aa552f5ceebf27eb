#include "runtime/training/run/recorded_sources.h"

#include <algorithm>

#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

// How many folders `file` leads up from where it is read.
std::ptrdiff_t StepsUp(const std::filesystem::path& file) {
  return std::ranges::count(file, std::filesystem::path(".."));
}

bool IsAbove(const std::filesystem::path& folder, const std::filesystem::path& file) {
  const std::filesystem::path inside = file.lexically_relative(folder);
  return !inside.empty() && *inside.begin() != "..";
}

}  // namespace

RecordedSources WriteSources(const std::vector<SourceRecord>& sources,
                             const std::filesystem::path& folder) {
  std::ptrdiff_t depth = 0;
  std::vector<std::filesystem::path> files;
  for (const SourceRecord& source : sources) {
    files.push_back(std::filesystem::path(source.file).lexically_normal().relative_path());
    depth = std::max(depth, StepsUp(files.back()));
  }
  std::filesystem::path root = folder;
  for (std::ptrdiff_t i = 0; i < depth; ++i) root /= "folder";
  RecordedSources written;
  for (size_t i = 0; i < files.size(); ++i) {
    const std::filesystem::path file = (root / files[i]).lexically_normal();
    MakeRunFolder(file.parent_path());
    WriteFile(file, sources[i].text);
    if (i == 0) written.task = file;
    const size_t above = folder.string().size();
    for (auto each = file.parent_path(); i > 0 && each.string().size() > above;
         each = each.parent_path()) {
      const bool is_known = std::ranges::find(written.folders, each) != written.folders.end();
      if (!is_known && !IsAbove(each, written.task)) written.folders.push_back(each);
    }
  }
  std::ranges::stable_sort(written.folders, std::ranges::greater{},
                           [](const auto& each) { return std::ranges::distance(each); });
  return written;
}

std::filesystem::path WriteRobot(const RunRecord& run, const std::filesystem::path& robots) {
  MakeRunFolder(robots);
  if (run.robot_description.empty()) return robots;
  const std::filesystem::path folder = robots / std::filesystem::path(run.robot).filename();
  MakeRunFolder(folder);
  WriteFile(folder / "robot.toml", run.robot_description);
  return robots;
}

}  // namespace runtime
