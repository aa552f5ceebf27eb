// A file's text with fixes in it.
#pragma once

#include <string>
#include <vector>

#include "compiler/source/diagnostic.h"
#include "compiler/source/source_file.h"

namespace compiler {

// Those of `fixes`, all of one file and in the order of their places, that can be applied at once:
// each that touches none before it.
std::vector<Fix> Apart(const std::vector<Fix>& fixes);

// The text of `file` with all of them, which are apart.
std::string WithFixes(const SourceFile& file, const std::vector<Fix>& fixes);

}  // namespace compiler
