#include "plugins/host/elf_file.h"

#include <elf.h>
#include <fmt/format.h>
#include <link.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace host {
namespace {

using Header = ElfW(Ehdr);
using Segment = ElfW(Phdr);
using Section = ElfW(Shdr);

constexpr uint64_t kLargestImage = uint64_t{1} << 30;  // bytes in memory

#if defined(__x86_64__)
constexpr unsigned kThisMachine = EM_X86_64;
#elif defined(__aarch64__)
constexpr unsigned kThisMachine = EM_AARCH64;
#else
#error "say here which machine a shared object must be for"
#endif

class ElfReader {
 public:
  explicit ElfReader(std::span<const std::byte> content) : content_(content) {}

  std::optional<std::string> Defect() {
    if (content_.size() < SELFMAG || std::memcmp(content_.data(), ELFMAG, SELFMAG) != 0) {
      return "is not a shared object";
    }
    if (!Read(0, header_)) return "is cut off within its header";
    if (auto defect = OtherMachine()) return defect;
    if (auto defect = BadSegments()) return defect;
    return BadSections();
  }

  // Of the section `name`, its bytes; nothing where there is none. After Defect() has found none.
  std::string SectionCalled(std::string_view name) const {
    Section names;
    if (!Read(header_.e_shoff + header_.e_shstrndx * sizeof(Section), names)) return "";
    for (unsigned i = 0; i < header_.e_shnum; ++i) {
      Section section;
      if (!Read(header_.e_shoff + i * sizeof(Section), section)) break;
      const uint64_t at = names.sh_offset + section.sh_name;
      if (!Holds(at, name.size() + 1) || !Holds(section.sh_offset, section.sh_size)) continue;
      if (Text(at, name.size() + 1) != std::string(name) + '\0') continue;
      return Text(section.sh_offset, section.sh_size);
    }
    return "";
  }

 private:
  std::string Text(uint64_t offset, uint64_t size) const {
    return {reinterpret_cast<const char*>(content_.data() + offset), size};
  }

  bool Holds(uint64_t offset, uint64_t size) const {
    return offset <= content_.size() && size <= content_.size() - offset;
  }

  template <class T>
  bool Read(uint64_t offset, T& value) const {
    if (!Holds(offset, sizeof(T))) return false;
    std::memcpy(&value, content_.data() + offset, sizeof(T));
    return true;
  }

  std::string CutOff(const char* what) const {
    return fmt::format("is cut off or damaged: {} not within its {} bytes", what, content_.size());
  }

  std::optional<std::string> OtherMachine() const {
    const unsigned char word_size = sizeof(void*) == 8 ? ELFCLASS64 : ELFCLASS32;
    const unsigned char byte_order =
        std::endian::native == std::endian::little ? ELFDATA2LSB : ELFDATA2MSB;
    if (header_.e_ident[EI_CLASS] != word_size || header_.e_ident[EI_DATA] != byte_order ||
        header_.e_machine != kThisMachine) {
      return "is built for another kind of machine";
    }
    if (header_.e_type != ET_DYN) return "is an ELF file, but not a shared object";
    return std::nullopt;
  }

  std::optional<std::string> BadSegments() const {
    if (header_.e_phnum == 0 || header_.e_phentsize != sizeof(Segment)) {
      return "is damaged: it has no program headers";
    }
    uint64_t end_of_last = 0;
    for (unsigned i = 0; i < header_.e_phnum; ++i) {
      Segment segment;
      if (!Read(header_.e_phoff + i * sizeof(Segment), segment)) {
        return CutOff("its program headers are");
      }
      if (segment.p_type != PT_LOAD && segment.p_type != PT_DYNAMIC) continue;
      if (!Holds(segment.p_offset, segment.p_filesz)) return CutOff("a segment is");
      if (segment.p_type != PT_LOAD) continue;
      // The loader reserves one stretch of memory for all segments and trusts their order.
      if (segment.p_memsz < segment.p_filesz || segment.p_memsz > kLargestImage ||
          segment.p_vaddr > kLargestImage || segment.p_vaddr < end_of_last) {
        return "is damaged: its segments overlap";
      }
      end_of_last = segment.p_vaddr + segment.p_memsz;
    }
    return end_of_last == 0 ? std::optional("is damaged: there is nothing to load") : std::nullopt;
  }

  // The table of sections stands at the end of the file, so what is cut off always shows here.
  std::optional<std::string> BadSections() const {
    if (header_.e_shnum == 0 || header_.e_shentsize != sizeof(Section)) {
      return "is damaged: it has no section headers";
    }
    for (unsigned i = 0; i < header_.e_shnum; ++i) {
      Section section;
      if (!Read(header_.e_shoff + i * sizeof(Section), section)) {
        return CutOff("its section headers are");
      }
      if (i == header_.e_shstrndx && section.sh_type != SHT_STRTAB) {
        return "is damaged: its section headers are overwritten";
      }
      if (section.sh_type == SHT_NULL || section.sh_type == SHT_NOBITS) continue;
      if (!Holds(section.sh_offset, section.sh_size)) return CutOff("a section is");
    }
    return std::nullopt;
  }

  std::span<const std::byte> content_;
  Header header_{};
};

}  // namespace

std::optional<std::string> ElfDefect(std::span<const std::byte> content) {
  return ElfReader(content).Defect();
}

std::string ElfCompiler(std::span<const std::byte> content) {
  ElfReader reader(content);
  if (reader.Defect()) return "";
  const std::string text = reader.SectionCalled(".comment");
  return text.substr(0, text.find('\0'));
}

}  // namespace host
