#include "compiler/language_server/page_of_task.h"

#include "compiler/document/page_json.h"
#include "compiler/document/task_page.h"

namespace compiler {

protocol::Json PageOfTask(const Analysis& analysis) {
  if (!analysis.task || analysis.diagnostics.has_errors()) return nullptr;
  return ToJson(PageOf(analysis));
}

}  // namespace compiler
