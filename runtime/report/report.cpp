#include "runtime/report/report.h"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>

#include "runtime/module/user_error.h"
#include "runtime/report/page.h"
#include "runtime/report/report_data.h"
#include "runtime/run/run_files.h"

namespace runtime {
namespace {

[[noreturn]] void FailToWrite(const std::filesystem::path& file, const std::error_code& error) {
  const bool is_full = error == std::errc::no_space_on_device || error.value() == EDQUOT;
  throw UserError(fmt::format("{}: cannot write the report: {}; {}", file.string(), error.message(),
                              is_full ? "free some space"
                                      : "name another file with --output, in a folder that you may "
                                        "write"));
}

}  // namespace

std::string ReportPage(const std::filesystem::path& run_dir) {
  return MakePage(CollectReportData(run_dir), PageFolder());
}

std::filesystem::path WriteReport(const std::filesystem::path& run_dir,
                                  const std::filesystem::path& output) {
  const std::filesystem::path file = output.empty() ? run_dir / "report.html" : output;
  if (const std::error_code error = ReplaceFile(file, ReportPage(run_dir))) {
    FailToWrite(file, error);
  }
  return file;
}

}  // namespace runtime
