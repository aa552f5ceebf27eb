#include "compiler/check/table_elements.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "compiler/check/conversion.h"
#include "compiler/check/table_columns.h"
#include "compiler/check/table_messages.h"
#include "compiler/check/type.h"
#include "compiler/check/unit.h"

namespace compiler {
namespace {

// As large as a number may be in SI units: differences of two stay finite.
constexpr double kLargestNumber = 1e300;

// How far the length of a rotation may be from 1, which digits that were left out explain.
constexpr double kLengthTolerance = 0.01;

class ElementsCheck {
 public:
  ElementsCheck(const TableDeclaration& table, const DeclaredType& declared,
                const std::vector<std::string>& misspelled, const TaskScope& scope)
      : table_(table),
        file_(*table.source.file),
        declared_(declared),
        misspelled_(misspelled),
        scope_(scope),
        messages_(scope) {}

  std::optional<CheckedTable> Resolve() {
    if (!FindColumns()) return std::nullopt;
    const auto argument = UnitOf(file_.columns.front());
    std::vector<ScaledUnit> units;
    for (const size_t column : columns_)
      if (const auto unit = UnitOfElement(file_.columns[column])) units.push_back(*unit);
    if (!argument || units.size() < columns_.size()) return std::nullopt;
    CheckedTable checked{.name = table_.name.text,
                         .doc = table_.doc,
                         .type = declared_.type,
                         .unit = declared_.unit,
                         .file = table_.source.path,
                         .argument = file_.columns.front().name,
                         .argument_unit = argument->unit,
                         .arguments = {},
                         .elements = {}};
    for (size_t row = 0; row < file_.rows.size(); ++row) {
      checked.arguments.push_back(ToSi(row, 0, *argument));
      for (size_t i = 0; i < columns_.size(); ++i)
        checked.elements.push_back(ToSi(row, columns_[i], units[i]));
    }
    if (IsOfQuaternions(declared_.type)) AlignRotations(checked);
    if (!messages_.is_empty()) return std::nullopt;
    return checked;
  }

 private:
  // ---- Which column is which element ----

  bool FindColumns() {
    std::vector<std::string> missing;
    for (const std::string& name : ColumnNames(table_, declared_.type, scope_)) {
      const auto column = std::find_if(file_.columns.begin() + 1, file_.columns.end(),
                                       [&](const TableColumn& each) { return each.name == name; });
      if (column != file_.columns.end()) {
        columns_.push_back(static_cast<size_t>(column - file_.columns.begin()));
      } else {
        missing.push_back(name);
      }
    }
    const bool is_whole = missing.empty();
    std::erase_if(missing, [&](const std::string& name) {
      return std::ranges::find(misspelled_, name) != misspelled_.end();
    });
    if (!missing.empty()) ReportMissing(missing);
    return is_whole;
  }

  void ReportMissing(const std::vector<std::string>& missing) {
    messages_.Add(
        code::kMissingColumn, file_.columns.front().span,
        fmt::format("the table lacks the column{} {}", missing.size() == 1 ? "" : "s",
                    ListOfColumns(missing)),
        {.note = fmt::format("`{}` is a table of `{}`", table_.name.text, ToString(declared_.type)),
         .help = "write their names in this line, and their numbers below",
         .labels = {{table_.name.span, "for this table"}}});
  }

  // ---- Units ----

  std::optional<ScaledUnit> UnitOf(const TableColumn& column) {
    if (!column.has_unit()) return ScaledUnit{};
    if (column.unit.empty()) return ScaledUnit{};
    const auto unit = ParseUnit(column.unit);
    if (!unit)
      messages_.Add(code::kColumnUnit, column.unit_span,
                    fmt::format("there is no unit `{}`", column.unit),
                    {.help = "units are written as in `[s]`, `[deg]`, `[m/s]` and `[N m]`"});
    return unit;
  }

  std::optional<ScaledUnit> UnitOfElement(const TableColumn& column) {
    auto unit = UnitOf(column);
    if (!unit || unit->unit == declared_.unit) return unit;
    const bool has_unit = column.has_unit() && !IsPlain(unit->unit);
    const Span span = has_unit ? column.unit_span : column.span;
    Explanation explanation;
    explanation.labels = {{table_.name.span, "for this table"}};
    if (!has_unit)
      explanation.help = {
          fmt::format("write `{} [{}]`, or another unit of this kind", column.name,
                      ToString(declared_.unit)),
          {{column.span, fmt::format("{} [{}]", column.name, ToString(declared_.unit))}}};
    messages_.Add(code::kColumnUnit, span,
                  has_unit ? fmt::format("`{}` is in `{}`, and the table is of {}", column.name,
                                         column.unit, NameOf(declared_.unit))
                           : fmt::format("`{}` needs a unit", column.name),
                  std::move(explanation));
    return std::nullopt;
  }

  // ---- Numbers ----

  double ToSi(size_t row, size_t column, const ScaledUnit& unit) {
    const double number = unit.ToSi(file_.At(row, column));
    if (std::abs(number) > kLargestNumber)
      messages_.Add(code::kBadCell, file_.rows[row],
                    fmt::format("in SI units `{}` is too large here", file_.columns[column].name),
                    {.help = "check the number, and the unit of its column"});
    return number;
  }

  // Between two rows the shorter way is taken.
  void AlignRotations(CheckedTable& checked) {
    const size_t size = checked.type.size();
    for (size_t i = 0; i < checked.elements.size(); i += 4) {
      double* rotation = &checked.elements[i];
      const double length = std::sqrt(std::inner_product(rotation, rotation + 4, rotation, 0.0));
      if (!(std::abs(length - 1) <= kLengthTolerance)) {
        ReportLength(file_.rows[i / size], length);
        return;
      }
      const bool is_turned =
          i >= size && std::inner_product(rotation, rotation + 4, rotation - size, 0.0) < 0;
      for (int k = 0; k < 4; ++k) rotation[k] /= is_turned ? -length : length;
    }
  }

  void ReportLength(Span row, double length) {
    messages_.Add(code::kNotARotation, row,
                  fmt::format("a rotation is a quaternion of length 1; here it is {:.3g}", length),
                  {.help = "the columns are `w`, `x`, `y` and `z`, of which `w` is the scalar"});
  }

  const TableDeclaration& table_;
  const TableFile& file_;
  const DeclaredType& declared_;
  const std::vector<std::string>& misspelled_;
  const TaskScope& scope_;
  std::vector<size_t> columns_;  // of each element
  TableMessages messages_;
};

}  // namespace

std::optional<CheckedTable> ResolveElements(const TableDeclaration& table,
                                            const DeclaredType& declared,
                                            const std::vector<std::string>& misspelled,
                                            const TaskScope& scope) {
  return ElementsCheck(table, declared, misspelled, scope).Resolve();
}

}  // namespace compiler
