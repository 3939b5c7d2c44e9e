// What a picture depends on, as one hash.
// SPDX-License-Identifier: MIT
#include "batch/input_hash.h"

#include "base/file.h"
#include "base/hash.h"
#include "render/job.h"
#include "scene/light_spec.h"
#include "tables/settings_text.h"

namespace facet::batch {
namespace {

/// Settings that make no other picture.
bool is_neutral(const tables::Setting& row) {
    return row.key == "threads" || row.key == "allow_read" || row.key == "max_memory" ||
           row.key == "max_vertices";
}

/// The file that a text of --set or --material may name.
std::string value_of(const std::string& assignment) {
    return assignment.substr(assignment.rfind('=') + 1);
}

}  // namespace

const std::string& InputHashes::of_scene(const Item& item) {
    const auto [known, is_new] = known_.try_emplace("scene " + item.scene);
    if (is_new) {
        const auto options = render::load_options(item.settings);
        known->second = scene::content_hash(item.scene, options, limits_).value_or("missing");
    }
    return known->second;
}

const std::string& InputHashes::of_file(const std::string& path) {
    const auto [known, is_new] = known_.try_emplace("file " + path);
    std::error_code error;
    if (is_new && std::filesystem::is_regular_file(path, error)) {
        const auto bytes = base::read_file(path, limits_.file_bytes);
        known->second = bytes ? base::sha256_hex(*bytes) : "missing";
    }
    return known->second;
}

std::string InputHashes::of(const Job& job, const Item& item) {
    base::Sha256 hash;
    hash.add_text(of_scene(item));
    hash.add_text(of_file(item.settings.env));
    hash.add_text(item.output.extension().string());
    hash.add_text(job.data_set ? "data set" : "");
    // All frames of a sequence take the exposure of the first.
    if (item.frame && *item.frame > 0)
        if (const auto first = job.item(item.index - *item.frame))
            hash.add_text(first->settings.camera);
    for (const tables::Setting& row : tables::settings) {
        if (is_neutral(row)) continue;
        const auto texts = tables::texts_of(item.settings, row);
        if (texts.empty()) continue;
        hash.add_text(row.key);
        for (const std::string& text : texts) hash.add_text(text);
    }
    for (const std::string& text : item.settings.light)
        static_cast<void>(scene::with_light_file(text, [&](const std::string& file) {
            hash.add_text(of_file(file));
            return base::Result<std::string>(file);
        }));
    for (const std::string& text : item.settings.set) hash.add_text(of_file(value_of(text)));
    for (const std::string& text : item.settings.material) hash.add_text(of_file(value_of(text)));
    return hash.hex();
}

}  // namespace facet::batch
