// The tables of a data set.
// SPDX-License-Identifier: MIT
#include "batch/data_set.h"

#include "base/file.h"
#include "batch/state.h"
#include "scene/load.h"

#include <cmath>
#include <set>

namespace facet::batch {
namespace {

namespace fs = std::filesystem;

class Tables {
public:
    explicit Tables(const Job& job) : job_(job), folder_(job.data_set->folder) {}

    void add(const Json& result) {
        if (result.is_null() || result.value("status", "") != "done" || !result.contains("camera"))
            return;
        const auto item = job_.item(result["item"].get<std::size_t>());
        if (!item) return;
        scenes.insert(item->scene);
        Json line = {{"item", item->index},
                     {"file", in_folder(item->output)},
                     {"scene", recorded_path(job_, item->scene)},
                     {"sha256", result["sha256"]},
                     {"exposure", result["exposure"]},
                     {"camera", result["camera"]}};
        if (item->frame) line["frame"] = *item->frame;
        line["settings"] = result.value("varied", Json::object());
        Json sides = Json::object();
        for (const Json& side : result.value("sides", Json::array())) {
            const fs::path path = path_of_record(job_, side.get<std::string>());
            sides[path.stem().extension().string().substr(1)] = in_folder(path);
        }
        line["aovs"] = sides;
        manifest += text_of(line) + '\n';
        add_transform(line);
    }

    Json transforms() const {
        return {{"facet", 1}, {"camera_model", "PINHOLE"}, {"frames", frames_}};
    }
    static std::string text_of(const Json& json, int indent = -1) {
        return json.dump(indent, ' ', false, Json::error_handler_t::replace);
    }

    std::string manifest;
    std::set<std::string> scenes;

private:
    /// Relative to the folder where the two have a common root.
    std::string in_folder(const fs::path& path) const {
        std::error_code error;
        const fs::path folder = fs::absolute(folder_, error).lexically_normal();
        return fs::absolute(path, error).lexically_normal().lexically_relative(folder).string();
    }
    void add_transform(const Json& line) {
        const Json& camera = line["camera"];
        if (!camera.contains("fl_x")) return;
        Json frame = {{"file_path", line["file"]},
                      {"transform_matrix", camera["world_from_camera"]}};
        const double width = camera["width"].get<double>();
        const double focal = camera["fl_x"].get<double>();
        frame["camera_angle_x"] = 2.0 * std::atan(0.5 * width / focal);
        for (const char* const key : {"fl_x", "fl_y", "cx", "cy"}) frame[key] = camera[key];
        frame["w"] = camera["width"];
        frame["h"] = camera["height"];
        if (line["aovs"].contains("depth")) frame["depth_file_path"] = line["aovs"]["depth"];
        frames_.push_back(std::move(frame));
    }

    const Job& job_;
    fs::path folder_;
    Json frames_ = Json::array();
};

Json names_of(const scene::Scene& scene) {
    Json objects = Json::object();
    for (const scene::Instance& instance : scene.instances)
        objects[std::to_string(instance.object_id)] = instance.node;
    Json materials = Json::object();
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        materials[std::to_string(i + 1)] = scene.materials[i].name;
    return {{"object_id", objects}, {"material_id", materials}};
}

base::Status write(const fs::path& path, const std::string& text) {
    return base::write_file_atomically(path, std::as_bytes(std::span(text)));
}

}  // namespace

base::Status write_data_set(const Job& job, const std::vector<Json>& results,
                            const base::Limits& limits, base::ThreadPool& pool) {
    const fs::path& folder = job.data_set->folder;
    std::error_code error;
    fs::create_directories(folder, error);
    Tables tables(job);
    for (const Json& result : results) tables.add(result);
    Json names = Json::object();
    for (const std::string& name : tables.scenes) {
        scene::LoadOptions options{.decode_images = false};
        const auto& allowed = job.groups.front().settings.allow_read;
        options.allowed_folders.assign(allowed.begin(), allowed.end());
        const auto loaded = scene::load(name, options, limits, pool);
        if (loaded) names[recorded_path(job, name)] = names_of(loaded->scene);
    }
    if (auto s = write(folder / "manifest.jsonl", tables.manifest); !s) return s;
    if (auto s = write(folder / "names.json", Tables::text_of(names, 1) + '\n'); !s) return s;
    return write(folder / "transforms.json", Tables::text_of(tables.transforms(), 1) + '\n');
}

}  // namespace facet::batch
