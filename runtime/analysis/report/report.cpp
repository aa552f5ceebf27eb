#include "runtime/analysis/report/report.h"

#include "runtime/analysis/report/page.h"
#include "runtime/analysis/report/report_data.h"

namespace runtime {

std::string ReportPage(const std::filesystem::path& run_dir) {
  return MakePage(CollectReportData(run_dir), PageFolder("report"));
}

std::string LivePage(const std::filesystem::path& run_dir, const std::string& nonce) {
  const std::filesystem::path folder = std::filesystem::absolute(run_dir).lexically_normal();
  return MakePage({{"title", folder.filename().string() + " – live"},
                   {"nonce", nonce},
                   {"working_folder", std::filesystem::current_path().string()}},
                  PageFolder("live"));
}

std::string RecordText(const std::filesystem::path& run_dir) {
  return CollectRecord(run_dir).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::filesystem::path WriteReport(const std::filesystem::path& run_dir,
                                  const std::filesystem::path& output) {
  const std::filesystem::path file = output.empty() ? run_dir / "report.html" : output;
  WritePage(file, ReportPage(run_dir));
  return file;
}

}  // namespace runtime
