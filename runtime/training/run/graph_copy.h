// A second graph in which an episode goes exactly as in a run's own.
#pragma once

#include "runtime/core/module/context.h"
#include "runtime/core/module/module_graph.h"

namespace runtime {

// The same modules with the same parameters, connected in the same way, and started; tasks with
// what they keep from episode to episode. A learner has learned nothing (Learner::Follow()). What
// nobody hears or reads is left out.
//
// `graph` runs no episode now, and was made of `types` and `context`, which outlive the copy.
// Throws UserError where a module cannot be made again.
ModuleGraph CopyOf(const ModuleGraph& graph, const ModuleTypes& types, const Context& context);

// Gives the modules of a copy the parameters that those of `graph` have now.
void CopyParameters(const ModuleGraph& graph, const ModuleGraph& copy);

}  // namespace runtime
