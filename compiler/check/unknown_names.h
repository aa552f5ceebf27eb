// Messages about names that mean nothing where they stand.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// The first `length` names of a path, with dots.
std::string PathText(const std::vector<Identifier>& path, size_t length);
Span SpanOfPath(const std::vector<Identifier>& path, size_t length);

// A sensor with an entry for each part of this enumeration of a robot's: "contact" of "link".
std::string_view SensorOver(std::string_view enumeration);

// A part of the robot, or a group of them, that is read as a value. `enumeration`: "link".
void ReportPartAsValue(const Identifier& name, std::string_view enumeration,
                       const TaskScope& scope);

// What is read where only constants are allowed.
std::nullopt_t NotConstant(std::string_view name, Span span, const Place& place,
                           const TaskScope& scope);

// A path that begins with no name that is known.
void ReportUnknownPath(const std::vector<Identifier>& path, const TaskScope& scope);

}  // namespace compiler
