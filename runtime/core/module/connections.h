#pragma once

#include <string_view>

#include "runtime/core/module/module_graph.h"

namespace runtime {

// Throws UserError if it is an in port that must be connected, and is not.
void RequireConnection(const Port& port);

// Throws UserError if an in port of the module that must be connected is not.
void RequireConnections(const Module& module);

// The first out port of the graph with this name and type, or null.
Port* FindOut(const ModuleGraph& graph, std::string_view name, const PortType& type);

// Connects each in port of the module that is for a sensor (sensor_data.h) and has no connection
// yet to the out port of its name and type, if another module of the graph has one.
void ConnectSensors(const Module& module, const ModuleGraph& graph);

}  // namespace runtime
