// The state of a run between two episodes as one blob: what every module of the graph saves.
#pragma once

#include <set>
#include <string>

#include "runtime/core/module/module_graph.h"

namespace runtime {

std::string SaveModules(const ModuleGraph& graph);

// Distinguishes states: the first 16 digits of the SHA-256.
std::string StateHash(const std::string& state);

// Into a graph of the same modules, started already. Throws UserError where the state is damaged
// or belongs to other modules.
// The modules in `left_out` need not be the same: see ModuleGraph::Load().
void LoadModules(ModuleGraph& graph, const std::string& state,
                 const std::set<std::string>& left_out = {});

}  // namespace runtime
