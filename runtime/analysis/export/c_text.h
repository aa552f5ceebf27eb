// Pieces of C.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

namespace runtime {

// What a comment's line can hold: other people's names must neither end it nor go on in the next.
std::string CComment(std::string_view text);

// A constant that reads back to the same bits.
std::string CLiteral(float value);

// The definition of a constant array.
std::string CArray(const std::string& name, const Eigen::VectorXf& elements);

}  // namespace runtime
