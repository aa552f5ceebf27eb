#include "runtime/training/run/machine.h"

#include <elf.h>
#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <link.h>
#include <sys/utsname.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/seal/sha256.h"

namespace runtime {
namespace {

constexpr size_t kDigits = 16;  // of a hash
constexpr const char* kLibmValues = "libm values";
constexpr const char* kOde = "ODE";

constexpr std::string_view kGnu("GNU\0", 4);  // whose note it is

struct LoadedFile {
  std::string file;   // "" for the program itself
  std::string build;  // the linker's id of its content, in hexadecimal; "" without one
};

std::string BuildId(const char* notes, size_t size) {
  while (size >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) note;
    std::memcpy(&note, notes, sizeof note);
    const auto padded = [](size_t bytes) { return (bytes + 3) / 4 * 4; };
    const size_t name = sizeof note;
    const size_t content = name + padded(note.n_namesz);
    const size_t end = content + padded(note.n_descsz);
    if (end > size) break;
    if (note.n_type == NT_GNU_BUILD_ID && std::string_view(notes + name, note.n_namesz) == kGnu) {
      std::string text;
      for (size_t i = 0; i < note.n_descsz; ++i) {
        text += fmt::format("{:02x}", static_cast<unsigned char>(notes[content + i]));
      }
      return text.substr(0, kDigits);
    }
    notes += end;
    size -= end;
  }
  return "";
}

int Note(dl_phdr_info* info, size_t, void* data) {
  LoadedFile loaded{info->dlpi_name, ""};
  for (int i = 0; i < info->dlpi_phnum && loaded.build.empty(); ++i) {
    const ElfW(Phdr)& segment = info->dlpi_phdr[i];
    if (segment.p_type != PT_NOTE) continue;
    const auto* notes = reinterpret_cast<const char*>(info->dlpi_addr + segment.p_vaddr);
    loaded.build = BuildId(notes, segment.p_memsz);
  }
  static_cast<std::vector<LoadedFile>*>(data)->push_back(std::move(loaded));
  return 0;
}

std::vector<LoadedFile> LoadedFiles() {
  std::vector<LoadedFile> files;
  dl_iterate_phdr(Note, &files);
  return files;
}

std::string WithBuild(const std::string& version, const std::string& build) {
  return build.empty() ? version : fmt::format("{}, build {}", version, build);
}

// `name`: "libode.so".
const LoadedFile* Find(const std::vector<LoadedFile>& files, std::string_view name) {
  for (const LoadedFile& each : files) {
    if (std::filesystem::path(each.file).filename().string().starts_with(name)) return &each;
  }
  return nullptr;
}

// The file that a library's name leads to has its version at the end: libode.so.8.1.3.
std::string OdeText(const std::vector<LoadedFile>& files) {
  const LoadedFile* ode = Find(files, "libode.so");
  if (ode == nullptr) return "part of the trainer";
  std::error_code ignored;
  const std::filesystem::path file = std::filesystem::canonical(ode->file, ignored);
  return WithBuild(file.filename().string(), ode->build);
}

std::string LibmText(const std::vector<LoadedFile>& files) {
  const LoadedFile* libm = Find(files, "libm.so");
  return WithBuild(fmt::format("glibc {}", gnu_get_libc_version()),
                   libm == nullptr ? "" : libm->build);
}

// glibc chooses among versions of its functions by what the processor can do, and those differ in
// the last bit.
std::string LibmValues() {
  std::string bytes;
  const auto add = [&](auto value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  constexpr int kSamples = 4000;
  for (int i = 1; i <= kSamples; ++i) {
    const volatile double x = 0.0137 * i;  // computed when it runs, not by the compiler
    const double in_one = x / (0.0137 * kSamples);
    for (const double value :
         {std::sin(x), std::cos(x), std::tan(x), std::atan(x), std::atan2(x, 1.7), std::exp(-x),
          std::exp(x), std::log(x), std::pow(x, 0.37), std::tanh(x), std::asin(in_one),
          std::acos(in_one), std::hypot(x, 0.7), std::cbrt(x)}) {
      add(value);
    }
    const auto single = static_cast<float>(x);
    for (const float value :
         {std::exp(-single), std::tanh(single), std::sin(single), std::log(single)}) {
      add(value);
    }
  }
  return seal::Sha256(bytes).substr(0, kDigits);
}

std::string ProcessorClass() {
  utsname system{};
  uname(&system);
  std::string text = system.machine;
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx")) text += " avx";
  if (__builtin_cpu_supports("fma")) text += " fma";
  if (__builtin_cpu_supports("avx2")) text += " avx2";
  if (__builtin_cpu_supports("avx512f")) text += " avx512f";
#endif
  return text;
}

std::string ProcessorModel() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string CompilerText() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "GCC " __VERSION__;
#endif
}

}  // namespace

MachineFacts ThisMachine() {
  const std::vector<LoadedFile> files = LoadedFiles();
  return {{"trainer", WithBuild(TASKC_VERSION, files.empty() ? "" : files.front().build)},
          {"compiler of the trainer", CompilerText()},
          {"libm", LibmText(files)},
          {kLibmValues, LibmValues()},
          {kOde, OdeText(files)},
          {"Eigen",
           fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"processor", ProcessorClass()},
          {"processor model", ProcessorModel()}};
}

std::string WhyOtherBits(const MachineFacts& before, const MachineFacts& here) {
  std::string names;
  for (const MachineFact& fact : here) {
    const bool decides = fact.name == kLibmValues || fact.name == kOde;
    const auto old = std::ranges::find(before, fact.name, &MachineFact::name);
    if (!decides || old == before.end() || old->value == fact.value) continue;
    names += (names.empty() ? "" : ", ") + fact.name;
  }
  return names;
}

std::string MachineText(const MachineFacts& facts) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const MachineFact& fact : facts) json[fact.name] = fact.value;
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

MachineFacts ParseMachine(const std::string& text) {
  MachineFacts facts;
  const auto json = nlohmann::ordered_json::parse(text, nullptr, false);
  if (!json.is_object()) return facts;
  for (const auto& [name, value] : json.items()) {
    if (value.is_string()) facts.push_back({name, value.get<std::string>()});
  }
  return facts;
}

}  // namespace runtime
