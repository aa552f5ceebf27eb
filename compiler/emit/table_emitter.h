// The tables that describe a task to its host: sensors, parameters, memory, terms, metrics, ends,
// and the `taskc_plugin` that holds them.
#pragma once

#include "compiler/check/checked_task.h"
#include "compiler/emit/function_emitter.h"
#include "compiler/emit/text_writer.h"
#include "compiler/source/sources.h"

namespace compiler {

// The struct `Memory` and the tables of all that the task declares.
void EmitTables(const CheckedTask& task, const Sources& sources, const PluginNames& names,
                TextWriter& writer);

// The description of the whole plugin and the function that returns it.
void EmitEntry(const CheckedTask& task, const Sources& sources, const PluginNames& names,
               TextWriter& writer);

}  // namespace compiler
