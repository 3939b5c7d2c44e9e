// A batch: its items, one at a time.
// SPDX-License-Identifier: MIT
#include "batch/job.h"

#include "batch/job_values.h"
#include "scene/camera_spec.h"
#include "scene/load.h"
#include "tables/settings_json.h"
#include "tables/settings_text.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace facet::batch {

namespace fs = std::filesystem;

base::Status apply(AxisKind kind, const std::string& key, const Json& value,
                   tables::Settings& settings) {
    if (kind == AxisKind::setting) return tables::assign_json(settings, key, value);
    if (kind == AxisKind::path) return tables::assign_json(settings, "set", Json{{key, value}});
    return {};
}

/// Where an item lies: in which group, and at which value of each axis.
struct Job::Place {
    const Group* group = nullptr;
    std::size_t index = 0;
    std::vector<std::size_t> at;

    [[nodiscard]] const std::string& scene() const {
        for (std::size_t i = 0; i < at.size(); ++i)
            if (group->axes[i].kind == AxisKind::scene)
                return group->axes[i].values[at[i]].get_ref<const std::string&>();
        return group->scene;
    }
};

std::size_t Job::item_count() const {
    return groups.empty() ? 0 : groups.back().first_index + groups.back().item_count;
}

Job::Place Job::place_of(std::size_t index) const {
    const auto after = std::ranges::upper_bound(groups, index, {}, &Group::first_index);
    Place place{.group = &*(after - 1), .index = index, .at = {}};
    std::size_t rest = index - place.group->first_index;
    place.at.resize(place.group->axes.size());
    for (std::size_t i = place.at.size(); i-- > 0;) {
        const std::size_t count = place.group->axes[i].values.size();
        place.at[i] = rest % count;
        rest /= count;
    }
    return place;
}

std::string Job::label_of(const Place& place, std::string_view key) const {
    const Group& group = *place.group;
    if (key == "index") return fmt::format("{}", place.index);
    if (key == "scene") return scene::stem_of(place.scene());
    if (key == "folder") return fs::path(place.scene()).parent_path().filename().string();
    for (std::size_t i = 0; i < place.at.size(); ++i)
        if (group.axes[i].key == key) return group.axes[i].labels[place.at[i]];
    for (const Draw& draw : group.draws)
        if (draw.key == key) return batch::label_of(draw.kind, key, drawn(draw, place.index));
    for (const auto& [fixed, label] : group.fixed)
        if (fixed == key) return label;
    return key == "camera" ? "auto" : "";
}

fs::path Job::output_of(const Place& place) const {
    return (folder /
            place.group->output.expand([&](std::string_view key) { return label_of(place, key); }))
        .lexically_normal();
}

fs::path Job::output_of(std::size_t index) const { return output_of(place_of(index)); }

const std::string& Job::scene_of(std::size_t index) const { return place_of(index).scene(); }

base::Result<Item> Job::item(std::size_t index) const {
    const Place place = place_of(index);
    const Group& group = *place.group;
    Item item{.index = index,
              .scene = place.scene(),
              .settings = group.settings,
              .output = output_of(place)};
    for (std::size_t i = 0; i < place.at.size(); ++i) {
        const Axis& axis = group.axes[i];
        if (auto set = apply(axis.kind, axis.key, axis.values[place.at[i]], item.settings); !set)
            return tl::unexpected(set.error());
        item.varied.emplace_back(axis.key, axis.labels[place.at[i]]);
        if (axis.kind == AxisKind::frame) item.frame = place.at[i];
    }
    for (const Draw& draw : group.draws) {
        const Json value = drawn(draw, index);
        if (auto set = apply(draw.kind, draw.key, value, item.settings); !set)
            return tl::unexpected(set.error());
        item.varied.emplace_back(draw.key, batch::label_of(draw.kind, draw.key, value));
    }
    if (!group.sequence) return item;
    if (group.sequence->animation) {
        item.settings.animation = *group.sequence->animation;
        item.settings.time =
            static_cast<float>(static_cast<double>(*item.frame) / group.sequence->fps);
        return item;
    }
    const double turn_deg =
        360.0 * static_cast<double>(*item.frame) / static_cast<double>(group.sequence->frame_count);
    auto camera = scene::turned_orbit(item.settings.camera, turn_deg);
    if (!camera) return tl::unexpected(base::in_file(camera.error(), "--camera"));
    item.settings.camera = std::move(*camera);
    return item;
}

std::vector<std::string> Job::films(std::span<const std::size_t> items) const {
    std::vector<std::string> commands;
    for (const std::size_t index : items) {
        const Place place = place_of(index);
        const Group& group = *place.group;
        if (!group.sequence || place.at.back() != 0) continue;
        const bool by_frame = group.output.uses("frame");
        const auto labels = [&](std::string_view key) { return label_of(place, key); };
        const fs::path frames =
            folder / group.output.sequence(labels, by_frame ? "frame" : "index");
        fs::path film = output_of(place);
        film.replace_extension(".mp4");
        commands.push_back("ffmpeg" + tables::command_line(
                                          {"-framerate", fmt::format("{}", group.sequence->fps),
                                           "-start_number", fmt::format("{}", by_frame ? 0 : index),
                                           "-i", frames.lexically_normal().string(), "-frames:v",
                                           fmt::format("{}", group.sequence->frame_count),
                                           "-pix_fmt", "yuv420p", film.string()})
                                          .substr(std::string_view("facet").size()));
    }
    return commands;
}

std::vector<std::size_t> Job::by_scene() const {
    // Scenes by first appearance; within one the order of the job.
    std::unordered_map<std::string_view, std::size_t> ranks;
    std::vector<std::size_t> rank(item_count());
    for (std::size_t i = 0; i < rank.size(); ++i)
        rank[i] = ranks.emplace(scene_of(i), ranks.size()).first->second;
    std::vector<std::size_t> order(rank.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return rank[i]; });
    return order;
}

std::vector<std::size_t> items_of(const Job& job, const Shard& shard) {
    const std::vector<std::size_t> order = job.by_scene();
    const auto begin = [&](std::size_t index) {
        return static_cast<std::ptrdiff_t>(order.size() / shard.count * index +
                                           std::min(index, order.size() % shard.count));
    };
    return {order.begin() + begin(shard.index), order.begin() + begin(shard.index + 1)};
}

}  // namespace facet::batch
