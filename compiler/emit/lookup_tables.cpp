#include "compiler/emit/lookup_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
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

// Between two rows a number grows from the one to the other, so it stays between them unless all of
// the way from one row leads beyond the next.
bool LeadsBeyond(double from, double to) {
  const double end = from + (to - from);
  return from < to ? end > to : end < to;
}

std::vector<bool> HeldElements(const CheckedTable& table) {
  const size_t size = table.type.size();
  std::vector<bool> held(size);
  for (size_t i = size; i < table.elements.size(); ++i)
    if (LeadsBeyond(table.elements[i - size], table.elements[i])) held[i % size] = true;
  return held;
}

}  // namespace

std::vector<LookupTable> NameLookupTables(const CheckedTask& task, UniqueNames& taken) {
  const std::set<uint32_t> used = UsedBy(task).tables;
  std::vector<LookupTable> tables;
  for (uint32_t index = 0; index < task.tables.size(); ++index) {
    const CheckedTable& table = task.tables[index];
    const std::string name = taken.Add("table_" + table.name);
    for (const char* part : {"_arguments", "_elements"}) taken.Reserve(name + part);
    const auto has_same = [&](uint32_t other) {
      return task.tables[other].arguments == table.arguments;
    };
    const auto first = std::ranges::find_if(used, has_same);
    const bool is_shared = first != used.end() && *first < index;
    tables.push_back({name, is_shared ? tables[*first].name : name, HeldElements(table)});
  }
  return tables;
}

void EmitLookupTables(const CheckedTask& task, const PluginNames& names, TextWriter& writer) {
  for (const uint32_t index : UsedBy(task).tables) {
    const CheckedTable& table = task.tables[index];
    const auto& [name, searched, held] = names.tables[index];
    const size_t size = table.type.size();
    writer.BlankLine();
    if (searched == name) EmitDoubles(name + "_arguments", table.arguments, kNumbersInLine, writer);
    EmitDoubles(name + "_elements", table.elements, size == 1 ? kNumbersInLine : size, writer);
    writer.Line(fmt::format("constexpr Table {0} = {{{1}_arguments, {0}_elements, {2}, {3}}};",
                            name, searched, table.arguments.size(), size));
  }
}

std::string TablePlaceText(const std::string& searched, bool repeats, const std::string& argument,
                           HelperSet& helpers) {
  helpers.Use(Helper::kTable);
  const std::string place =
      repeats ? fmt::format("{}({}, {})", helpers.Use(Helper::kInFirstRound), searched, argument)
              : argument;
  return fmt::format("{}({}, {})", helpers.Use(Helper::kFindPlace), searched, place);
}

}  // namespace compiler
