// For std::visit: one lambda for each alternative of a variant, or for several that are named.
// Without one for the rest, a new alternative that was forgotten does not compile.
#pragma once

#include <type_traits>

namespace variant {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;  // clang before 17 does not deduce it

// `[](const OneOf<A, B> auto& each) {...}` is for A and for B.
template <class Type, class... Types>
concept OneOf = (std::is_same_v<Type, Types> || ...);

}  // namespace variant
