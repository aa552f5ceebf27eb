// Parameters of a graph that runs, by their full names: "task.weight".
#pragma once

#include <string>

#include "runtime/core/module/module.h"
#include "runtime/core/module/module_graph.h"

namespace runtime {

struct NamedParameter {
  Module& module;
  const Parameter& parameter;
};

// Throws UserError for an unknown name, with the nearest one.
NamedParameter FindParameter(const ModuleGraph& graph, const std::string& name);

// The value as a client means it who knows the parameter: a number may be a text that ends with its
// unit, "20 s", and a whole one be written as 3.0. Throws UserError, which calls the parameter
// `name`, for another unit; whether type and range fit is found out by Module::Set().
ParameterValue FitTo(const Parameter& parameter, ParameterValue value, const std::string& name);

// Sets a parameter between two time steps. Throws UserError where the value does not fit, as
// FitTo() and Module::Set(), and for a parameter that has no effect any more.
void SetLive(const ModuleGraph& graph, const std::string& name, ParameterValue value);

}  // namespace runtime
