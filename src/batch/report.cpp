// A contact sheet: one page that needs nothing else.
// SPDX-License-Identifier: MIT
#include "batch/report.h"

#include "base/file.h"
#include "base/resources.h"
#include "base/text.h"
#include "batch/state.h"
#include "tables/settings_text.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>

namespace facet::batch {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_part_bytes = std::size_t{1} << 20U;

/// A path as a link from the page: bytes that are no part of one are written as %XX.
std::string link_to(const fs::path& target, const fs::path& page) {
    std::error_code error;
    const fs::path folder = fs::absolute(page, error).parent_path();
    const std::string path = fs::absolute(target, error).lexically_relative(folder).string();
    std::string out;
    for (const char c : path) {
        constexpr std::string_view plain = "-_.~/";
        const bool is_plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
                              (c >= 'A' && c <= 'Z') || plain.find(c) != plain.npos;
        out += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return out;
}

/// Whether browsers show the file itself.
bool is_shown(const fs::path& output) {
    constexpr std::array endings = {".png", ".jpg", ".jpeg", ".webp"};
    return std::ranges::find(endings, output.extension().string()) != endings.end();
}

double total_ms(const Json& result) {
    double total = 0.0;
    if (const auto ms = result.find("ms"); ms != result.end())
        for (const Json& part : *ms)
            if (part.is_number()) total += part.get<double>();
    return total;
}

/// JSON that can stand in a script element.
std::string script_safe(const Json& json) {
    std::string out;
    for (const char c : text_of(json)) out += c == '<' ? std::string("\\u003c") : std::string(1, c);
    return out;
}

std::string status_of(const Card& card, const ReportOptions& options) {
    if (card.result.is_null()) return "missing";
    if (card.result.value("status", "") != "done" || card.picture.empty()) return "failed";
    if (!options.has_baseline) return "done";
    if (!card.flip) return "new";
    return *card.flip > options.max_flip ? "changed" : "same";
}

/// What the page's script knows of an item.
Json detail_of(const Job& job, const Card& card, const ReportOptions& options) {
    const fs::path output = job.output_of(card.item);
    Json detail = {
        {"item", card.item},
        {"name", recorded_path(job, output)},
        {"status", status_of(card, options)},
        {"link", link_to(output, options.file)},
        {"shown", is_shown(output)},
        {"baseline_link", card.earlier.empty() ? "" : link_to(card.earlier, options.file)},
        {"problem", card.problem},
        {"picture", card.picture},
        {"baseline", card.baseline},
        {"heat", card.heat},
        {"flip", card.flip ? Json(*card.flip) : Json(nullptr)},
        {"result", card.result}};
    if (const auto item = job.item(card.item))
        detail["command"] = tables::command_line(
            tables::command_words("render", item->scene, item->settings, item->output.string()));
    detail["total_ms"] = card.result.is_null() ? 0.0 : total_ms(card.result);
    return detail;
}

base::Result<std::string> part(const char* name) {
    const auto folder = base::data_folder();
    if (!folder) return tl::unexpected(folder.error());
    return base::read_text_file(*folder / "resources/report" / name, most_part_bytes);
}

}  // namespace

base::Status write_report(const Job& job, const std::vector<Card>& cards,
                          const ReportOptions& options) {
    const auto style = part("report.css");
    if (!style) return tl::unexpected(style.error());
    const auto script = part("report.js");
    if (!script) return tl::unexpected(script.error());
    const auto body = part("report.html");
    if (!body) return tl::unexpected(body.error());
    Json data = {{"job", job.file.filename().string()},
                 {"has_baseline", options.has_baseline},
                 {"max_flip", options.max_flip},
                 {"items", Json::array()}};
    std::vector<std::size_t> items;
    for (const Card& card : cards) {
        data["items"].push_back(detail_of(job, card, options));
        items.push_back(card.item);
    }
    data["films"] = job.films(items);
    const std::string title = base::markup_escaped(job.file.filename().string());
    const std::string page = fmt::format(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<link rel=\"icon\" href=\"data:,\">\n<title>{} - Facet</title>\n<style>\n{}</style>\n"
        "</head>\n<body>\n{}<script type=\"application/json\" id=\"data\">{}</script>\n"
        "<script>\n{}</script>\n</body>\n</html>\n",
        title, *style, *body, script_safe(data), *script);
    return base::write_file_atomically(options.file, std::as_bytes(std::span(page)));
}

}  // namespace facet::batch
