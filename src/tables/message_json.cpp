// Errors and warnings as JSON objects.
// SPDX-License-Identifier: MIT
#include "tables/message_json.h"

#include "tables/exit_codes.h"

#include <nlohmann/json.hpp>

namespace facet::tables {
namespace {

/// `Message` is Error or Warning. The line without the places, which an object holds apart.
template <class Message>
nlohmann::ordered_json object(std::string_view severity, std::string_view code, const Message& m) {
    std::string text = m.what;
    if (!m.found.empty()) text += " (" + m.found + ")";
    if (!m.remedy.empty()) text += "; " + m.remedy;
    return {{"severity", severity},
            {"code", code},
            {"path", m.file},
            {"pointer", m.where},
            {"message", text}};
}

}  // namespace

nlohmann::ordered_json message_object(const base::Error& error) {
    return object("error", exit_name(base::exit_code(error.code)), error);
}
nlohmann::ordered_json message_object(const base::Warning& warning) {
    return object("warning", "warning", warning);
}

}  // namespace facet::tables
