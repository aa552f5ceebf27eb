// A run as one HTML file that needs no network and no other file: curves and 3-D replay.
#pragma once

#include <filesystem>
#include <string>

namespace runtime {

// Writes the report of the run in `run_dir` to `output` (empty: report.html in `run_dir`), also
// while a trainer works on the run, and returns the file. The file appears whole or not at all.
// Throws UserError, naming file and remedy: no run there, no episode yet, a damaged database, the
// page's parts not installed, a file that cannot be written.
std::filesystem::path WriteReport(const std::filesystem::path& run_dir,
                                  const std::filesystem::path& output = {});

// The same page, in memory.
std::string ReportPage(const std::filesystem::path& run_dir);

// The page on which the run in `run_dir` is watched and tuned. `nonce`: the attribute of its
// scripts and styles. Throws UserError where the page's parts are not installed.
std::string LivePage(const std::filesystem::path& run_dir, const std::string& nonce);

// What that page draws besides what it is told as it happens: the report's numbers without
// recordings, as JSON. Throws UserError where the database cannot be read.
std::string RecordText(const std::filesystem::path& run_dir);

}  // namespace runtime
