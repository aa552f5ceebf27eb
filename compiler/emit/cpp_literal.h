// Values as C++ literals.
#pragma once

#include <string>
#include <string_view>

namespace compiler {

// A quoted literal that means exactly these bytes, whatever they are: quotes, backslashes, control
// characters, trigraphs and bytes beyond ASCII are escaped.
std::string StringLiteral(std::string_view text);

// The same, one literal for each line of the text, each on a line of its own after `indent`, for
// the C++ compiler to join.
std::string SplitStringLiteral(std::string_view text, std::string_view indent);

// The shortest decimal that reads back as the same double; never mistaken for an int.
std::string RealLiteral(double value);

// Of type long long.
std::string IntLiteral(double value);

}  // namespace compiler
