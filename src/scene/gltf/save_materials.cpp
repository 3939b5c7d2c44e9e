// Edits of materials, written into a document.
// SPDX-License-Identifier: MIT
#include "scene/gltf/save_materials.h"

#include "base/text.h"
#include "image/read.h"
#include "image/write.h"
#include "scene/gltf/specular_glossiness.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace facet::scene::gltf {
namespace {

/// One save. References outlive it.
struct Saver {
    Document& document;
    const Scene& original;
    const Scene& edited;
    const PicturePlace& place;
    const base::Limits& limits;
    base::Warnings& warnings;
    std::map<std::uint32_t, std::size_t> pictures{};  ///< by ImageId: index in the file
};

void warn(Saver& saver, std::size_t material, std::string_view pointer, std::string what) {
    saver.warnings.push_back({.where = pointer_text("materials", material) + std::string(pointer),
                              .what = std::move(what)});
}

/// The object or array element that holds the last part of `pointer`, made on the way; null where
/// it would have to lie in a textureInfo that is not there.
OrderedJson* parent_of(OrderedJson& material, const std::vector<std::string_view>& parts) {
    OrderedJson* at = &material;
    for (std::size_t i = 1; i + 1 < parts.size(); ++i) {
        const std::string key(parts[i]);
        if (key.ends_with("Texture") && !at->contains(key)) return nullptr;
        OrderedJson& next = (*at)[key];
        const bool in_array = i + 2 == parts.size() && base::parse_integer(parts[i + 1]);
        if (in_array && !next.is_array()) next = OrderedJson::array({1.0, 1.0, 1.0, 1.0});
        if (!in_array && !next.is_object()) next = OrderedJson::object();
        at = &next;
    }
    return at;
}

/// A colour keeps what its array holds beyond three numbers: baseColorFactor has the opacity there.
void put_color(OrderedJson& parent, const std::string& key, const math::Vec3& color) {
    OrderedJson& array = parent[key];
    const bool has_alpha = key == "baseColorFactor" || key == "diffuseFactor";
    if (!array.is_array() || array.size() < 3)
        array = has_alpha ? OrderedJson::array({1.0, 1.0, 1.0, 1.0})
                          : OrderedJson::array({0.0, 0.0, 0.0});
    for (int c = 0; c < 3; ++c) array[static_cast<std::size_t>(c)] = shortest(color[c]);
}

constexpr std::array workflow_extensions = {"KHR_materials_pbrSpecularGlossiness",
                                            "KHR_materials_ior", "KHR_materials_specular"};

/// What specular-glossiness has in places of its own.
bool is_of_workflow(std::string_view pointer) {
    return pointer.starts_with("/pbrMetallicRoughness/") ||
           pointer.starts_with("/extensions/KHR_materials_ior/") ||
           pointer.starts_with("/extensions/KHR_materials_specular/");
}

/// Where a row of the tables stands in the file; empty, with a warning, where it cannot.
template <class Row>
std::string_view pointer_of(Saver& saver, std::size_t index, const Material& material,
                            const Row& row) {
    if (!material.has_glossiness) return row.gltf;
    if (!is_of_workflow(row.gltf)) return row.gltf;
    const std::string_view pointer = glossiness_pointer(row.key);
    if (pointer.empty())
        warn(saver, index, "",
             fmt::format("{} is not saved: specular-glossiness has no place for it", row.key));
    return pointer;
}

void save_param(Saver& saver, OrderedJson& json, std::size_t index,
                const tables::MaterialParam& param, const Material& material) {
    const std::string_view pointer = pointer_of(saver, index, material, param);
    if (pointer.empty()) return;
    const tables::MaterialValues& values = material.values;
    const auto parts = base::split(pointer, '/');
    OrderedJson* const parent = parent_of(json, parts);
    if (parent == nullptr)
        return warn(saver, index, pointer,
                    fmt::format("{} is not saved: it has no texture", param.key));
    const std::string last(parts.back());
    if (const auto* number = std::get_if<float tables::MaterialValues::*>(&param.field)) {
        const auto element = base::parse_integer(last);
        OrderedJson& to = element ? (*parent)[static_cast<std::size_t>(*element)] : (*parent)[last];
        const bool is_turned = last == "glossinessFactor";
        to = shortest(is_turned ? 1.0F - values.**number : values.**number);
    } else {
        put_color(*parent, last,
                  values.*std::get<tables::Color tables::MaterialValues::*>(param.field));
    }
    if (parts[1] == "extensions") use_extension(saver.document.json, parts[2]);
}

bool same(const tables::MaterialParam& param, const tables::MaterialValues& a,
          const tables::MaterialValues& b) {
    return std::visit([&](auto field) { return a.*field == b.*field; }, param.field);
}

/// The bytes of a picture as glTF may hold it: the file's own where that is PNG or JPEG.
base::Result<base::Bytes> encoded(const Saver& saver, const SceneImage& image) {
    if (auto file = base::read_file(image.name, saver.limits.file_bytes)) {
        const auto first = static_cast<unsigned char>(file->empty() ? std::byte{0} : file->front());
        const auto header = image::read_header(*file, saver.limits);
        if (header && (first == 0x89 || first == 0xFF)) return std::move(*file);
    }
    const bool deep = image.pixels->sample == image::Sample::u16;
    return image::encode(*image.pixels,
                         {.depth = deep ? image::Depth::u16 : image::Depth::u8, .metadata = {}});
}

/// The file's index of an image that `edited` has and the file has not yet.
base::Result<std::size_t> save_picture(Saver& saver, ImageId id) {
    if (const auto found = saver.pictures.find(id.index); found != saver.pictures.end())
        return found->second;
    const SceneImage& image = saver.edited.images[id.index];
    if (image.source) return *image.source;
    auto bytes = encoded(saver, image);
    if (!bytes) return tl::unexpected(bytes.error());
    const bool is_png = !bytes->empty() && bytes->front() == std::byte{0x89};
    OrderedJson entry = OrderedJson::object();
    entry["name"] = std::filesystem::path(image.name).stem().string();
    if (saver.place.into_bin) {
        entry["bufferView"] = append_view(saver.document, *bytes);
        entry["mimeType"] = is_png ? "image/png" : "image/jpeg";
    } else {
        const std::string name = fmt::format("{}-{}.{}", saver.place.stem,
                                             saver.pictures.size() + 1, is_png ? "png" : "jpg");
        entry["uri"] = name;
        saver.document.new_files.push_back({name, std::move(*bytes)});
    }
    OrderedJson& images = array_at(saver.document.json, "images");
    images.push_back(std::move(entry));
    saver.pictures[id.index] = images.size() - 1;
    return images.size() - 1;
}

/// The textureInfo at `pointer`; its parent is made.
OrderedJson& texture_info(OrderedJson& material, std::string_view pointer) {
    const auto parts = base::split(pointer, '/');
    OrderedJson* at = &material;
    for (std::size_t i = 1; i < parts.size(); ++i) {
        OrderedJson& next = (*at)[std::string(parts[i])];
        if (!next.is_object()) next = OrderedJson::object();
        at = &next;
    }
    return *at;
}

void drop_texture(OrderedJson& material, std::string_view pointer) {
    const auto parts = base::split(pointer, '/');
    OrderedJson* at = &material;
    for (std::size_t i = 1; i + 1 < parts.size(); ++i) {
        if (!at->contains(std::string(parts[i]))) return;
        at = &(*at)[std::string(parts[i])];
    }
    at->erase(std::string(parts.back()));
}

bool same(const std::optional<Texture>& a, const std::optional<Texture>& b) {
    return a.has_value() == b.has_value() && (!a || a->image == b->image);
}

base::Status save_texture(Saver& saver, OrderedJson& json, std::size_t index, std::size_t slot,
                          const Material& material) {
    const std::string_view pointer =
        pointer_of(saver, index, material, tables::material_textures[slot]);
    if (pointer.empty()) return {};
    const std::optional<Texture>& after = material.textures[slot];
    if (!after) {
        drop_texture(json, pointer);
        return {};
    }
    const auto picture = save_picture(saver, after->image);
    if (!picture) return tl::unexpected(picture.error());
    OrderedJson& info = texture_info(json, pointer);
    OrderedJson& textures = array_at(saver.document.json, "textures");
    OrderedJson texture = OrderedJson::object();
    const std::size_t old = info.value("index", textures.size());
    if (old < textures.size() && textures[old].contains("sampler"))
        texture["sampler"] = textures[old]["sampler"];
    texture["source"] = *picture;
    textures.push_back(std::move(texture));
    info["index"] = textures.size() - 1;
    const auto parts = base::split(pointer, '/');
    if (parts[1] == "extensions") use_extension(saver.document.json, parts[2]);
    return {};
}

/// KHR_texture_transform of T R S.
OrderedJson transform_of(const Mat3& m) {
    const float scale_u = std::hypot(m[0].x, m[0].y);
    const float angle = std::atan2(-m[0].y, m[0].x);
    const float scale_v = m[1].x * std::sin(angle) + m[1].y * std::cos(angle);
    return {{"offset", {shortest(m[2].x), shortest(m[2].y)}},
            {"rotation", shortest(angle)},
            {"scale", {shortest(scale_u), shortest(scale_v)}}};
}

/// A whole textureInfo, with a sampler of its own where the default would not do.
base::Status write_texture(Saver& saver, OrderedJson& material, std::string_view pointer,
                           const Texture& texture) {
    const auto picture = save_picture(saver, texture.image);
    if (!picture) return tl::unexpected(picture.error());
    OrderedJson& json = saver.document.json;
    OrderedJson entry = {{"source", *picture}};
    constexpr std::array wraps = {10497, 33071, 33648};  // repeat, clamp, mirror
    if (texture.wrap_u != Wrap::repeat || texture.wrap_v != Wrap::repeat || texture.nearest) {
        OrderedJson& samplers = array_at(json, "samplers");
        samplers.push_back({{"magFilter", texture.nearest ? 9728 : 9729},
                            {"wrapS", wraps[static_cast<std::size_t>(texture.wrap_u)]},
                            {"wrapT", wraps[static_cast<std::size_t>(texture.wrap_v)]}});
        entry["sampler"] = samplers.size() - 1;
    }
    OrderedJson& textures = array_at(json, "textures");
    textures.push_back(std::move(entry));
    OrderedJson info = {{"index", textures.size() - 1}};
    if (texture.uv_set != 0) info["texCoord"] = texture.uv_set;
    if (texture.uv_from_uv != Mat3(1.0F)) {
        info["extensions"]["KHR_texture_transform"] = transform_of(texture.uv_from_uv);
        use_extension(json, "KHR_texture_transform");
    }
    texture_info(material, pointer) = std::move(info);
    return {};
}

/// Everything of a workflow anew, and nothing of the other.
base::Status save_workflow(Saver& saver, OrderedJson& json, std::size_t index,
                           const Material& material) {
    json.erase("pbrMetallicRoughness");
    if (json.contains("extensions"))
        for (const char* extension : workflow_extensions) json["extensions"].erase(extension);
    const auto pointer = [&](const auto& row) {
        if (!is_of_workflow(row.gltf)) return std::string_view();
        return material.has_glossiness ? glossiness_pointer(row.key) : row.gltf;
    };
    for (const tables::MaterialParam& param : tables::material_params)
        if (!pointer(param).empty() &&
            (material.has_glossiness || !same(param, {}, material.values)))
            save_param(saver, json, index, param, material);
    for (std::size_t slot = 0; slot < material.textures.size(); ++slot) {
        const std::string_view at = pointer(tables::material_textures[slot]);
        if (at.empty() || !material.textures[slot]) continue;
        if (auto s = write_texture(saver, json, at, *material.textures[slot]); !s) return s;
        const auto parts = base::split(at, '/');
        if (parts[1] == "extensions") use_extension(saver.document.json, parts[2]);
    }
    return {};
}

base::Status save_material(Saver& saver, std::size_t index, const Material& before,
                           const Material& after) {
    OrderedJson& json = saver.document.json["materials"][index];
    const bool is_converted = before.has_glossiness != after.has_glossiness;
    if (is_converted)
        if (auto s = save_workflow(saver, json, index, after); !s) return s;
    for (std::size_t slot = 0; slot < after.textures.size(); ++slot) {
        if (is_converted && is_of_workflow(tables::material_textures[slot].gltf)) continue;
        if (same(before.textures[slot], after.textures[slot])) continue;
        if (auto s = save_texture(saver, json, index, slot, after); !s) return s;
    }
    for (const tables::MaterialParam& param : tables::material_params)
        if (!(is_converted && is_of_workflow(param.gltf)) &&
            !same(param, before.values, after.values))
            save_param(saver, json, index, param, after);
    constexpr std::array modes = {"OPAQUE", "MASK", "BLEND"};
    if (before.alpha_mode != after.alpha_mode)
        json["alphaMode"] = modes[static_cast<std::size_t>(after.alpha_mode)];
    if (before.double_sided != after.double_sided) json["doubleSided"] = after.double_sided;
    return {};
}

bool differs(const Material& a, const Material& b) {
    for (const tables::MaterialParam& param : tables::material_params)
        if (!same(param, a.values, b.values)) return true;
    for (std::size_t slot = 0; slot < a.textures.size(); ++slot)
        if (!same(a.textures[slot], b.textures[slot])) return true;
    return a.alpha_mode != b.alpha_mode || a.double_sided != b.double_sided ||
           a.has_glossiness != b.has_glossiness;
}

/// Takes an extension that no material has any more off the lists.
void prune_extension(OrderedJson& json, std::string_view extension) {
    for (const OrderedJson& material : json.value("materials", OrderedJson::array()))
        if (material.contains("extensions") && material["extensions"].contains(extension)) return;
    for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
        if (!json.contains(list)) continue;
        OrderedJson& names = json[list];
        names.erase(std::remove(names.begin(), names.end(), extension), names.end());
        if (names.empty()) json.erase(list);
    }
}

/// Primitives without a material get the edited default one.
void save_default(Saver& saver, const Material& material) {
    OrderedJson& materials = array_at(saver.document.json, "materials");
    const std::size_t index = materials.size();
    materials.push_back({{"name", material.name}});
    for (const tables::MaterialParam& param : tables::material_params)
        if (!same(param, {}, material.values))
            save_param(saver, materials[index], index, param, material);
    for (OrderedJson& mesh : saver.document.json["meshes"])
        for (OrderedJson& primitive : mesh["primitives"])
            if (!primitive.contains("material")) primitive["material"] = index;
}

}  // namespace

base::Status save_materials(Document& document, const Scene& original, const Scene& edited,
                            const PicturePlace& place, const base::Limits& limits,
                            base::Warnings& warnings) {
    Saver saver{document, original, edited, place, limits, warnings};
    std::map<std::uint32_t, bool> saved;
    bool is_default_saved = false;
    for (std::size_t i = 0; i < edited.materials.size() && i < original.materials.size(); ++i) {
        const Material& before = original.materials[i];
        const Material& after = edited.materials[i];
        if (!differs(before, after)) continue;
        // Copies of one material, made for meshes that lack coordinates or normals, are one in the
        // file.
        if (!after.source) {
            if (!std::exchange(is_default_saved, true)) save_default(saver, after);
            continue;
        }
        if (saved[*after.source]) continue;
        saved[*after.source] = true;
        if (auto s = save_material(saver, *after.source, before, after); !s) return s;
    }
    for (const char* extension : workflow_extensions) prune_extension(document.json, extension);
    return {};
}

}  // namespace facet::scene::gltf
