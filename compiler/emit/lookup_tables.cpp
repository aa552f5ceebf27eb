#include "compiler/emit/lookup_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "compiler/emit/cpp_literal.h"
#include "compiler/emit/used_values.h"

namespace compiler {
namespace {

constexpr size_t kNumbersInLine = 20;

void EmitDoubles(const std::string& name, const std::vector<double>& numbers, size_t in_line,
                 TextWriter& writer) {
  writer.Line(fmt::format("constexpr double {}[] = {{", name));
  for (size_t first = 0; first < numbers.size(); first += in_line) {
    std::vector<std::string> line;
    for (size_t i = first; i < std::min(first + in_line, numbers.size()); ++i)
      line.push_back(RealLiteral(numbers[i]));
    writer.Line(fmt::format("    {},", fmt::join(line, ", ")));
  }
  writer.Line("};");
}

}  // namespace

void EmitLookupTables(const CheckedTask& task, const PluginNames& names, TextWriter& writer) {
  for (const uint32_t index : UsedBy(task).tables) {
    const CheckedTable& table = task.tables[index];
    const std::string& name = names.tables[index];
    const size_t size = table.type.size();
    writer.BlankLine();
    EmitDoubles(name + "_arguments", table.arguments, kNumbersInLine, writer);
    EmitDoubles(name + "_elements", table.elements, size == 1 ? kNumbersInLine : size, writer);
    writer.Line(fmt::format("constexpr Table {0} = {{{0}_arguments, {0}_elements, {1}, {2}}};",
                            name, table.arguments.size(), size));
  }
}

std::string TablePlaceText(const std::string& table, bool repeats, const std::string& argument,
                           HelperSet& helpers) {
  helpers.Use(Helper::kTable);
  const std::string place =
      repeats ? fmt::format("{}({}, {})", helpers.Use(Helper::kInFirstRound), table, argument)
              : argument;
  return fmt::format("{}({}, {})", helpers.Use(Helper::kFindPlace), table, place);
}

}  // namespace compiler
