#include "runtime/report/report.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "runtime/module/user_error.h"
#include "runtime/report/page.h"
#include "runtime/report/report_data.h"

namespace runtime {
namespace {

[[noreturn]] void FailToWrite(const std::filesystem::path& file, int error) {
  const char* remedy = error == ENOSPC || error == EDQUOT
                           ? "free some space"
                           : "name another file with --output, in a folder that you may write";
  throw UserError(fmt::format("{}: cannot write the report: {}; {}", file.string(),
                              std::strerror(error), remedy));
}

// Beside the final place, so that the report replaces an older one at once or not at all.
void WriteWhole(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::path part = file;
  part += fmt::format(".{}.part", ::getpid());
  errno = 0;
  std::ofstream out(part, std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  std::error_code error;
  if (out) {
    std::filesystem::rename(part, file, error);
    if (!error) return;
  }
  const int cause = error ? error.value() : errno;
  std::filesystem::remove(part, error);
  FailToWrite(file, cause);
}

}  // namespace

std::filesystem::path WriteReport(const std::filesystem::path& run_dir,
                                  const std::filesystem::path& output) {
  const std::filesystem::path file = output.empty() ? run_dir / "report.html" : output;
  const nlohmann::json data = CollectReportData(run_dir);
  WriteWhole(file, MakePage(data, PageFolder()));
  return file;
}

}  // namespace runtime
