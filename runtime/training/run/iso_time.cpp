#include "runtime/training/run/iso_time.h"

#include <fmt/chrono.h>

#include <chrono>
#include <cstdio>

namespace runtime {

std::string IsoTimeNow() {
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", now);
}

double SecondsSince1970(const std::string& iso_time) {
  using namespace std::chrono;
  int y = 0, m = 0, d = 0, h = 0, min = 0, s = 0;
  if (std::sscanf(iso_time.c_str(), "%d-%d-%dT%d:%d:%dZ", &y, &m, &d, &h, &min, &s) != 6) return 0;
  const sys_seconds time =
      sys_days(year(y) / month(static_cast<unsigned>(m)) / day(static_cast<unsigned>(d))) +
      hours(h) + minutes(min) + seconds(s);
  return static_cast<double>(time.time_since_epoch().count());
}

}  // namespace runtime
