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
