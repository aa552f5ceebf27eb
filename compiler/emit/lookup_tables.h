// The task's tables as C++: their numbers, and the calls that read them.
#pragma once

#include <string>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/emit/function_emitter.h"
#include "compiler/emit/helper_functions.h"
#include "compiler/emit/text_writer.h"
#include "compiler/emit/unique_names.h"

namespace compiler {

// All tables of the task, under names that are free at file scope.
std::vector<LookupTable> NameLookupTables(const CheckedTask& task, UniqueNames& taken);

// The tables that the plugin's functions read, after its helpers.
void EmitLookupTables(const CheckedTask& task, const PluginNames& names, TextWriter& writer);

// Between which rows of the table called `searched` an argument lies.
std::string TablePlaceText(const std::string& searched, bool repeats, const std::string& argument,
                           HelperSet& helpers);

}  // namespace compiler
