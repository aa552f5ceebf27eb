// The task's tables as C++: their numbers, and the calls that read them.
#pragma once

#include <string>

#include "compiler/check/checked_task.h"
#include "compiler/emit/function_emitter.h"
#include "compiler/emit/helper_functions.h"
#include "compiler/emit/text_writer.h"

namespace compiler {

// The tables that the plugin's functions read, after its helpers.
void EmitLookupTables(const CheckedTask& task, const PluginNames& names, TextWriter& writer);

// Between which rows of the table called `table` an argument lies.
std::string TablePlaceText(const std::string& table, bool repeats, const std::string& argument,
                           HelperSet& helpers);

}  // namespace compiler
