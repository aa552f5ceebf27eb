#include "tests/compiler/emit/emitted_text.h"

#include <stdexcept>

#include "compiler/emit/emit.h"
#include "tests/compiler/check/checked_source.h"

namespace compiler {

std::string EmitText(const std::string& text, const std::string& path) {
  CheckedSource checked(path, text);
  if (!checked.task) throw std::runtime_error(checked.Messages());
  return Emit(*checked.task, checked.sources);
}

}  // namespace compiler
