#include "tests/runtime/analysis/report/report_page.h"

#include <cstring>

#include "runtime/training/run/run_files.h"

namespace runtime {

nlohmann::json DataOfPage(const std::filesystem::path& page) {
  constexpr std::string_view kBegin = "<script id=\"report-data\" type=\"application/json\">";
  const std::string text = ReadText(page);
  const size_t begin = text.find(kBegin) + kBegin.size();
  return nlohmann::json::parse(text.substr(begin, text.find("</script>", begin) - begin));
}

std::vector<float> Floats(const nlohmann::json& text) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  uint32_t bits = 0;
  int count = 0;
  for (const char c : text.get<std::string>()) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<uint32_t>(kDigits.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 255);
  }
  std::vector<float> values(bytes.size() / sizeof(float));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(float));
  return values;
}

}  // namespace runtime
