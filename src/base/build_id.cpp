// Which build of the program this is: the ELF note NT_GNU_BUILD_ID.
// SPDX-License-Identifier: MIT
#include "base/build_id.h"

#include <link.h>
#include <spdlog/fmt/fmt.h>

#include <cstring>
#include <span>
#include <string_view>

namespace facet::base {
namespace {

constexpr std::size_t aligned(std::size_t bytes) { return (bytes + 3) / 4 * 4; }

/// The description of the note in one segment; empty where it is not there.
std::span<const unsigned char> find_note(std::span<const unsigned char> segment) {
    while (segment.size() >= sizeof(ElfW(Nhdr))) {
        ElfW(Nhdr) note{};
        std::memcpy(&note, segment.data(), sizeof note);
        const std::size_t name = sizeof note;
        const std::size_t text = name + aligned(note.n_namesz);
        const std::size_t end = text + aligned(note.n_descsz);
        if (end > segment.size()) return {};
        if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 &&
            std::memcmp(segment.data() + name, "GNU", 4) == 0)
            return segment.subspan(text, note.n_descsz);
        segment = segment.subspan(end);
    }
    return {};
}

/// The program itself comes first, and ends the walk.
int visit(dl_phdr_info* object, std::size_t, void* out) {
    for (ElfW(Half) i = 0; i < object->dlpi_phnum; ++i) {
        const ElfW(Phdr)& header = object->dlpi_phdr[i];
        if (header.p_type != PT_NOTE) continue;
        const auto* const begin =
            reinterpret_cast<const unsigned char*>(object->dlpi_addr + header.p_vaddr);
        for (const unsigned char byte : find_note({begin, header.p_memsz}))
            *static_cast<std::string*>(out) += fmt::format("{:02x}", byte);
    }
    return 1;
}

}  // namespace

std::string build_id() {
    std::string id;
    ::dl_iterate_phdr(visit, &id);
    return id;
}

}  // namespace facet::base
