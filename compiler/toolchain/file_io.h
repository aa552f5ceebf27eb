// Whole files, with errors that name the file and the reason.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace compiler {

// Nothing where the file cannot be read, or is not a regular file.
std::optional<std::string> ReadWholeFile(const std::filesystem::path& file);

// Throws CallError.
void WriteWholeFile(const std::filesystem::path& file, std::string_view bytes);

// Under a temporary name in the same folder, then renamed: those who have the old file open or
// mapped keep it, and nobody ever sees half a file. Devices are written as they are. Throws
// CallError.
void ReplaceFile(const std::filesystem::path& file, std::string_view bytes);

// As ReplaceFile, for a file that is there: through links, its permissions stay. Throws CallError.
void RewriteFile(const std::filesystem::path& file, std::string_view bytes);

// As ReplaceFile. Throws CallError.
void CopyWholeFile(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace compiler
