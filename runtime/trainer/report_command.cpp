#include <fmt/format.h>

#include "runtime/report/report.h"
#include "runtime/trainer/commands.h"

namespace runtime {

void AddReportCommand(CLI::App& app, int& status) {
  struct Options {
    std::filesystem::path folder;
    std::filesystem::path output;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("report", "Writes a run's report as one HTML file.");
  command->add_option("DIR", options->folder, "folder of the run")->required();
  command->add_option("-o,--output", options->output,
                      "file to write; otherwise report.html in the run's folder");
  command->callback([options, &status] {
    const std::filesystem::path output =
        options->output.empty() ? options->folder / "report.html" : options->output;
    fmt::print("{}\n", WriteReport(options->folder, output).string());
    status = kSuccess;
  });
}

}  // namespace runtime
