#include "compiler/emit/emit.h"

#include <fmt/format.h>
#include <taskc/plugin.h>

#include "compiler/emit/function_emitter.h"
#include "compiler/emit/lookup_tables.h"
#include "compiler/emit/table_emitter.h"

namespace compiler {
namespace {

void EmitFunctions(const CheckedTask& task, const Sources& sources, const PluginNames& names,
                   TextWriter& writer, HelperSet& helpers) {
  FunctionEmitter functions(task, sources, names, writer, helpers);
  for (uint32_t i = 0; i < task.functions.size(); ++i) functions.EmitFunction(i);
  for (uint32_t i = 0; i < task.goals.size(); ++i) functions.EmitDraw(i);
  if (DrawsPose(task)) functions.EmitDrawPose();
  if (DrawsStart(task)) functions.EmitDrawStart();
  functions.EmitInitialize();
  for (int event = 0; event < TASKC_EVENT_COUNT; ++event) {
    auto kind = static_cast<EventKind>(event);
    if (HasFunction(task, kind)) functions.EmitEvent(kind);
  }
  if (!task.metrics.empty()) functions.EmitMeasure();
  if (!task.observations.empty()) functions.EmitObserve();
  writer.LeaveSource();
}

void EmitHelpers(const HelperSet& helpers, bool of_library, TextWriter& writer) {
  for (int i = 0; i < kHelperCount; ++i) {
    auto helper = static_cast<Helper>(i);
    if (!helpers.Has(helper) || IsOfLibrary(helper) != of_library) continue;
    writer.BlankLine();
    writer.Line(HelperText(helper));
  }
}

}  // namespace

std::string Emit(const CheckedTask& task, const Sources& sources) {
  return EmitWithOrigins(task, sources).text;
}

EmittedText EmitWithOrigins(const CheckedTask& task, const Sources& sources) {
  PluginNames names(task);
  std::string own_path = task.name + ".cpp";

  // Which helpers there are is known only once the functions are written; where the functions stand
  // in the text, only once the helpers are. So the functions are written twice.
  HelperSet helpers;
  TextWriter rehearsal(own_path);
  EmitFunctions(task, sources, names, rehearsal, helpers);

  TextWriter writer(own_path);
  writer.Line(fmt::format("// Made from the task `{}` by taskc {}.", task.name, TASKC_VERSION));
  writer.Line("#include <taskc/plugin.h>");
  EmitHelpers(helpers, true, writer);
  writer.BlankLine();
  writer.Line("namespace {");
  EmitTables(task, sources, names, writer);
  EmitHelpers(helpers, false, writer);
  EmitLookupTables(task, names, writer);
  EmitFunctions(task, sources, names, writer, helpers);
  EmitEntry(task, sources, names, writer);
  writer.BlankLine();
  writer.Line("}  // namespace");
  writer.BlankLine();
  writer.Line(
      "extern \"C\" __attribute__((visibility(\"default\"))) "
      "const taskc_plugin* taskc_plugin_get() {");
  writer.Line("  return &plugin;");
  writer.Line("}");
  return {writer.text(), writer.origins()};
}

}  // namespace compiler
