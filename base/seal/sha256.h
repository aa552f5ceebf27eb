// SHA-256, by which sources and cache entries are known.
#pragma once

#include <string>
#include <string_view>

namespace seal {

// 64 hexadecimal digits, lower case.
std::string Sha256(std::string_view bytes);

}  // namespace seal
