// The base of all modules: a name, ports, parameters, and a part in checkpoints.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "runtime/base/user_error.h"
#include "runtime/core/module/port.h"

namespace runtime {

using ParameterValue = std::variant<bool, int64_t, double, std::string, std::vector<double>>;

// As TOML writes it: `true`, `3`, `0.5`, `"bq01"`, `[0.1, 0.2]`. Reals keep every bit.
std::string ToText(const ParameterValue& value);

// A module's named, typed setting. It refers to a member variable of the module, whose initial
// value is the default.
struct Parameter {
  std::string name;
  std::string doc;
  std::variant<bool*, int*, int64_t*, double*, std::string*, std::vector<double>*> target;
  std::vector<std::string> choices = {};  // for strings: the allowed values; empty: any
  // For numbers, and each number of a list: the allowed range, limits included.
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  // What a choice was called in earlier versions, and what it is called now: files with the old
  // word go on being read.
  std::map<std::string, std::string> former_choices = {};
  std::string unit = {};  // "s"; "" for a plain number
  bool is_live = true;    // false: what is set after the start has no effect

  // Throws UserError, which calls the parameter `full_name`, unless the value is finite and in the
  // range.
  void CheckRange(const std::string& full_name, double value) const;
};

class Module {
 public:
  explicit Module(std::string name) : name_(std::move(name)) {}
  Module(const Module&) = delete;
  Module& operator=(const Module&) = delete;
  virtual ~Module() = default;

  const std::string& name() const { return name_; }
  // How ModuleTypes calls modules of its kind; "" for one that was not made by name.
  const std::string& type() const { return type_; }
  // In the order of their creation.
  const std::vector<Port*>& ports() const { return ports_; }
  const std::vector<Parameter>& parameters() const { return parameters_; }

  // Throws UserError for an unknown name, with the nearest one.
  Port& FindPort(std::string_view port) const;

  // Throws UserError for an unknown name, with the nearest one.
  const Parameter& FindParameter(std::string_view parameter) const;

  // Sets a parameter; integers are accepted where a real is wanted. Throws UserError for an unknown
  // name (with the nearest one), a wrong type, a number that is out of range or not finite, or a
  // text that is not among the choices.
  virtual void Set(std::string_view parameter, const ParameterValue& value);
  // Throws UserError for an unknown name.
  ParameterValue Get(std::string_view parameter) const;

  // Called once, after all parameters are set and all ports connected. Throws UserError where they
  // do not fit together.
  virtual void Start() {}

  // What the module has learned or counted, written and read at episode boundaries so that a
  // resumed run continues bit for bit. Modules without such a state leave these as they are.
  virtual void Save(std::ostream&) const {}
  virtual void Load(std::istream&) {}

 protected:
  void AddParameter(Parameter parameter) { parameters_.push_back(std::move(parameter)); }
  void ReplaceParameters(std::vector<Parameter> parameters) { parameters_ = std::move(parameters); }

 private:
  friend class Port;
  friend class ModuleTypes;

  std::string name_;
  std::string type_;
  std::vector<Port*> ports_;
  std::vector<Parameter> parameters_;
};

}  // namespace runtime
