// One lambda for each alternative of a variant, for std::visit.
#pragma once

namespace compiler {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;  // clang before 17 does not deduce it

}  // namespace compiler
