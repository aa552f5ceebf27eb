// What somebody needs who is to look into a mistake of taskc: a folder with the files that were
// read, the version, the command line and what happened.
#pragma once

#include <filesystem>
#include <string>

namespace compiler {

// From now on, a crash of this program writes such a folder, says where it is, and ends the program
// with ExitStatus::kInternalError.
void ReportCrashes(int argc, char** argv);

// A file that belongs into the folder. Those that the command line names do anyway.
void RememberFile(const std::filesystem::path& file);

// Writes into `folder`, which need not be there yet. Best effort: what cannot be written is left
// out.
void WriteCrashReport(const std::filesystem::path& folder, const std::string& message);

// Where a report goes that has no folder yet.
std::filesystem::path CrashFolder();

}  // namespace compiler
