// A frame: the one place that knows the order of the passes.
// SPDX-License-Identifier: MIT
#include "frame/frame.h"

#include "frame/environment/lobe.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace facet::frame {
namespace {

bool wants(const std::vector<tables::Aov>& aovs, tables::Aov aov) {
    return std::find(aovs.begin(), aovs.end(), aov) != aovs.end();
}

/// Waits for the GL and adds the time since the last call; does nothing where no times are wanted.
class Clock {
public:
    Clock(const gl::Context& gl, bool wanted) : gl_(gl), wanted_(wanted) {}
    void add_to(double* milliseconds) {
        if (!wanted_) return;
        gl_.finish();
        const auto now = std::chrono::steady_clock::now();
        *milliseconds += std::chrono::duration<double, std::milli>(now - last_).count();
        last_ = now;
    }

private:
    const gl::Context& gl_;
    bool wanted_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

base::Result<Frame> Frame::create(const gl::Context& gl, const gl::ShaderSources& sources,
                                  const FrameSpec& spec) {
    Frame frame(sources, spec);
    auto accumulate = AccumulatePass::create(gl, sources);
    if (!accumulate) return tl::unexpected(accumulate.error());
    frame.accumulate_pass_ = std::move(*accumulate);
    auto light_buffers = make_light_buffers(gl);
    if (!light_buffers) return tl::unexpected(light_buffers.error());
    frame.light_buffers_ = std::move(*light_buffers);
    frame.rays_ = make_ray_textures(gl);
    frame.view_block_ = gl::make_buffer(gl, {}, GL_STREAM_DRAW);
    frame.empty_ = gl::make_vertex_array(gl);
    // Faces of the prefiltered cube are filtered across their edges.
    gl.api().Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    if (auto made = frame.resize(gl, spec); !made) return tl::unexpected(made.error());
    return frame;
}

base::Status Frame::resize(const gl::Context& gl, const FrameSpec& spec) {
    spec_ = spec;
    accumulator_.reset();
    return set_aovs(gl, spec.aovs);
}

base::Status Frame::make_targets(const gl::Context& gl) {
    const GBufferSpec wanted{.size = size(),
                             .emissive = spec_.emissive || wants(spec_.aovs, tables::Aov::emissive),
                             .specular = spec_.specular,
                             .ids = wants(spec_.aovs, tables::Aov::object_id) ||
                                    wants(spec_.aovs, tables::Aov::material_id),
                             .triangles = spec_.rays};
    if (wanted == gbuffer_.spec) return {};
    aov_targets_.clear();  // they share the old one's depth
    light_paths_.reset();
    auto gbuffer = GBuffer::create(gl, wanted);
    if (!gbuffer) return tl::unexpected(gbuffer.error());
    gbuffer_ = std::move(*gbuffer);
    auto radiance = RadianceTarget::create(gl, size(), gbuffer_.depth);
    if (!radiance) return tl::unexpected(radiance.error());
    radiance_ = std::move(*radiance);
    return spec_.maps ? occlusion_pass_.make_target(gl, gbuffer_) : base::Status{};
}

base::Status Frame::set_aovs(const gl::Context& gl, std::vector<tables::Aov> aovs) {
    spec_.aovs = std::move(aovs);
    if (auto made = make_targets(gl); !made) return made;
    if (auto made = make_light_paths(gl); !made) return made;
    std::vector<AovTarget> old = std::exchange(aov_targets_, {});
    for (const tables::Aov aov : spec_.aovs) {
        const auto kept = std::find_if(old.begin(), old.end(),
                                       [&](const AovTarget& target) { return target.aov == aov; });
        if (kept != old.end()) {
            aov_targets_.push_back(std::move(*kept));
            old.erase(kept);
            continue;
        }
        auto made = AovPass::make_target(gl, aov, gbuffer_);
        if (!made) return tl::unexpected(made.error());
        aov_targets_.push_back(std::move(*made));
    }
    return gl.check("aov targets");
}

base::Status Frame::make_light_paths(const gl::Context& gl) {
    auto paths = tables::of_kind(spec_.aovs, tables::AovKind::light_path);
    if (paths.empty()) light_paths_.reset();
    if (paths.empty() || (light_paths_ && light_paths_->paths == paths)) return {};
    auto made = LightPathTarget::create(gl, std::move(paths), size(), gbuffer_.depth);
    if (!made) return tl::unexpected(made.error());
    light_paths_ = std::move(*made);
    return {};
}

void Frame::set_view(const gl::Context& gl, const FrameInputs& in,
                     const shared::View& camera_view) {
    shared::View view = camera_view;
    const std::uint32_t across = (spec_.region.size.width + tile_px - 1) / tile_px;
    view.light_counts = {in.lights.directional_count, in.lights.count, across, 0U};
    const math::Extent size = spec_.region.size;
    view.rays = {static_cast<std::uint32_t>(size.pixels()), rays_.slots, size.width, rays_.stride};
    const EnvironmentMaps& e = in.environment;
    const EnvironmentMaps& lit_by = in.probe == nullptr ? e : *in.probe;
    view.environment = {lit_by.last_level, lit_by.unit_nit, e.last_level, e.unit_nit};
    if (lit_by.box) {
        view.box_low = {lit_by.box->low_m, 1.0F};
        view.box_high = {lit_by.box->high_m, 0.0F};
        view.box_place = {lit_by.box->place_m, 0.0F};
    }
    view.key_light = in.key_light.place;
    constexpr float occlusion_share = 0.25F;  // of the scene's size: what is further is open
    view.occlusion.x = occlusion_share * in.scene.bounds_m.diagonal();
    if (in.ground != nullptr)
        view.ground = {in.ground->center_m.x, in.ground->height_m, in.ground->center_m.y,
                       in.ground->radius_m};
    view.background.x = in.background.blur * e.last_level;
    view.background.y = in.background.blur * in.background.blur;
    view.sun = {0.0F, 0.0F, 0.0F, 2.0F};
    if (e.sun) {
        const float cosine = std::cos(0.5F * e.sun->angle_rad);
        view.sun = {-e.sun->direction, cosine};
        const float disc_sr = 2.0F * math::pi * (1.0F - cosine);
        view.sun_nit = {e.sun->color * (e.sun->intensity / disc_sr), 0.0F};
        if (view.background.y > 0.0F)
            view.background.z = 0.25F * disc_sr / lobe_cosine(view.background.y);
    }
    gl::update_buffer(gl, view_block_, std::as_bytes(std::span(&view, 1)));
    gl.api().BindBufferBase(GL_UNIFORM_BUFFER, view_binding, view_block_.name());
}

ShadeKey Frame::upload_lights(const gl::Context& gl, const FrameInputs& in) {
    update_lights(gl, light_buffers_, in.lights);
    return {.environment = in.probe != nullptr || !in.environment.is_black,
            .local_lights = in.lights.count > in.lights.directional_count,
            .area_lights = in.lights.area_count > 0,
            .light_profiles = !in.lights.profiles.empty()};
}

LightLists Frame::update_light_lists(const gl::Context& gl, const FrameInputs& in,
                                     const shared::View& view, bool opaque) {
    const math::Extent size = spec_.region.size;
    // Reading depth back is a copy on a software renderer, and a stall on any other.
    std::optional<CellDepths> depths;
    if (opaque && gl.is_software()) {
        std::vector<float> depth(static_cast<std::size_t>(size.pixels()));
        gl::read_pixels(gl, gbuffer_.framebuffer, 0, size, {GL_DEPTH_COMPONENT, GL_FLOAT},
                        std::as_writable_bytes(std::span(depth)));
        depths = cell_depths(depth, size);
    }
    LightLists lists =
        build_light_lists(in.lights, view.clip_from_world, size, depths ? &*depths : nullptr);
    update_lists(gl, light_buffers_, lists);
    return lists;
}

base::Result<ReadSurfaces> Frame::read_middles(const gl::Context& gl, const FrameInputs& in) {
    const shared::View view = view_block(in.camera, spec_.picture, spec_.region, math::Vec2(0.0F));
    set_view(gl, in, view);
    if (auto s = gbuffer_pass_.run(gl, in.scene, near_to_far(in.scene, view), gbuffer_); !s)
        return tl::unexpected(s.error());
    return read_surfaces(gl, gbuffer_, view, spec_.picture, spec_.region);
}

base::Status Frame::find_indirect(const gl::Context& gl, const FrameInputs& in) {
    rays_.stride = 0;
    if (in.rays == nullptr || !spec_.rays || !in.rays->has_indirect()) return {};
    const auto surfaces = read_middles(gl, in);
    if (!surfaces) return tl::unexpected(surfaces.error());
    in.rays->look_at(*surfaces);
    return set_indirect(gl, in.rays->indirect(in.environment));
}

base::Status Frame::ask_rays(const gl::Context& gl, const FrameInputs& in, const SampleView& sample,
                             const LightLists* lists, ShadeKey& key) {
    key.visibility = in.rays->has_shadows() && in.lights.count > 0;
    key.indirect = rays_.stride > 0;
    key.sample_light = key.indirect && in.rays->has_sample_light();
    if (!key.visibility && !key.sample_light) return {};
    in.rays->look_at(read_surfaces(gl, gbuffer_, sample.view, spec_.picture, spec_.region));
    if (key.sample_light)
        if (auto s = update_sample_light(gl, in.rays->sample_light(sample.index), size(), rays_);
            !s)
            return s;
    if (key.visibility)
        update_visibility(gl, in.lights, lists, size(), sample.index, *in.rays, rays_);
    set_view(gl, in, sample.view);
    return {};
}

base::Status Frame::draw_opaque(const gl::Context& gl, const FrameInputs& in,
                                const ShadeInputs& shade, const DrawTarget& out,
                                const gl::Framebuffer* background) {
    if (auto s = lighting_pass_.run(gl, gbuffer_, shade, empty_, out); !s) return s;
    if (auto s = forward_pass_.run_layered(gl, in.scene, shade, out); !s) return s;
    if (background == nullptr) return {};
    if (in.background.kind == BackgroundKind::environment)
        if (auto s = background_pass_.run(gl, in.environment, empty_, {*background, out.size}); !s)
            return s;
    if (in.ground == nullptr || rays_.stride == 0) return {};
    return ground_pass_.run(gl, rays_.ground, empty_, {*background, out.size});
}

base::Status Frame::draw_light(const gl::Context& gl, const FrameInputs& in,
                               const SampleView& sample,
                               const std::vector<std::size_t>& far_to_near) {
    const shared::View& view = sample.view;
    ShadeInputs shade{upload_lights(gl, in),   in.probe == nullptr ? in.environment : *in.probe,
                      light_buffers_,          rays_,
                      shadow_pass_.textures(), occlusion_pass_.texture()};
    shade.key.shadow_maps = has_maps(in) && in.lights.count > 0;
    std::optional<LightLists> lists;
    if (shade.key.local_lights) lists = update_light_lists(gl, in, view, true);
    shade.key.occlusion = has_maps(in);
    if (shade.key.occlusion)
        if (auto s = occlusion_pass_.run(gl, gbuffer_, empty_); !s) return s;
    if (in.rays != nullptr && spec_.rays)
        if (auto s = ask_rays(gl, in, sample, lists ? &*lists : nullptr, shade.key); !s) return s;
    if (in.background.kind != BackgroundKind::environment) radiance_.clear(gl);
    const gl::Framebuffer& beauty = radiance_.framebuffer;
    if (auto s = draw_opaque(gl, in, shade, radiance_.target(), &beauty); !s) return s;
    if (light_paths_) {
        ShadeInputs apart = shade;
        apart.key.paths = light_paths_->paths;
        light_paths_->light.clear(gl);
        const gl::Framebuffer* background =
            light_paths_->background ? &*light_paths_->background : nullptr;
        if (auto s = draw_opaque(gl, in, apart, light_paths_->light.target(), background); !s)
            return s;
    }
    const bool any_blended = std::any_of(in.scene.draws.begin(), in.scene.draws.end(),
                                         [](const Draw& draw) { return draw.blended; });
    return any_blended ? draw_blended(gl, in, sample, shade, far_to_near) : base::Status{};
}

base::Status Frame::draw_blended(const gl::Context& gl, const FrameInputs& in,
                                 const SampleView& sample, ShadeInputs shade,
                                 const std::vector<std::size_t>& far_to_near) {
    // Rays, and the horizons of the G-buffer, know opaque surfaces alone: these are lit as if in
    // the open. They lie before the depth that the lists were culled by.
    const FrameInputs open = in.in_the_open();
    const bool shadow_maps = shade.key.shadow_maps;
    shade.key = upload_lights(gl, open);
    shade.key.shadow_maps = shadow_maps;
    set_view(gl, open, sample.view);
    if (shade.key.local_lights) (void)update_light_lists(gl, open, sample.view, false);
    if (auto s = forward_pass_.run_blended(gl, in.scene, far_to_near, shade, radiance_.target());
        !s)
        return s;
    if (!light_paths_) return {};
    shade.key.paths = light_paths_->paths;
    return forward_pass_.run_blended(gl, in.scene, far_to_near, shade,
                                     light_paths_->light.target());
}

base::Status Frame::draw(const gl::Context& gl, const FrameInputs& in, std::uint32_t index,
                         std::uint32_t count, PassTimes* times) {
    PassTimes unwanted;
    PassTimes& passes = times == nullptr ? unwanted : *times;
    Clock clock(gl, times != nullptr);
    if ((index == 0 || in.has_moved) && has_maps(in))
        if (auto s = shadow_pass_.run(
                gl, in.scene,
                plan_shadow_views(in.lights.lights, in.camera, spec_.picture, in.scene.bounds_m),
                in.lights.order);
            !s)
            return s;
    shared::View view = sample_view(in.camera, spec_.picture, spec_.region, index, count);
    view.pixel.z = static_cast<float>(index);
    set_view(gl, in, view);
    std::vector<std::size_t> order = near_to_far(in.scene, view);
    if (auto s = gbuffer_pass_.run(gl, in.scene, order, gbuffer_); !s) return s;
    clock.add_to(&passes.gbuffer);
    std::reverse(order.begin(), order.end());
    if (auto s = draw_light(gl, in, {view, index}, order); !s) return s;
    clock.add_to(&passes.lighting);
    if (auto s = add_aovs(gl, in, index); !s) return s;
    has_sum_ = count > 1 || in.camera.barrel.rim_m > 0.0F;
    if (has_sum_) {
        if (!accumulator_) {
            auto made = Accumulator::create(gl, size());
            if (!made) return tl::unexpected(made.error());
            accumulator_ = std::move(*made);
        }
        if (index == 0) accumulator_->clear(gl);
        accumulate_pass_.run(gl, radiance_.colors.front(), empty_, accumulator_->framebuffer,
                             size());
    }
    clock.add_to(&passes.post);
    return gl.check("frame");
}

base::Status Frame::add_aovs(const gl::Context& gl, const FrameInputs& in, std::uint32_t index) {
    if (index == 0) clear(gl, tables::Average::mean, aov_targets_);
    if (light_paths_)
        for (std::size_t i = 0; i < light_paths_->paths.size(); ++i)
            accumulate_pass_.run(gl, light_paths_->light.colors[i], empty_,
                                 aov_target(light_paths_->paths[i])->framebuffer, size());
    return aov_pass_.run(gl, {gbuffer_, in.environment, empty_}, tables::Average::mean,
                         aov_targets_);
}

base::Status Frame::draw_centered_aovs(const gl::Context& gl, const FrameInputs& in) {
    const bool any =
        std::any_of(aov_targets_.begin(), aov_targets_.end(), [](const AovTarget& target) {
            return tables::row(target.aov).average == tables::Average::nearest;
        });
    if (!any) return {};
    const shared::View view = view_block(in.camera, spec_.picture, spec_.region, math::Vec2(0.0F));
    set_view(gl, in, view);
    if (auto s = gbuffer_pass_.run(gl, in.scene, near_to_far(in.scene, view), gbuffer_); !s)
        return s;
    gl.texture_barrier();
    clear(gl, tables::Average::nearest, aov_targets_);
    if (auto s = aov_pass_.run(gl, {gbuffer_, in.environment, empty_}, tables::Average::nearest,
                               aov_targets_);
        !s)
        return s;
    return gl.check("aovs");
}

const gl::Framebuffer& Frame::sum_framebuffer() const {
    return has_sum_ ? accumulator_->framebuffer : radiance_.framebuffer;
}
const gl::Texture& Frame::sum_texture() const {
    return has_sum_ ? accumulator_->sum : radiance_.colors.front();
}

base::Status Frame::display(const gl::Context& gl, const DisplaySettings& settings) {
    if (auto s = display_pass_.run(gl, sum_texture(), size(), settings, empty_); !s) return s;
    return gl.check("display");
}

base::Status Frame::display_picture(const gl::Context& gl, const image::Image& radiance,
                                    const DisplaySettings& settings) {
    const gl::TextureSpec spec{.format = GL_RGBA32F, .size = radiance.size};
    auto texture = gl::make_texture(gl, spec);
    if (!texture) return tl::unexpected(texture.error());
    image::Image from_bottom = radiance;
    flip_rows(from_bottom);
    gl::upload(gl, *texture, spec, 0, 0, {GL_RGBA, GL_FLOAT}, from_bottom.bytes);
    if (auto s = display_pass_.run(gl, *texture, radiance.size, settings, empty_); !s) return s;
    return gl.check("display");
}

const AovTarget* Frame::aov_target(tables::Aov aov) const {
    for (const AovTarget& target : aov_targets_)
        if (target.aov == aov) return &target;
    return nullptr;
}

const gl::Texture* Frame::aov_texture(tables::Aov aov) const {
    const AovTarget* target = aov_target(aov);
    return target == nullptr ? nullptr : &target->sum;
}

std::optional<image::Layer> Frame::read_aov(const gl::Context& gl, tables::Aov aov,
                                            std::uint32_t count) const {
    const AovTarget* target = aov_target(aov);
    if (target == nullptr) return std::nullopt;
    const tables::AovRow& row = tables::row(aov);
    return image::layer_of(row.key, row.channels, frame::read_aov(gl, *target, size(), count));
}

std::vector<image::Layer> Frame::read_aovs(const gl::Context& gl, std::uint32_t count) const {
    std::vector<image::Layer> layers;
    for (const tables::Aov aov : spec_.aovs) layers.push_back(*read_aov(gl, aov, count));
    return layers;
}

}  // namespace facet::frame
