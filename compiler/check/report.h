// How the checks write their messages.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "base/text/nearest_name.h"
#include "compiler/source/diagnostic.h"

namespace compiler {

// What a diagnostic says beyond its message.
struct Explanation {
  std::string note{};
  Help help{};
  std::vector<Label> labels{};
};

// `code`: one of compiler::code.
void Report(Diagnostics& diagnostics, std::string_view code, Span span, std::string message,
            Explanation explanation = {});

// "`a`, `b` and `c`"
std::string List(const std::vector<std::string>& names);

// The help for an unknown name, which stands in `span`: the nearest of the valid ones, those that
// hold its words or else, where they are few, all of them. `what`: what they are, in the plural.
Help Suggest(Span span, std::string_view name, const std::vector<std::string>& valid,
             std::string_view what);

}  // namespace compiler
