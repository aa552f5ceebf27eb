// What of a machine and its programs may decide about the bits of a run.
#pragma once

#include <string>
#include <vector>

namespace runtime {

struct MachineFact {
  std::string name;   // "libm"
  std::string value;  // "glibc 2.36, build d6e6f9e3"
  bool operator==(const MachineFact&) const = default;
};

// In the order in which a person reads them.
using MachineFacts = std::vector<MachineFact>;

// Of this process: the trainer and its compiler, the libraries that compute for it, what the
// processor can do. `libm values` is a hash of what libm's functions give for many numbers: two
// machines for which it is equal compute the same, whatever their libraries are called.
MachineFacts ThisMachine();

// What makes `here` compute other bits than `before`: "libm values, ODE"; "" where nothing that is
// known of both does.
std::string WhyOtherBits(const MachineFacts& before, const MachineFacts& here);

// As a run's record holds them, JSON.
std::string MachineText(const MachineFacts& facts);
// None where the text says nothing that can be understood.
MachineFacts ParseMachine(const std::string& text);

}  // namespace runtime
