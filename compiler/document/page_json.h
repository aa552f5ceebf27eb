// A page as data, for programs that show it in their own way (docs/editors.md, `task/page`).
#pragma once

#include <nlohmann/json.hpp>

#include "compiler/document/page.h"

namespace compiler {

nlohmann::json ToJson(const Page& page);

}  // namespace compiler
