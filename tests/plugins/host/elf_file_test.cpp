#include "plugins/host/elf_file.h"

#include <elf.h>
#include <gmock/gmock.h>
#include <link.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

#include "base/seal/seal.h"

namespace host {
namespace {

using testing::HasSubstr;
using testing::Optional;
using testing::StartsWith;

std::filesystem::path PluginFile(const std::string& name) {
  return std::filesystem::path(PLUGIN_FOLDER) / (name + ".so");
}

// Without the seal, of which ELF knows nothing.
std::vector<std::byte> Content(const std::string& plugin) {
  std::ifstream stream(PluginFile(plugin), std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  std::vector<std::byte> content(text.size() - seal::kSize);
  std::memcpy(content.data(), text.data(), content.size());
  return content;
}

// The content with one field of its header changed.
template <class Change>
std::optional<std::string> DefectAfter(Change change) {
  std::vector<std::byte> content = Content("walking");
  ElfW(Ehdr) header;
  std::memcpy(&header, content.data(), sizeof header);
  change(header);
  std::memcpy(content.data(), &header, sizeof header);
  return ElfDefect(content);
}

TEST(ElfDefect, FindsNothingInAWholeFile) {
  EXPECT_EQ(ElfDefect(Content("walking")), std::nullopt);
  EXPECT_EQ(ElfDefect(Content("empty")), std::nullopt);
}

TEST(ElfDefect, FindsEveryCut) {
  const std::vector<std::byte> content = Content("walking");
  ASSERT_GT(content.size(), 1000u);
  for (size_t size = 0; size < content.size(); ++size) {
    ASSERT_NE(ElfDefect(std::span(content).first(size)), std::nullopt) << "cut at " << size;
  }
}

TEST(ElfDefect, SaysWhetherItIsCutOffOrSomethingElse) {
  const std::vector<std::byte> content = Content("walking");
  const std::string text = "task crawling for humanoid";
  EXPECT_THAT(ElfDefect(std::as_bytes(std::span(text))),
              Optional(std::string("is not a shared object")));
  EXPECT_THAT(ElfDefect({}), Optional(std::string("is not a shared object")));
  EXPECT_THAT(ElfDefect(std::span(content).first(20)),
              Optional(std::string("is cut off within its header")));
  EXPECT_THAT(ElfDefect(std::span(content).first(content.size() / 2)),
              Optional(StartsWith("is cut off or damaged: ")));
}

TEST(ElfDefect, FindsATailOfZeros) {
  const std::vector<std::byte> whole = Content("walking");
  for (size_t kept = 64; kept + 64 < whole.size(); kept += 64) {
    std::vector<std::byte> content = whole;
    std::fill(content.begin() + static_cast<long>(kept), content.end(), std::byte{0});
    ASSERT_NE(ElfDefect(content), std::nullopt) << "zeros from " << kept;
  }
}

TEST(ElfDefect, FindsOtherMachinesAndKinds) {
  const std::string other_machine = "is built for another kind of machine";
  EXPECT_THAT(DefectAfter([](auto& header) { header.e_machine = EM_S390; }),
              Optional(other_machine));
  EXPECT_THAT(DefectAfter([](auto& header) { header.e_ident[EI_CLASS] = ELFCLASS32; }),
              Optional(other_machine));
  EXPECT_THAT(DefectAfter([](auto& header) { header.e_type = ET_REL; }),
              Optional(HasSubstr("not a shared object")));
}

TEST(ElfDefect, FindsHeadersThatPointAnywhere) {
  EXPECT_NE(DefectAfter([](auto& header) { header.e_phoff = ~uint64_t{0} - 8; }), std::nullopt);
  EXPECT_NE(DefectAfter([](auto& header) { header.e_shoff = ~uint64_t{0} - 8; }), std::nullopt);
  EXPECT_NE(DefectAfter([](auto& header) { header.e_phnum = 60000; }), std::nullopt);
  EXPECT_NE(DefectAfter([](auto& header) { header.e_shnum = 60000; }), std::nullopt);
  EXPECT_NE(DefectAfter([](auto& header) { header.e_phnum = 0; }), std::nullopt);
}

TEST(ElfDefect, ReadsNothingOutsideOfGarbage) {
  std::mt19937 random(1);
  const std::vector<std::byte> whole = Content("walking");
  for (int round = 0; round < 2000; ++round) {
    std::vector<std::byte> content(whole.begin(),
                                   whole.begin() + 64 + static_cast<long>(random() % 2000));
    for (size_t i = 16; i < content.size(); ++i) content[i] = static_cast<std::byte>(random());
    EXPECT_NE(ElfDefect(content), std::nullopt);
  }
}

}  // namespace
}  // namespace host
