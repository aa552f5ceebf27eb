// The graph as a picture of itself: modules, parameters, connections.
#pragma once

#include <string>

#include "runtime/core/module/module_graph.h"

namespace runtime {

// One line for each module, parameter and connection, and for each value that a module shows a
// learner, for a person.
std::string GraphText(const ModuleGraph& graph);

// {"modules": [{"name", "parameters": {NAME: value}, "ports": [{"name", "kind", "type"}],
//               "shows": [{"name", "type", "unit", "first", "size", "least", "greatest"}]}],
//  "connections": [{"from", "to", "type"}]}, in the order of their creation.
// "shows" only where a module shows a learner what it sees (runtime/core/module/layout_text.h).
std::string GraphJson(const ModuleGraph& graph);

// For Graphviz: a box for each module, an arrow for each connection; full arrows are signals,
// dashed ones are values. `dot -Tsvg` draws it.
std::string GraphDot(const ModuleGraph& graph);

}  // namespace runtime
