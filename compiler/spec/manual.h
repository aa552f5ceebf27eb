// The manual of the language, docs/language.md, as data.
#pragma once

#include <string>
#include <string_view>

namespace compiler {

// What stands below the heading called `heading`, up to the next heading of any level. Empty where
// there is none.
std::string SectionOf(std::string_view manual, std::string_view heading);

// What the tables of the manual say of a function: the second column of the rows whose first one
// shows a call of it, "; " between them. Without the marks of code. Empty where no row does.
std::string MeaningOf(std::string_view manual, std::string_view function);

}  // namespace compiler
