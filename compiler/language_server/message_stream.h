// Messages of the Language Server Protocol on a stream: a header with the length, then JSON.
#pragma once

#include <istream>
#include <optional>
#include <ostream>
#include <string>

namespace compiler {

// The content of the next message; nothing at the end of the stream. Headers other than the length
// are passed over; what has no length is empty.
std::optional<std::string> ReadMessage(std::istream& in);

void WriteMessage(std::ostream& out, const std::string& content);

}  // namespace compiler
