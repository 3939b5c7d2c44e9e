// What the studio edits, and how an edit is said on the command line.
// SPDX-License-Identifier: MIT
#include "studio/document.h"

#include "base/text.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace facet::studio {
namespace {

/// The path of a `PATH=VALUE`.
std::string_view path_of(std::string_view assignment) {
    return base::trimmed(assignment.substr(0, assignment.rfind('=')));
}

bool is_meant(std::string_view assignment, std::string_view path) {
    const std::string_view own = path_of(assignment);
    return path.ends_with('.') ? own.starts_with(path) : own == path;
}

std::string flag_of(std::string_view key) {
    std::string flag = "--" + std::string(key);
    std::replace(flag.begin(), flag.end(), '_', '-');
    return flag;
}

/// A word as a shell takes it: in single quotes where it holds anything else than these.
std::string quoted(const std::string& word) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./:,=+@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string out = "'";
    for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

struct Texts {
    std::vector<std::string> operator()(const math::Extent& size) const {
        return {fmt::format("{}x{}", size.width, size.height)};
    }
    std::vector<std::string> operator()(const std::string& text) const { return {text}; }
    std::vector<std::string> operator()(float number) const { return {number_text(number)}; }
    std::vector<std::string> operator()(const std::optional<float>& number) const {
        if (!number) return {};
        return {number_text(*number)};
    }
    std::vector<std::string> operator()(std::uint32_t count) const {
        return {fmt::format("{}", count)};
    }
    std::vector<std::string> operator()(bool on) const {
        return on ? std::vector<std::string>{""} : std::vector<std::string>{};
    }
    std::vector<std::string> operator()(const std::vector<std::string>& list) const { return list; }
};

/// Sets one field from its texts. False where they are no value of it.
struct Assign {
    tables::Settings& settings;
    const std::vector<std::string>& texts;

    [[nodiscard]] std::optional<double> number() const {
        return texts.size() == 1 ? base::parse_number(texts.front()) : std::nullopt;
    }
    bool operator()(math::Extent tables::Settings::*field) const {
        const auto sides =
            texts.size() == 1 ? base::split(texts.front(), 'x') : std::vector<std::string_view>{};
        if (sides.size() != 2) return false;
        const auto width = base::parse_integer(sides[0]);
        const auto height = base::parse_integer(sides[1]);
        if (!width || !height || *width < 1 || *height < 1 || *width > 1'000'000 ||
            *height > 1'000'000)
            return false;
        settings.*field = {static_cast<std::uint32_t>(*width), static_cast<std::uint32_t>(*height)};
        return true;
    }
    bool operator()(std::string tables::Settings::*field) const {
        if (texts.size() != 1) return false;
        settings.*field = texts.front();
        return true;
    }
    bool operator()(float tables::Settings::*field) const {
        if (!number()) return false;
        settings.*field = static_cast<float>(*number());
        return true;
    }
    bool operator()(std::optional<float> tables::Settings::*field) const {
        if (!number()) return false;
        settings.*field = static_cast<float>(*number());
        return true;
    }
    bool operator()(std::uint32_t tables::Settings::*field) const {
        if (!number() || *number() < 0.0 || *number() > 4294967295.0) return false;
        settings.*field = static_cast<std::uint32_t>(*number());
        return true;
    }
    bool operator()(bool tables::Settings::*field) const {
        settings.*field = true;
        return true;
    }
    bool operator()(std::vector<std::string> tables::Settings::*field) const {
        settings.*field = texts;
        return true;
    }
};

}  // namespace

std::string number_text(float value) { return fmt::format("{}", value); }

std::string vector_text(const math::Vec3& value) {
    return fmt::format("{} {} {}", value.x, value.y, value.z);
}

std::string material_path(std::size_t index, std::string_view key) {
    return fmt::format("material[{}].{}", index, key);
}
std::string light_path(std::size_t index, std::string_view key) {
    return fmt::format("light[{}].{}", index, key);
}

void set_path(tables::Settings& settings, const std::string& path, const std::string& value) {
    clear_path(settings, path);
    settings.set.push_back(path + "=" + value);
}

void clear_path(tables::Settings& settings, std::string_view path) {
    std::erase_if(settings.set, [&](const std::string& text) { return is_meant(text, path); });
}

bool has_path(const tables::Settings& settings, std::string_view path) {
    return std::any_of(settings.set.begin(), settings.set.end(),
                       [&](const std::string& text) { return is_meant(text, path); });
}

std::string path_value(const tables::Settings& settings, std::string_view path) {
    for (const std::string& text : settings.set)
        if (is_meant(text, path)) return text.substr(text.rfind('=') + 1);
    return {};
}

std::vector<std::string> setting_texts(const tables::Settings& settings,
                                       const tables::Setting& row) {
    static const tables::Settings initial;
    return std::visit(
        [&](auto field) -> std::vector<std::string> {
            if (settings.*field == initial.*field) return {};
            return Texts{}(settings.*field);
        },
        row.field);
}

base::Status assign_setting(tables::Settings& settings, std::string_view key,
                            const std::vector<std::string>& texts) {
    std::vector<std::string> keys;
    for (const tables::Setting& row : tables::settings) {
        keys.emplace_back(row.key);
        if (row.key != key) continue;
        if (std::visit(Assign{settings, texts}, row.field)) return {};
        return base::fail({.code = base::ErrorCode::usage,
                           .where = std::string(key),
                           .what = "not a value of this setting",
                           .found = base::join(texts, " "),
                           .remedy = std::string(row.value)});
    }
    return base::fail({.code = base::ErrorCode::usage,
                       .where = std::string(key),
                       .what = "no such setting",
                       .found = std::string(key),
                       .remedy = base::suggestion(key, keys)});
}

std::vector<std::string> render_arguments(const Document& document, const std::string& output) {
    std::vector<std::string> words = {"render", document.scene, "-o", output};
    for (const tables::Setting& row : tables::settings) {
        std::vector<std::string> texts = setting_texts(document.settings, row);
        if (texts.empty()) continue;
        const bool is_list = std::holds_alternative<tables::List tables::Settings::*>(row.field);
        if (is_list && !row.repeatable) texts = {base::join(texts, ",")};
        for (const std::string& text : texts) {
            words.push_back(flag_of(row.key));
            if (!std::holds_alternative<tables::Flag tables::Settings::*>(row.field))
                words.push_back(text);
        }
    }
    return words;
}

std::string render_command(const Document& document, const std::string& output) {
    std::string out = "facet";
    for (const std::string& word : render_arguments(document, output)) out += " " + quoted(word);
    return out;
}

void History::record(const std::string& name, const tables::Settings& before) {
    undone_.clear();
    if (!name.empty() && name == open_) return;
    done_.push_back({name, before});
    open_ = name;
}

void History::move(std::vector<Step>& from, std::vector<Step>& to, tables::Settings& settings) {
    if (from.empty()) return;
    Step step = std::move(from.back());
    from.pop_back();
    to.push_back({step.name, settings});
    const std::string camera = settings.camera;
    settings = std::move(step.settings);
    settings.camera = camera;
}

void History::undo(tables::Settings& settings) {
    seal();
    move(done_, undone_, settings);
}
void History::redo(tables::Settings& settings) {
    seal();
    move(undone_, done_, settings);
}
void History::keep(std::size_t count) {
    seal();
    if (done_.size() > count) done_.resize(count);
}
void History::clear() {
    done_.clear();
    undone_.clear();
    seal();
}

}  // namespace facet::studio
