#include "base/seal/sha256.h"

// libmd: every Debian machine already has it (dpkg stands on it), and it costs a program's start
// next to nothing, where OpenSSL's libcrypto is 4.5 MB to load.
#include <sys/types.h>
//
#include <sha256.h>

#include <array>

namespace seal {

std::string Sha256(std::string_view bytes) {
  std::array<char, SHA256_DIGEST_STRING_LENGTH> digits;
  SHA256_Data(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size(), digits.data());
  return digits.data();
}

}  // namespace seal
