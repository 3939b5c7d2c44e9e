// The two streams: results and messages.
// SPDX-License-Identifier: MIT
#include "cli/io.h"

#include "base/text.h"
#include "tables/message_json.h"

#include <nlohmann/json.hpp>
#include <unistd.h>

namespace facet::cli {
namespace {

constexpr std::size_t most_messages = 20;

}  // namespace

Io::Io(std::FILE* out, std::FILE* err) : out_(out), err_(err) {}

void Io::print(std::string_view line) {
    whole_ = whole_ && std::fwrite(line.data(), 1, line.size(), out_) == line.size() &&
             std::fputc('\n', out_) != EOF;
}

void Io::print_object(const nlohmann::ordered_json& object) {
    // Names in files need not be UTF-8; what cannot be said in JSON becomes U+FFFD instead of an
    // exception.
    print(object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

void Io::print_bytes(std::span<const std::byte> bytes) {
    whole_ = whole_ && std::fwrite(bytes.data(), 1, bytes.size(), out_) == bytes.size();
}

void Io::note(std::string_view line) {
    std::fwrite(line.data(), 1, line.size(), err_);
    std::fputc('\n', err_);
}

void Io::complain(const base::Error& error) {
    const std::string line = base::to_line(error);
    note((color ? "\033[1;31mfacet:\033[0m " : "facet: ") + line);
    if (json) print_object(tables::message_object(error));
}

void Io::warn(std::span<const base::Warning> warnings, bool as_objects) {
    if (!quiet) {
        const std::string_view head =
            color ? "\033[1;33mfacet: warning:\033[0m " : "facet: warning: ";
        for (const base::Warning& warning :
             warnings.first(std::min(warnings.size(), most_messages)))
            note(std::string(head) + base::to_line(warning));
        if (warnings.size() > most_messages)
            note("... and " + std::to_string(warnings.size() - most_messages) + " more");
    }
    if (json && as_objects)
        for (const base::Warning& warning : warnings) print_object(tables::message_object(warning));
}

bool Io::finish() {
    whole_ = std::fflush(out_) == 0 && whole_;
    std::fflush(err_);
    return whole_;
}

bool Io::out_is_terminal() const { return ::isatty(::fileno(out_)) == 1; }

}  // namespace facet::cli
