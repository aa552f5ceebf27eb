#include "runtime/core/module/composite.h"

#include <fmt/format.h>

#include <utility>

namespace runtime {

Composite::Composite(std::string name, ModuleGraph inner)
    : Module(std::move(name)), inner_(std::move(inner)) {}

void Composite::ExportPort(const std::string& name, std::string_view inner) {
  inner_.FindPort(inner).HandOver(*this, name);
}

void Composite::ExportParameter(const std::string& name, std::string_view inner) {
  const size_t dot = inner.find('.');
  if (dot == std::string_view::npos) {
    throw UserError(fmt::format("`{}` is not a parameter: write MODULE.PARAMETER", inner));
  }
  Module& module = inner_.Find(inner.substr(0, dot));
  Parameter parameter = module.FindParameter(inner.substr(dot + 1));
  if (exported_.contains(name)) {
    throw UserError(
        fmt::format("the module `{}` has a parameter `{}` already", this->name(), name));
  }
  exported_.emplace(name, InnerParameter{&module, parameter.name});
  parameter.name = name;
  AddParameter(std::move(parameter));
}

void Composite::Set(std::string_view parameter, const ParameterValue& value) {
  FindParameter(parameter);  // throws where there is none
  const InnerParameter& inner = exported_.find(parameter)->second;
  inner.module->Set(inner.name, value);  // a module may do more than to keep the value
}

}  // namespace runtime
