#include "runtime/analysis/report/report.h"

#include "runtime/analysis/report/page.h"
#include "runtime/analysis/report/report_data.h"

namespace runtime {

std::string ReportPage(const std::filesystem::path& run_dir) {
  return MakePage(CollectReportData(run_dir), PageFolder("report"));
}

std::filesystem::path WriteReport(const std::filesystem::path& run_dir,
                                  const std::filesystem::path& output) {
  const std::filesystem::path file = output.empty() ? run_dir / "report.html" : output;
  WritePage(file, ReportPage(run_dir));
  return file;
}

}  // namespace runtime
