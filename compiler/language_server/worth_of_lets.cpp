#include "compiler/language_server/worth_of_lets.h"

#include <algorithm>
#include <cmath>

#include "compiler/document/value_text.h"
#include "compiler/interpret/lets_worth.h"

namespace compiler {

protocol::Json WorthOfLets(const Analysis& analysis, const protocol::Json& known) {
  if (!analysis.task || analysis.diagnostics.has_errors()) return nullptr;
  protocol::Json lets = protocol::Json::array();
  for (const LetWorth& let : LetsWorth(*analysis.task, known.get<KnownNumbers>())) {
    const Reals numbers = ToReals(let.value);
    // JSON has no other numbers.
    if (!std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); }))
      continue;
    lets.push_back({{"name", let.name},
                    {"type", ToString(let.type)},
                    {"unit", UnitText(let.unit)},
                    {"numbers", numbers}});
  }
  return lets;
}

}  // namespace compiler
