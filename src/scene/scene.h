// The scene: a plain value that an importer fills, the studio edits, and the frame and the tracer
// read. SPDX-License-Identifier: MIT
#pragma once

#include "image/image.h"
#include "math/vector.h"
#include "tables/lights.h"
#include "tables/material.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace facet::scene {

/// Names that begin so are of files that come with the program.
inline constexpr std::string_view builtin_prefix = "builtin:";

using math::Mat3;
using math::Mat4;
using math::Vec2;
using math::Vec3;
using math::Vec4;

/// Index into one of Scene's vectors; a type each, so that one cannot pass for another.
template <class Tag>
struct Id {
    std::uint32_t index = 0;
    bool operator==(const Id&) const = default;
};
using ImageId = Id<struct ImageTag>;
using MaterialId = Id<struct MaterialTag>;
using MeshId = Id<struct MeshTag>;

enum class Wrap : std::uint8_t { repeat, clamp, mirror };
enum class AlphaMode : std::uint8_t { opaque, mask, blend };

/// One use of an image by a material.
struct Texture {
    ImageId image;
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;
    bool nearest = false;      ///< magnified without filtering
    std::uint32_t uv_set = 0;  ///< 0 or 1
    Mat3 uv_from_uv{1.0F};     ///< KHR_texture_transform: T * R * S
    bool operator==(const Texture&) const = default;
};

struct Material {
    std::string name;
    tables::MaterialValues values;
    std::array<std::optional<Texture>, tables::material_textures.size()>
        textures;  ///< by TextureSlot
    AlphaMode alpha_mode = AlphaMode::opaque;
    bool double_sided = false;
    bool unlit = false;
    /// KHR_materials_pbrSpecularGlossiness: the alpha of specular_color_texture multiplies
    /// 1 - roughness, and no texture does roughness.
    bool has_glossiness = false;
    std::optional<std::uint32_t> source;  ///< index in the file; none: the default material

    [[nodiscard]] const std::optional<Texture>& texture(tables::TextureSlot slot) const {
        return textures[static_cast<std::size_t>(slot)];
    }
};

struct Relief;

/// Triangles of one material. Arrays besides `positions_m` are empty or of the same length.
struct Mesh {
    std::string name;
    MaterialId material;
    std::vector<Vec3> positions_m;
    std::vector<Vec3> normals;   ///< unit; the importer always fills them
    std::vector<Vec4> tangents;  ///< xyz unit, w = handedness; empty where no normal map needs them
    std::vector<Vec2> uv0;
    std::vector<Vec2> uv1;
    std::vector<Vec4> colors;              ///< linear Rec.709, straight alpha
    std::vector<std::uint32_t> indices;    ///< three a triangle, counter-clockwise is front
    math::Bounds bounds_m;                 ///< of positions_m
    bool is_mirrored = false;              ///< turned round, for matrices that mirror
    std::optional<MeshId> mirror_image{};  ///< the same mesh for the other kind, where it is made
    std::shared_ptr<const Relief> relief;  ///< that a height map gave it, else null

    /// Texture coordinates of that set, 0 or 1; empty where it has none.
    [[nodiscard]] const std::vector<Vec2>& uv(std::uint32_t set) const {
        return set == 0 ? uv0 : uv1;
    }
};

/// A mesh placed in the world. Where world_from_object mirrors (negative determinant) the importer
/// has turned the mesh's triangles and handedness round already, in a copy of its own: as placed,
/// counter-clockwise is front and bitangent = w cross(n, t), always. Skinned meshes are in world
/// space at their rest pose.
struct Instance {
    MeshId mesh;
    Mat4 world_from_object{1.0F};
    std::string node;                      ///< name of the node it came from
    std::uint32_t object_id = 0;           ///< node index + 1; 0 is the background
    std::optional<std::uint32_t> light{};  ///< whose shape it is, no part of the model
};

struct LightProfile;

struct Light {
    std::string name;
    tables::LightKind kind = tables::LightKind::directional;
    Vec3 color{1.0F};        ///< linear Rec.709 tint
    float intensity = 1.0F;  ///< lux (directional), candela (point, spot), else nit
    Vec3 position_m{0.0F};
    Vec3 direction{0.0F, 0.0F, -1.0F};  ///< unit; where the light shines to
    float range_m = 0.0F;               ///< 0: no end
    std::shared_ptr<const LightProfile>
        profile;             ///< of kind ies; `intensity` is its brightest direction's
    float angle_rad = 0.0F;  ///< width of a directional light in the sky
    float inner_cone_rad = 0.0F;
    float outer_cone_rad = math::pi / 4.0F;
    float radius_m = 0.1F;  ///< sphere, disk, tube
    float width_m = 1.0F;   ///< rect and tube, along axes().x
    float height_m = 1.0F;  ///< rect, along axes().y
    /// Gives the light of a mesh that emits, for renderers that do not draw from meshes: the
    /// reference leaves it out.
    bool stands_in = false;
    bool casts_shadow = true;
    bool is_visible = false;      ///< its shape is in the scene: place_light_shapes()
    bool of_environment = false;  ///< its sun: among light paths it counts as the environment's
    std::optional<std::uint32_t> source_node;  ///< that it hangs on in the file
};
/// The axes of a light with a size: x is level, z is where it shines to; orthonormal, right-handed.
struct LightAxes {
    Vec3 x, y, z;
};
[[nodiscard]] LightAxes axes_of(const Light& light);
/// Surface that shines, in square metres; 0 for kinds without a size.
[[nodiscard]] float area_m2(const Light& light);

enum class Projection : std::uint8_t { perspective, orthographic, panorama };

/// How a camera moves while its shutter is open, around where it stands in the middle of that time.
struct CameraMotion {
    Vec3 move_m{0.0F};       ///< right, up and back, as the camera sees it
    float turn_rad = 0.0F;   ///< around itself, to the left
    float orbit_rad = 0.0F;  ///< around `pivot_m`, counter-clockwise seen from above
    Vec3 pivot_m{0.0F};
};

/// What of a lens lets less light through at its edge: a barrel before it, and the cosines' fourth
/// power.
struct Barrel {
    float rim_m = 0.0F;    ///< radius of its rim; 0: the picture is as bright at its edge
    float shift_m = 0.0F;  ///< by which the rim moves over the aperture, for each tangent off axis
};

/// Looks along -z of its own frame, y up.
struct Camera {
    std::string name;  ///< of the camera, else of its node
    std::string node;
    Mat4 world_from_view{1.0F};  ///< rotation and translation only
    Projection projection = Projection::perspective;
    float yfov_rad = 0.8F;
    float ymag_m = 1.0F;  ///< half height of an orthographic view
    float near_m = 0.01F;
    float far_m = 0.0F;          ///< 0: infinite
    float lens_radius_m = 0.0F;  ///< 0: everything is sharp
    float focus_m = 1.0F;        ///< depth that is sharp, where the lens has a size
    std::uint32_t blades = 0;    ///< corners of its aperture; below 3: round
    Barrel barrel{};
    CameraMotion motion{};
    float distortion = 0.0F;                     ///< scene::source_of()
    float aberration = 0.0F;                     ///< likewise
    std::optional<std::uint32_t> source_node{};  ///< that it hangs on in the file
};

/// An image the materials use; null where it could not be read and a white pixel stands in.
struct SceneImage {
    std::string name;  ///< uri or name, for messages
    std::shared_ptr<const image::Image> pixels;
    bool is_added = false;  ///< not the scene's own: read from the file `name` since
    std::optional<std::uint32_t> source{};  ///< index in the file
};

/// A level plane that is seen by the shadows on it alone: what shows behind it shines through,
/// dimmed or lit as the scene dims or lights white ground. Nothing else knows of it.
struct Ground {
    float height_m = 0.0F;
    float radius_m = 0.0F;  ///< around `center_m`; beyond, nothing changes
    Vec2 center_m{0.0F};    ///< x and z
    bool operator==(const Ground&) const = default;
};

struct Rig;

struct Scene {
    std::string name;
    std::vector<SceneImage> images;
    std::vector<Material> materials;
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;
    std::vector<Light> lights;
    std::vector<Camera> cameras;
    std::optional<Ground> ground;
    std::vector<std::string> extensions_used;
    std::vector<std::string> animations;  ///< clip names
    std::vector<std::string> variants;    ///< KHR_materials_variants names
    std::shared_ptr<const Rig> rig;       ///< of a file with animations, else null
    /// Where cameras are aimed that come from no file, whatever moves; none: bounds_m().
    std::optional<math::Bounds> aimed_m;

    [[nodiscard]] const Material& material_of(const Instance& instance) const {
        return materials[meshes[instance.mesh.index].material.index];
    }
    [[nodiscard]] std::uint64_t triangle_count() const;  ///< instances counted each
    [[nodiscard]] math::Bounds bounds_m() const;         ///< of the model, world space
    [[nodiscard]] math::Bounds seen_bounds_m() const;    ///< and of lights' shapes
    [[nodiscard]] math::Bounds aimed_bounds_m() const { return aimed_m ? *aimed_m : bounds_m(); }
    [[nodiscard]] std::size_t memory_bytes() const;  ///< of vertices, indices and pixels
};

}  // namespace facet::scene
