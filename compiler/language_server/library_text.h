// What editors say of a library that is imported by name.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "compiler/language_server/document.h"

namespace compiler {

// The text with its quotes behind an `import`, where `offset` touches it.
std::optional<Span> ImportAt(const Document& document, uint32_t offset);

// The comment at the top of the library, and its functions. Empty where there is no such library.
std::string LibraryDoc(std::string_view library);

}  // namespace compiler
