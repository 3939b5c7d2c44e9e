// One entry of a job's items: its members over the defaults, as a product of axes.
// SPDX-License-Identifier: MIT
#include "batch/group.h"

#include "base/json.h"
#include "base/text.h"
#include "base/thread_pool.h"
#include "render/job.h"
#include "scene/animate.h"
#include "scene/camera_spec.h"
#include "scene/load.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

namespace facet::batch {
namespace {

namespace fs = std::filesystem;
using base::ErrorCode;

std::string brief(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    return text_of(value);
}

constexpr std::size_t most_frames = 100'000;

/// When the animation of a group's sequence ends. Errors: those of loading its scene, and of the
/// animation.
base::Result<double> animation_end_s(const Group& group, const base::Limits& limits) {
    base::ThreadPool pool(1);
    scene::LoadOptions options = render::load_options(group.settings);
    options.decode_images = false;
    const auto loaded = scene::load(group.scene, options, limits, pool);
    if (!loaded) return tl::unexpected(loaded.error());
    const auto clip = scene::find_clip(loaded->scene, *group.sequence->animation);
    if (!clip) return tl::unexpected(clip.error());
    return *clip == nullptr ? 0.0 : static_cast<double>((*clip)->end_s);
}

/// The key of a flag, as "env_rotation" of "--env-rotation".
std::string key_of_flag(std::string flag) {
    if (!flag.starts_with("--")) return {};
    flag.erase(0, 2);
    std::ranges::replace(flag, '-', '_');
    return flag;
}

}  // namespace

struct GroupReader::Members {
    std::vector<Given> given;
    Given output;  ///< value null where there is none
    Given frames;

    /// The later one of two with one key stands, in the place of the first.
    void add(Given one) {
        for (Given& old : given)
            if (old.kind == one.kind && old.key == one.key) {
                old = std::move(one);
                return;
            }
        given.push_back(std::move(one));
    }
    [[nodiscard]] std::string pointer_of(const base::Error& error) const {
        const std::string key = key_of_flag(error.file);
        for (const Given& one : given)
            if (one.key == key || (!error.where.empty() && one.key == error.where))
                return one.pointer;
        return {};
    }
};

bool is_job_key(const tables::Setting& row) { return row.key != "allow_read" && row.key != "base"; }

std::vector<std::string> GroupReader::known_keys() const {
    std::vector<std::string> keys = {"scene", "output", "frames"};
    for (const tables::Setting& row : tables::settings)
        if (is_job_key(row)) keys.emplace_back(row.key);
    return keys;
}

void GroupReader::keep(base::Error error, const std::string& pointer) {
    if (error.code == ErrorCode::usage) error.code = ErrorCode::input_invalid;
    if (!error.where.starts_with('/')) error.where = pointer;
    error.file.clear();
    const auto is_same = [&](const base::Error& old) {
        return old.where == error.where && old.what == error.what;  // of defaults, once
    };
    if (std::ranges::none_of(in_.problems.errors, is_same))
        in_.problems.errors.push_back(std::move(error));
}

void GroupReader::collect_sets(const Json& paths, const std::string& pointer, Members& out) {
    for (const auto& [path, value] : paths.items())
        out.add({AxisKind::path, path, &value, pointer + "/" + base::pointer_key(path)});
}

void GroupReader::collect(const Json& object, const std::string& pointer, Members& out) {
    const std::vector<std::string> known = known_keys();
    for (const auto& [key, value] : object.items()) {
        const std::string place = pointer + "/" + base::pointer_key(key);
        if (std::ranges::find(known, key) == known.end()) {
            const bool is_own = key == "allow_read" || key == "base";
            keep(base::invalid(
                     is_own ? "is for the command line" : "unknown key", key,
                     is_own ? "facet batch JOB --allow-read DIR" : base::suggestion(key, known))
                     .value(),
                 place);
        } else if (key == "output") {
            out.output = {AxisKind::setting, key, &value, place};
        } else if (key == "frames") {
            out.frames = {AxisKind::frame, key, &value, place};
        } else if (key == "set" && value.is_object()) {
            collect_sets(value, place, out);
        } else {
            out.add({key == "scene" ? AxisKind::scene : AxisKind::setting, key, &value, place});
        }
    }
}

void GroupReader::put_one(const Given& given, Json value, Group& group) {
    if (auto resolved = paths_.resolve(given, value); !resolved)
        return keep(resolved.error(), given.pointer);
    const std::string label = label_of(given.kind, given.key, *given.value);
    if (auto set = apply(given.kind, given.key, value, group.settings); !set)
        return keep(set.error(), given.pointer);
    group.fixed.emplace_back(given.key, label);
}

void GroupReader::put_axis(Axis axis, Group& group) {
    for (std::size_t i = 0; i < axis.values.size(); ++i) {
        const std::string place = fmt::format("{}/{}", axis.pointer, i);
        const Given given{axis.kind, axis.key, &axis.values[i], place};
        Json value = axis.values[i];
        if (auto resolved = paths_.resolve(given, value); !resolved)
            return keep(resolved.error(), place);
        axis.values[i] = std::move(value);
    }
    group.axes.push_back(std::move(axis));
}

void GroupReader::put(const Given& given, Group& group) {
    if (given.kind == AxisKind::scene) {
        std::vector<Json> scenes{*given.value};
        if (given.value->is_array()) scenes.assign(given.value->begin(), given.value->end());
        const bool is_one = !given.value->is_array();
        if (auto s = paths_.resolve_scenes(given, scenes, in_.problems.warnings); !s)
            return keep(s.error(), given.pointer);
        if (is_one && scenes.size() == 1) {
            group.scene = scenes.front().get<std::string>();
            return;
        }
        Axis axis{.kind = AxisKind::scene, .key = "scene", .pointer = given.pointer};
        for (Json& scene : scenes) {
            axis.labels.push_back(label_of(AxisKind::scene, "scene", scene));
            axis.values.push_back(std::move(scene));
        }
        group.axes.push_back(std::move(axis));
        return;
    }
    auto values = sort_out(given);
    if (!values) return keep(values.error(), given.pointer);
    if (auto* one = std::get_if<Json>(&*values)) return put_one(given, std::move(*one), group);
    if (auto* axis = std::get_if<Axis>(&*values)) return put_axis(std::move(*axis), group);
    Draw draw = std::move(std::get<Draw>(*values));
    draw.pointer = given.pointer;
    group.draws.push_back(std::move(draw));
}

std::vector<Group> GroupReader::with_frames(const Given& given, Group group) {
    const Json& frames = *given.value;
    const auto refuse = [&](std::string what, const Json& found, std::string remedy) {
        keep(base::invalid(std::move(what), brief(found), std::move(remedy)).value(),
             given.pointer);
        return std::vector<Group>{};
    };
    constexpr const char* example = "{\"orbit\": 36}, or {\"animation\": \"Walk\", \"fps\": 24}";
    if (!frames.is_object() || frames.empty()) return refuse("takes an object", frames, example);
    const std::vector<std::string> known = {"orbit", "animation", "fps"};
    for (const auto& [key, value] : frames.items())
        if (std::ranges::find(known, key) == known.end()) {
            keep(base::invalid("unknown key", key, base::suggestion(key, known)).value(),
                 given.pointer + "/" + base::pointer_key(key));
            return {};
        }
    if (frames.contains("orbit") == frames.contains("animation"))
        return refuse("takes an orbit or an animation", frames, example);
    if (frames.contains("animation")) return with_animation(given, std::move(group));
    const Json& count = frames["orbit"];
    if (frames.contains("fps")) return refuse("fps is for an animation", frames, example);
    if (!count.is_number_unsigned() || count < 1 || count > most_frames)
        return refuse(fmt::format("orbit takes a number of frames from 1 to {}", most_frames),
                      count, "36 turns by 10 degrees a frame");
    group.sequence = Sequence{.frame_count = count.get<std::size_t>()};
    add_frame_axis(given, group);
    return {std::move(group)};
}

void GroupReader::add_frame_axis(const Given& given, Group& group) {
    Axis axis{.kind = AxisKind::frame, .key = "frame", .pointer = given.pointer};
    for (std::size_t i = 0; i < group.sequence->frame_count; ++i) {
        axis.values.emplace_back(i);
        axis.labels.push_back(fmt::format("{}", i));
    }
    group.axes.push_back(std::move(axis));
}

std::vector<Group> GroupReader::with_animation(const Given& given, Group group) {
    const Json& frames = *given.value;
    const Json& name = frames["animation"];
    const Json fps = frames.value("fps", Json(24));
    constexpr double most_fps = 1000.0;
    if (!name.is_string() && !name.is_number_unsigned())
        return keep(base::invalid("takes a name or an index", brief(name)).value(),
                    given.pointer + "/animation"),
               std::vector<Group>{};
    if (!fps.is_number() || !(fps > 0.0) || fps > most_fps)
        return keep(base::invalid(fmt::format("takes a number above 0, {} at most", most_fps),
                                  brief(fps))
                        .value(),
                    given.pointer + "/fps"),
               std::vector<Group>{};
    group.sequence = Sequence{.fps = fps.get<double>(), .animation = brief(name)};
    // How many frames there are is every scene's own: a group each.
    std::vector<Group> groups;
    const auto scenes = std::ranges::find(group.axes, AxisKind::scene, &Axis::kind);
    if (scenes == group.axes.end()) {
        if (!group.scene.empty()) groups.push_back(std::move(group));
    } else {
        const auto place = static_cast<std::size_t>(scenes - group.axes.begin());
        for (std::size_t i = 0; i < scenes->values.size(); ++i) {
            Group one = group;
            one.axes[place].values = {scenes->values[i]};
            one.axes[place].labels = {scenes->labels[i]};
            one.scene = scenes->values[i].get<std::string>();
            groups.push_back(std::move(one));
        }
    }
    for (Group& one : groups) {
        const auto end_s = animation_end_s(one, in_.options.limits);
        if (!end_s) {
            base::Error error = end_s.error();
            error.what = one.scene + ": " + error.what;
            return keep(std::move(error), given.pointer + "/animation"), std::vector<Group>{};
        }
        // The last frame comes before the end, where a film that loops is at its beginning again.
        const double count = std::ceil(*end_s * one.sequence->fps - 1e-3);
        if (count > static_cast<double>(most_frames))
            return keep(base::invalid("too many frames",
                                      fmt::format("{:.0f}, limit {}", count, most_frames))
                            .value(),
                        given.pointer),
                   std::vector<Group>{};
        one.sequence->frame_count =
            std::max<std::size_t>(1, static_cast<std::size_t>(std::max(count, 0.0)));
        add_frame_axis(given, one);
    }
    return groups;
}

void GroupReader::name_outputs(const Members& members, const std::string& pointer, Group& group) {
    const Json* const text = members.output.value != nullptr ? members.output.value : in_.output;
    const std::string place = members.output.value != nullptr ? members.output.pointer : "/output";
    if (text == nullptr)
        return keep(
            base::invalid("has no output", "", "\"output\": \"out/{scene}-{index}.png\"").value(),
            pointer);
    if (!text->is_string())
        return keep(base::invalid("is not a text", brief(*text)).value(), place);
    std::vector<std::string> known = {"scene", "folder", "index", "camera"};
    if (group.sequence) known.emplace_back("frame");
    for (const Given& given : members.given)
        if (std::ranges::find(known, given.key) == known.end()) known.push_back(given.key);
    auto parsed = NameTemplate::parse(text->get<std::string>(), known);
    if (!parsed) return keep(parsed.error(), place);
    group.output = std::move(*parsed);
}

void GroupReader::check(const Members& members, const Group& group, const std::string& pointer) {
    // Every value once, beside the first of all the others: the product is not walked.
    const auto try_with = [&](const Axis* changed, std::size_t index) {
        tables::Settings settings = group.settings;
        for (const Axis& axis : group.axes) {
            if (axis.values.empty()) return true;
            const Json& value = axis.values[&axis == changed ? index : 0];
            const std::string place =
                &axis == changed ? fmt::format("{}/{}", axis.pointer, index) : axis.pointer;
            if (auto set = apply(axis.kind, axis.key, value, settings); !set)
                return keep(set.error(), place), false;
        }
        for (const Draw& draw : group.draws)
            for (const Json& end : draw.from)
                if (auto set = apply(draw.kind, draw.key, end, settings); !set)
                    return keep(set.error(), draw.pointer), false;
        if (group.sequence && group.sequence->animation)
            settings.animation = *group.sequence->animation;
        auto checked = check_settings(settings, in_.options.limits);
        if (checked && group.sequence && !group.sequence->animation)
            if (const auto turned = scene::turned_orbit(settings.camera, 0.0); !turned)
                checked = tl::unexpected(base::in_file(turned.error(), "--camera"));
        if (checked) return true;
        if (changed != nullptr)
            return keep(checked.error(), fmt::format("{}/{}", changed->pointer, index)), false;
        const std::string place = members.pointer_of(checked.error());
        base::Error error = checked.error();
        error.where.clear();
        return keep(error, place.empty() ? pointer : place), false;
    };
    if (!try_with(nullptr, 0)) return;
    for (const Axis& axis : group.axes) {
        if (axis.kind == AxisKind::scene || axis.kind == AxisKind::frame) continue;
        for (std::size_t i = 1; i < axis.values.size(); ++i) try_with(&axis, i);
    }
}

void GroupReader::read(const Json& item, const std::string& pointer) {
    if (!item.is_object()) return keep(base::invalid("is no object", brief(item)).value(), pointer);
    const std::size_t errors_before = in_.problems.errors.size();
    Members members;
    collect(in_.defaults, "/defaults", members);
    collect(item, pointer, members);
    Group group;
    group.settings = in_.options.settings;
    for (const Given& given : members.given) put(given, group);
    std::vector<Group> groups;
    if (members.frames.value != nullptr)
        groups = with_frames(members.frames, std::move(group));
    else
        groups.push_back(std::move(group));
    const bool has_scene =
        std::ranges::any_of(members.given, [](const Given& g) { return g.key == "scene"; });
    if (!has_scene)
        keep(base::invalid("has no scene", "", "\"scene\": \"model.glb\"").value(), pointer);
    for (Group& one : groups) {
        name_outputs(members, pointer, one);
        if (in_.problems.errors.size() == errors_before) check(members, one, pointer);
        add_group(std::move(one), pointer);
    }
}

void GroupReader::add_group(Group group, const std::string& pointer) {
    group.item_count = 1;
    for (const Axis& axis : group.axes) {
        if (axis.values.empty()) group.item_count = 0;
        if (group.item_count > 0 && axis.values.size() > 1'000'000'000 / group.item_count)
            return keep(base::Error{.code = ErrorCode::limit_reached,
                                    .what = "more items than can be counted"},
                        pointer);
        group.item_count *= axis.values.size();
    }
    if (group.item_count > 0) in_.job.groups.push_back(std::move(group));
}

}  // namespace facet::batch
