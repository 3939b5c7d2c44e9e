// What rays tell a frame of its surfaces: asked here, answered where a ray tracer is known.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/view.h"
#include "gl/objects.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace facet::frame {

struct EnvironmentMaps;
struct GBuffer;
struct LightLists;
struct PackedLights;

/// The G-buffer's surfaces on the CPU: [height, width], rows from the bottom, components together.
struct ReadSurfaces {
    Region region;
    math::Extent picture;
    shared::View view;
    std::vector<float> depth;                  ///< window depth; 1 where nothing is
    std::vector<std::uint32_t> triangles;      ///< 2: draw, triangle
    std::vector<std::uint16_t> albedo;         ///< 4: as GBuffer::albedo
    std::vector<std::uint16_t> normal;         ///< 2
    std::vector<std::uint8_t> metal_rough_ao;  ///< 4
    std::vector<std::uint16_t> specular;       ///< 4: as GBuffer::specular; empty without it
};
[[nodiscard]] ReadSurfaces read_surfaces(const gl::Context& gl, const GBuffer& gbuffer,
                                         const shared::View& view, math::Extent picture,
                                         const Region& region);

/// Indirect light at some of a picture's pixels, with the material left out: [height, width, 4],
/// rows from the bottom. A pixel has diffuse weight * (irradiance / pi * sky + rest) + specular
/// weight * specular.
struct IndirectLight {
    math::Extent size;
    std::uint32_t stride = 1;              ///< one place for stride x stride pixels
    std::span<const math::Vec4> sky;       ///< rgb: share that arrives; a: 0 where nothing is known
    std::span<const math::Vec4> rest;      ///< rgb: nit
    std::span<const math::Vec4> specular;  ///< rgb: nit
    math::Extent ground_size;              ///< {1, 1} where there is no ground
    std::span<const math::Vec4> ground;    ///< rgb: factor on what shows behind it
    std::span<const math::Vec4> guide;  ///< xyz: metres; w: 12 bits of each octahedral coordinate
};

/// Light of the very samples of a frame, where the pixels' middles do not tell of it: [height,
/// width], a: 1 where it is there.
struct SampleLight {
    std::span<const math::Vec4> diffuse;   ///< rgb: irradiance / pi in nit
    std::span<const math::Vec4> specular;  ///< rgb: as IndirectLight's
    std::span<const math::Vec4> far;       ///< rgb: nit, from the far side, weighted; may be empty
};

/// Which lights may reach a tile, by packed index: those that reach every tile first.
struct TileLights {
    std::uint32_t tiles_across = 0;
    std::vector<std::uint32_t> first;  ///< by tile, and one past the last
    std::vector<std::uint16_t> indices;
};

class Rays {
public:
    virtual ~Rays() = default;
    /// The surfaces that the next questions are about.
    virtual void look_at(const ReadSurfaces& surfaces) = 0;
    /// Lives until the next call. May be asked for on another thread, while nothing else is asked.
    [[nodiscard]] virtual IndirectLight indirect(const EnvironmentMaps& environment) = 0;
    [[nodiscard]] virtual bool has_indirect() const = 0;
    [[nodiscard]] virtual bool has_sample_light() const = 0;
    /// Lives until the next call. `frame`: which sample of the picture.
    [[nodiscard]] virtual SampleLight sample_light(std::uint32_t frame) = 0;
    [[nodiscard]] virtual bool has_shadows() const = 0;
    /// Share of light that arrives, 0..255: [slot, height, width, RGBA] by a light's place in its
    /// tile's list; A is unused.
    [[nodiscard]] virtual std::vector<std::uint8_t> visibility(const TileLights& lights,
                                                               std::size_t slots,
                                                               std::uint32_t frame) = 0;
};

/// What rays found, on the GL.
struct RayTextures {
    gl::Texture sky, rest, specular, guide, ground;
    gl::Texture sample_diffuse, sample_specular, sample_far;
    math::Extent sample_size;
    math::Extent far_size;
    gl::Buffer visibility;
    gl::Texture visibility_texture;
    std::uint32_t slots = 0;   ///< of visibility
    std::uint32_t stride = 0;  ///< 0: no indirect light is there
    math::Extent ground_size;
    math::Extent size;  ///< of the indirect light's textures
};
[[nodiscard]] RayTextures make_ray_textures(const gl::Context& gl);
[[nodiscard]] base::Status update_indirect(const gl::Context& gl, const IndirectLight& light,
                                           RayTextures& out);
[[nodiscard]] base::Status update_sample_light(const gl::Context& gl, const SampleLight& light,
                                               math::Extent size, RayTextures& out);
/// Asks for the lights' visibility and uploads it: as many slots as the driver has room for.
void update_visibility(const gl::Context& gl, const PackedLights& lights, const LightLists* lists,
                       math::Extent size, std::uint32_t frame, Rays& rays, RayTextures& out);

}  // namespace facet::frame
