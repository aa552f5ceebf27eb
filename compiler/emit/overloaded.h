// One lambda for each alternative of a variant, for std::visit.
#pragma once

namespace compiler {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};

}  // namespace compiler
