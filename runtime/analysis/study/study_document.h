// The results of a study as a document with pictures, for a repository or a paper.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace runtime {

// Writes OUTPUT/README.md and the pictures that it shows, for each experiment its curves
// (EXPERIMENT.svg) and for each group of behaviors a snapshot strip (EXPERIMENT-A.png). `folder`:
// of the study, `runs`: the folders of its runs, some of which may be running. `title`: "" for the
// folder's name. Returns the document's path. Throws UserError.
std::filesystem::path WriteStudyDocument(const std::filesystem::path& folder,
                                         const std::vector<std::filesystem::path>& runs,
                                         const std::filesystem::path& output,
                                         const std::string& title = "");

}  // namespace runtime
