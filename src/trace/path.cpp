// The light that arrives along one camera ray.
// SPDX-License-Identifier: MIT
#include "trace/path.h"

#include "brdf/light_terms.h"
#include "math/color.h"
#include "trace/ground.h"
#include "trace/open_light.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace facet::trace {
namespace {

using math::Vec3;

/// Paths are never ended by chance before this bounce.
constexpr std::uint32_t first_roulette = 3;
/// As many lights as this are all drawn from where the camera looks: what one of them hides from
/// another shows there.
constexpr std::size_t most_drawn_each = 8;
/// Share of a lobe's width that the ray it is drawn with stands for; textures seen through it are
/// that much coarser.
constexpr float lobe_cone = 0.15F;
/// Few paths find what a mirror throws on a wall, and those show as dots: beyond a lobe, gathered
/// paths take surfaces to be this share of its width rough (Kaplanyan and Dachsbacher 2013, "Path
/// Space Regularization for Holistic and Robust Light Transport"; by the density of the direction
/// as in Weier et al. 2021).
constexpr float widening = 0.1F;

/// What a path writes down beside its sum. Light belongs to the lobe of the first surface that
/// sends it to the viewer, by that lobe's share of the BRDF in the direction it came from.
enum class Books : std::uint8_t { none, by_path, gathered };
/// Where light comes from.
enum class From : std::uint8_t { sky, light, surface };

template <Books books>
class Path {
public:
    using Book = std::conditional_t<books == Books::gathered, Gathered, LightPaths>;
    Path(const World& world, const Ray& ray, Cone cone, Sequence& sequence, Book* book)
        : world_(world), sequence_(sequence), ray_(ray), cone_(cone), book_(book) {}

    PathLight trace() {
        while (step()) {
        }
        return out_;
    }

    /// Begins at a surface that is seen already.
    std::uint32_t gather(const Surface& surface, const Vec3& to_eye, float cone_m,
                         Bsdf::Draws draws) {
        const Bsdf bsdf(world_.model, surface, to_eye, draws);
        const Vec3& origin = surface.outside_m;
        add_sampled_environment(bsdf, origin);
        // Lights without a size are the rasteriser's.
        add_sampled_lights(bsdf, origin, Lights::Among::sized, world_.lights.sized_count());
        if (scatter(bsdf, origin, cone_m))
            while (step()) {
            }
        return out_.rays;
    }

    /// What the scene adds to the light that white ground sends on, and what it takes, in nit.
    Vec3 change_on(const Surface& ground, float cone_m) {
        const Bsdf bsdf(world_.model, ground, ground.normal, Bsdf::Draws::white);
        const Vec3& origin = ground.outside_m;
        known_ = 1.0F;
        add_sampled_environment(bsdf, origin);
        add_sampled_lights(bsdf, origin, Lights::Among::all, world_.lights.count());
        known_ = 0.0F;
        if (scatter(bsdf, origin, cone_m)) {
            const EnvironmentLight::Light sky = world_.environment.at(ray_.direction);
            out_.radiance_nit -= throughput_ * sky.radiance_nit * power_share(pdf_, sky.pdf) +
                                 of_light_ * world_.lights.met(ray_, pdf_, light_weight_);
            while (step()) {
            }
        }
        return out_.radiance_nit;
    }
    [[nodiscard]] std::uint32_t rays() const { return out_.rays; }

private:
    [[nodiscard]] bool from_camera() const { return bounce_ == 0; }

    /// Follows the ray to what it meets, and on. False where the path ends.
    bool step() {
        Hit hit;
        ++out_.rays;
        const bool found =
            world_.geometry.intersect(ray_, from_camera() ? Viewer::camera : Viewer::light, hit);
        if constexpr (books == Books::gathered)
            if (bounce_ == 1 && passed_ == 0) add_open_sky();
        if (from_camera() && world_.scene.ground) {
            // The ground goes on beyond the far plane.
            Ray to_hit = ray_;
            to_hit.far_m = found ? hit.distance_m : Ray{}.far_m;
            if (const auto ground = meet_ground(world_, to_hit)) {
                add_ground(*ground);
                return false;
            }
        }
        if (!from_camera()) {
            Ray to_hit = ray_;
            if (found) to_hit.far_m = hit.distance_m;
            // A mirror's density has no bound: what the light draws itself counts nothing beside
            // it.
            constexpr float unbounded = 1e20F;
            add_scattered(
                of_light_ * world_.lights.met(to_hit, mirrored_ ? unbounded : pdf_, light_weight_),
                From::light);
        }
        if (!found) {
            add_environment();
            return false;
        }
        const float cone_m = cone_.width_at(hit.distance_m);
        Surface surface =
            surface_at(world_.scene, world_.frames, world_.textures, hit, ray_.direction, cone_m);
        if constexpr (books == Books::gathered) {
            const float least = std::sqrt(least_alpha_);
            surface.roughness = std::max(surface.roughness, least);
            surface.coat_roughness = std::max(surface.coat_roughness, least);
        }
        if (surface.opacity < 1.0F && sequence_.next() >= surface.opacity) return pass(hit);
        if (from_camera()) out_.coverage = 1.0F;
        add_emission(hit, surface);
        if (surface.unlit || bounce_ >= world_.bounce_limit) return false;
        const Bsdf bsdf(world_.model, surface, -ray_.direction);
        const Vec3& origin = surface.outside_m;
        add_sampled_environment(bsdf, origin);
        add_sampled_lights(bsdf, origin, Lights::Among::all, world_.lights.count());
        return scatter(bsdf, origin, cone_m);
    }

    void add(const Vec3& nit, [[maybe_unused]] Vec3 LightPaths::*way) {
        out_.radiance_nit += nit;
        if constexpr (books == Books::by_path) book_->*way += nit;
    }
    /// Light that reaches the first surface `at_once`, or by way of others.
    void write(const Vec3& nit, const Bsdf::DiffuseShares& shares, From from, bool at_once) {
        const Vec3& share =
            at_once && from == From::light ? shares.of_light : shares.of_environment;
        if constexpr (books == Books::by_path) {
            if (at_once && from == From::light)
                book_->add_direct(nit, share);
            else
                book_->add_indirect(nit, share);
        } else {
            const bool is_sky = at_once && from == From::sky;
            (is_sky ? book_->diffuse_sky : book_->diffuse_rest) += nit * share;
            (is_sky ? book_->specular_sky : book_->specular_rest) += nit - nit * share;
        }
    }
    /// Light of a ray that surfaces have scattered already.
    void add_scattered(const Vec3& nit, [[maybe_unused]] From from) {
        out_.radiance_nit += nit;
        if constexpr (books != Books::none) write(nit, first_, from, bounce_ == 1);
    }
    /// Light that was drawn, and that the surface at hand sends on.
    void add_drawn(const Vec3& nit, [[maybe_unused]] const Bsdf& bsdf,
                   [[maybe_unused]] const Vec3& direction, [[maybe_unused]] From from) {
        out_.radiance_nit += nit;
        if constexpr (books != Books::none)
            write(nit, from_camera() ? bsdf.diffuse_shares(direction) : first_, from,
                  from_camera());
    }
    /// What would come of the sky if nothing were in its way.
    void add_open(const Vec3& nit, const Bsdf::DiffuseShares& shares) {
        book_->diffuse_open += nit * shares.of_environment;
        book_->specular_open += nit - nit * shares.of_environment;
    }
    void add_open_sky() {
        const EnvironmentLight::Light light = world_.environment.at(ray_.direction);
        const float share = mirrored_ ? 1.0F : power_share(pdf_, light.pdf);
        add_open(throughput_ * light.radiance_nit * share, first_);
    }

    /// Goes on behind a blended surface that let the ray through.
    bool pass(const Hit& hit) {
        if (++passed_ > most_passed) return false;
        ray_ = behind(ray_, hit);
        return true;
    }

    /// What shows behind the scene, by as much as the ground is lit.
    void add_ground(const Vec3& position_m) {
        const float distance_m = math::length(position_m - ray_.origin);
        const Cone cone{cone_.width_at(distance_m), cone_.spread};
        const Vec3 share = ground_share(world_, {position_m, open_ground(world_, position_m)}, cone,
                                        sequence_, out_.rays);
        out_.coverage = 1.0F;
        if (world_.shows_environment)
            add(throughput_ * share * behind_scene().radiance_nit, &LightPaths::background);
        else
            out_.coverage = 1.0F - math::luminance(share);
    }

    EnvironmentLight::Light behind_scene() {
        return world_.environment.at(world_.blur > 0.0F ? blurred(ray_.direction) : ray_.direction);
    }

    void add_environment() {
        if (from_camera() && !world_.shows_environment) return;
        const EnvironmentLight::Light light =
            from_camera() ? behind_scene() : world_.environment.at(ray_.direction);
        if (from_camera()) out_.coverage = 1.0F;
        const float share = from_camera() || mirrored_ ? 1.0F : power_share(pdf_, light.pdf);
        const Vec3 nit = throughput_ * light.radiance_nit * share;
        if (from_camera())
            add(nit, &LightPaths::background);
        else
            add_scattered(nit, From::sky);
    }

    /// A direction of the lobe that the prefiltered environment has along `axis`: light that a
    /// facet reflects to a viewer on the axis, weighted with its cosine (Karis 2013, "Real Shading
    /// in Unreal Engine 4", p. 4).
    Vec3 blurred(const Vec3& axis) {
        const Vec3 x = brdf::LightTerms<float>{}.across(axis);
        const Vec3 y = math::cross(axis, x);
        constexpr int most_tries = 16;  // a lobe of roughness 1 keeps one draw in two
        for (int i = 0; i < most_tries; ++i) {
            const Vec3 h = Lobes{}.sample_ggx({0.0F, 0.0F, 1.0F}, world_.blur * world_.blur,
                                              sequence_.next_pair());
            const Vec3 l(2.0F * h.z * h.x, 2.0F * h.z * h.y, 2.0F * h.z * h.z - 1.0F);
            if (sequence_.next() < l.z) return x * l.x + y * l.y + axis * l.z;
        }
        return axis;
    }

    void add_emission(const Hit& hit, const Surface& surface) {
        if (surface.unlit) add_seen(throughput_ * surface.base_color, From::surface);
        if (surface.emissive_nit == Vec3(0.0F)) return;
        // A surface that is single-sided shines to its front alone.
        const scene::Scene& scene = world_.scene;
        if (!surface.front && !scene.material_of(scene.instances[hit.instance]).double_sided)
            return;
        // Lights that are drawn are taken without their coat, so others' share of them is too.
        const float share =
            from_camera() || mirrored_
                ? through_coat(world_.model, surface, -ray_.direction)
                : power_share(pdf_, world_.lights.mesh_pdf(hit, ray_, light_weight_));
        add_seen(of_light_ * surface.emissive_nit * share, From::light);
    }
    void add_seen(const Vec3& nit, From from) {
        if (from_camera())
            add(nit, &LightPaths::emission);
        else
            add_scattered(nit, from);
    }

    void add_sampled_environment(const Bsdf& bsdf, const Vec3& origin) {
        if (world_.environment.is_black()) return;
        const EnvironmentLight::Sample sample = world_.environment.sample(sequence_.next_pair());
        if (!(sample.light.pdf > 0.0F)) return;
        const Scattered f = bsdf.evaluate(sample.direction);
        if (f.of_environment == Vec3(0.0F)) return;
        ++out_.rays;
        const float share = power_share(sample.light.pdf, f.pdf);
        const Vec3 open =
            throughput_ * f.of_environment * sample.light.radiance_nit * (share / sample.light.pdf);
        if constexpr (books == Books::gathered)
            if (from_camera()) add_open(open, bsdf.diffuse_shares(sample.direction));
        const float through = world_.geometry.transmittance({origin, sample.direction});
        if (through == known_) return;
        add_drawn(open * (through - known_), bsdf, sample.direction, From::sky);
    }

    /// `count`: of those `among` which are drawn.
    void add_sampled_lights(const Bsdf& bsdf, const Vec3& origin, Lights::Among among,
                            std::size_t count) {
        if (count == 0) return;
        if (from_camera() && count <= most_drawn_each) {
            light_weight_ = Lights::every_light;
            for (std::size_t i = 0; i < world_.lights.count(); ++i)
                if (among == Lights::Among::all || world_.lights.has_size(i))
                    add_light(bsdf, origin, {i, 1.0F, 0.0F}, sequence_.next());
            return;
        }
        const math::Vec2 chance = sequence_.next_pair();
        const Lights::Choice choice = world_.lights.choose(origin, chance.x, among);
        light_weight_ = choice.total_weight;
        if (choice.probability > 0.0F) add_light(bsdf, origin, choice, chance.y);
    }

    /// `pick`: which place of a light made of many, [0, 1).
    void add_light(const Bsdf& bsdf, const Vec3& origin, const Lights::Choice& choice, float pick) {
        const LightSample sample =
            world_.lights.sample(choice, origin, sequence_.next_pair(), pick);
        if (sample.light == Vec3(0.0F) || (sample.has_size && !(sample.pdf > 0.0F))) return;
        const Scattered f = bsdf.evaluate(sample.direction);
        if (f.of_light == Vec3(0.0F)) return;
        float through = 1.0F;
        if (sample.casts_shadow) {
            ++out_.rays;
            constexpr float almost = 1.0F - 1e-4F;  // the light's own mesh is no shadow
            through = world_.geometry.transmittance(
                {origin, sample.direction, 0.0F, sample.distance_m * almost});
        }
        if (through == known_) return;
        float factor = (through - known_) / choice.probability;
        if (sample.has_size) {
            const float own = sample.pdf * choice.probability;
            factor = (through - known_) * power_share(own, f.pdf) / own;
        }
        add_drawn(throughput_ * f.of_light * sample.light * factor, bsdf, sample.direction,
                  From::light);
    }

    /// Draws where the light may come from, and turns the ray there. False where the path ends.
    bool scatter(const Bsdf& bsdf, const Vec3& origin, float cone_m) {
        const math::Vec2 u = sequence_.next_pair();
        const math::Vec2 chance = sequence_.next_pair();
        const Bsdf::Sample sample = bsdf.sample(u, chance.x);
        if (!sample.is_valid) return false;
        if constexpr (books != Books::none)
            if (from_camera())
                first_ = sample.is_mirror ? Bsdf::DiffuseShares{}
                                          : bsdf.diffuse_shares(sample.direction);
        pdf_ = sample.scattered.pdf;
        mirrored_ = sample.is_mirror;
        of_light_ = throughput_ * sample.scattered.of_light / pdf_;
        throughput_ *= sample.scattered.of_environment / pdf_;
        ++bounce_;
        if (bounce_ >= first_roulette) {
            const float survival =
                std::min(1.0F, std::max({throughput_.x, throughput_.y, throughput_.z}));
            if (!(chance.y < survival)) return false;
            throughput_ /= survival;
            of_light_ /= survival;
        }
        ray_ = {origin, sample.direction};
        cone_.width_m = cone_m;
        if (!mirrored_) {
            const float width = 1.0F / std::sqrt(pdf_);
            cone_.spread = std::max(cone_.spread, lobe_cone * width);
            least_alpha_ = std::max(least_alpha_, std::min(1.0F, widening * width));
        }
        return true;
    }

    const World& world_;
    Sequence& sequence_;
    Ray ray_;
    Cone cone_;
    Vec3 throughput_{
        1.0F};  ///< for what counts as environment: the sky, and light from other surfaces
    Vec3 of_light_{1.0F};  ///< for lights, which the lecture masks otherwise
    float pdf_ = 0.0F;     ///< of the ray's direction, 1/sr
    float light_weight_ = 0.0F;
    float known_ = 0.0F;  ///< share of what is drawn that is counted already
    bool mirrored_ = false;
    float least_alpha_ = 0.0F;  ///< of the next surface
    std::uint32_t bounce_ = 0;
    std::uint32_t passed_ = 0;
    PathLight out_;
    Book* book_;
    Bsdf::DiffuseShares first_;  ///< at the first surface, in the direction that the path took
};

}  // namespace

PathLight trace_path(const World& world, const Ray& camera_ray, Cone cone, Sequence& sequence,
                     LightPaths* apart) {
    if (apart == nullptr)
        return Path<Books::none>(world, camera_ray, cone, sequence, nullptr).trace();
    return Path<Books::by_path>(world, camera_ray, cone, sequence, apart).trace();
}

Vec3 ground_share(const World& world, const GroundPlace& place, Cone cone, Sequence& sequence,
                  std::uint32_t& rays) {
    const Vec3 up(0.0F, 1.0F, 0.0F);
    // Above it by what keeps a model that stands on the ground from being below.
    const float lift_m = 1e-5F * world.scene.ground->radius_m;
    const Surface surface{.position_m = place.position_m,
                          .outside_m = place.position_m + up * lift_m,
                          .face_normal = up,
                          .normal = up};
    Path<Books::none> path(world, {}, cone, sequence, nullptr);
    const Vec3 change = path.change_on(surface, cone.width_m);
    rays += path.rays();
    Vec3 share(1.0F);
    for (int c = 0; c < 3; ++c)
        if (place.open_nit[c] > 0.0F) share[c] += change[c] / place.open_nit[c];
    return share;
}

std::uint32_t gather_light(const World& world, const Surface& surface, const Vec3& to_eye,
                           Cone cone, Sequence& sequence, Gathered& out, Bsdf::Draws draws) {
    return Path<Books::gathered>(world, {}, cone, sequence, &out)
        .gather(surface, to_eye, cone.width_m, draws);
}

}  // namespace facet::trace
