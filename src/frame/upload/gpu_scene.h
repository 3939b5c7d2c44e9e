// The scene as GL objects: one vertex and index buffer, textures with mips, one uniform block a
// draw. SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "frame/shared.h"
#include "frame/upload/material_key.h"
#include "gl/objects.h"
#include "scene/scene.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace facet::frame {

/// A texture and how it is looked up; both owned by the GpuScene.
struct BoundTexture {
    const gl::Texture* texture = nullptr;
    const gl::Sampler* sampler = nullptr;
};

/// One instance to draw.
struct Draw {
    MaterialKey key;
    std::array<BoundTexture, tables::material_textures.size()> textures{};
    GLsizei index_count = 0;
    std::size_t first_index = 0;
    GLint base_vertex = 0;
    std::size_t block_offset = 0;        ///< of its DrawBlock in `draw_blocks`
    std::uint32_t instance = 0;          ///< of the scene
    std::optional<std::uint32_t> light;  ///< of the scene, whose shape it is
    math::Vec3 center_m{0.0F};           ///< of its bounds, world space: the order of drawing
    bool blended = false;
    bool layered = false;  ///< opaque, of more than the G-buffer holds
    bool double_sided = false;
};

/// Where a mesh lies in the buffers.
struct MeshRange {
    GLint base_vertex = 0;
    std::size_t first_index = 0;
    GLsizei index_count = 0;
    std::shared_ptr<const scene::Relief> relief;  ///< held, as TextureUse holds pixels
};

/// Pixels, and what they are used as: one image can be several things. Held, so that an address
/// cannot come to mean other pixels.
using TextureUse = std::pair<std::shared_ptr<const image::Image>, tables::Texels>;

struct GpuScene {
    gl::Buffer vertices;
    gl::Buffer indices;
    gl::VertexArray vertex_array;
    std::vector<MeshRange> mesh_ranges;
    std::size_t tangent_count = 0;  ///< meshes that have tangents
    gl::Buffer draw_blocks;
    std::map<TextureUse, gl::Texture> textures;
    std::map<gl::SamplerSpec, gl::Sampler> samplers;
    std::vector<Draw> draws;
    math::Bounds bounds_m;        ///< of the whole scene, lights' shapes too
    bool emits = false;           ///< some opaque material has emission
    bool has_specular = false;    ///< and some reflects as no plain dielectric does,
    bool is_translucent = false;  ///< and some lets light through
};

/// How textures are filtered.
struct Filtering {
    bool is_fast = false;     ///< the nearest mip, but of base colours
    float level_bias = 0.0F;  ///< below 0: finer mips, where a pixel is the mean of many samples
    bool operator==(const Filtering&) const = default;
};

/// Indices of the draws, near to far: what is behind is then rejected by depth before it is shaded.
[[nodiscard]] std::vector<std::size_t> near_to_far(const GpuScene& scene, const shared::View& view);

/// Uploads everything; mips are made on `pool`. Errors: limit_reached (a texture above the driver's
/// limit).
[[nodiscard]] base::Result<GpuScene> upload_scene(const gl::Context& gl, const scene::Scene& scene,
                                                  Filtering filtering, base::ThreadPool& pool);

/// Takes over what became different in materials, textures, tangents and places; meshes of as many
/// triangles and the same relief as before are taken to be the same. Errors: as upload_scene.
[[nodiscard]] base::Status update_scene(const gl::Context& gl, const scene::Scene& scene,
                                        Filtering filtering, base::ThreadPool& pool, GpuScene& out);

/// Takes over where instances are now, and `with_meshes` their vertices and triangles too; what the
/// scene emits and reflects stays. Errors: as upload_scene.
[[nodiscard]] base::Status move_scene(const gl::Context& gl, const scene::Scene& scene,
                                      Filtering filtering, base::ThreadPool& pool, bool with_meshes,
                                      GpuScene& out);

}  // namespace facet::frame
