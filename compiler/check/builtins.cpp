#include "compiler/check/builtins.h"

#include <algorithm>
namespace compiler {
namespace {

constexpr BuiltinDescription kBuiltins[] = {
#define BUILTIN(id, name, least, most, arguments, units, usage) \
  {name, Builtin::id, least, most, ArgumentRule::arguments, UnitRule::units, usage},
#define CONSTRUCTOR(name, count, usage) \
  {name, Builtin::kVector, count, count, ArgumentRule::kParts, UnitRule::kSame, usage},
#define COMPOSITE(id, name, least, most, arguments, units, usage) \
  {name, Composite::id, least, most, ArgumentRule::arguments, UnitRule::units, usage},
#include "compiler/check/builtin_table.def"
};

}  // namespace

const BuiltinDescription* FindBuiltin(std::string_view name) {
  const auto found = std::ranges::find(kBuiltins, name, &BuiltinDescription::name);
  return found == std::end(kBuiltins) ? nullptr : &*found;
}

std::vector<std::string> BuiltinNames() {
  std::vector<std::string> names;
  for (const BuiltinDescription& builtin : kBuiltins) names.emplace_back(builtin.name);
  return names;
}

bool IsElementwise(Builtin function) {
  return std::ranges::any_of(kBuiltins, [&](const BuiltinDescription& builtin) {
    const bool takes_elements = builtin.arguments == ArgumentRule::kElements ||
                                builtin.arguments == ArgumentRule::kRealElements;
    return takes_elements && builtin.function == std::variant<Builtin, Composite>(function);
  });
}

}  // namespace compiler
