#include "plugins/host/scalar_bytes.h"

#include <cstring>

namespace host {
namespace {

template <class Number>
double LoadAs(const std::byte* place) {
  Number number;
  std::memcpy(&number, place, sizeof number);
  return static_cast<double>(number);
}

template <class Number>
void StoreAs(std::byte* place, double value) {
  const auto number = static_cast<Number>(value);
  std::memcpy(place, &number, sizeof number);
}

}  // namespace

double LoadScalar(const std::byte* place, taskc_int32 scalar) {
  if (scalar == TASKC_REAL) return LoadAs<double>(place);
  return scalar == TASKC_INT ? LoadAs<taskc_int64>(place) : LoadAs<unsigned char>(place);
}

void StoreScalar(std::byte* place, taskc_int32 scalar, double value) {
  if (scalar == TASKC_REAL) return StoreAs<double>(place, value);
  if (scalar == TASKC_INT) return StoreAs<taskc_int64>(place, value);
  StoreAs<unsigned char>(place, value != 0 ? 1 : 0);
}

}  // namespace host
