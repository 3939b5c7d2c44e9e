// The light that arrives along one camera ray.
// SPDX-License-Identifier: MIT
#include "trace/path.h"

#include "math/color.h"
#include "trace/backdrop.h"
#include "trace/books.h"
#include "trace/ground.h"
#include "trace/medium.h"
#include "trace/open_light.h"

#include <algorithm>
#include <cmath>

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

template <Books books>
class Path {
public:
    using Book = typename Ledger<books>::Book;
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
        Surface first = surface;
        ray_.direction = -to_eye;
        widens_ = draws != Bsdf::Draws::far;  // what is seen through glass is a picture
        if (!widens_) keep(medium_.meet(first, sequence_));
        const Bsdf bsdf(world_.model, first, to_eye, draws);
        add_sampled_environment(bsdf, first);
        // Lights without a size are the rasteriser's, but from the far side.
        add_sampled_lights(bsdf, first, widens_ ? Lights::Among::sized : Lights::Among::all);
        if (scatter(bsdf, first, cone_m))
            while (step()) {
            }
        return out_.rays;
    }

    /// What the scene adds to the light that white ground sends on, and what it takes, in nit.
    Vec3 change_on(const Surface& ground, float cone_m) {
        const Bsdf bsdf(world_.model, ground, ground.normal, Bsdf::Draws::white);
        known_ = 1.0F;
        add_sampled_environment(bsdf, ground);
        add_sampled_lights(bsdf, ground, Lights::Among::all);
        known_ = 0.0F;
        if (scatter(bsdf, ground, cone_m)) {
            out_.radiance_nit -= met_sky() + of_light_ * world_.lights.met(ray_, drawn_);
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
            if (bounce_ == 1 && passed_ == 0) book_.add_open(met_sky(), first_);
        if (from_camera() && world_.scene.ground) {
            // The ground goes on beyond the far plane.
            Ray to_hit = ray_;
            to_hit.far_m = found ? hit.distance_m : Ray{}.far_m;
            if (const auto ground = meet_ground(world_, to_hit)) {
                add_ground(*ground);
                return false;
            }
        }
        if (!from_camera())
            add_scattered(
                of_light_ * world_.lights.met(drawn_ray(found ? &hit : nullptr), drawn_,
                                              medium_.extinction_per_m(), found ? &hit : nullptr),
                From::light);
        if (!found) {
            add_environment();
            return false;
        }
        const float way_m = hit.distance_m - ray_.near_m;
        if (medium_.scatters()) {
            if (travel(way_m)) return true;
            if (throughput_ == Vec3(0.0F)) return false;
        } else {
            keep(left_after(medium_.extinction_per_m(), way_m));
        }
        const float cone_m = cone_.width_at(hit.distance_m);
        Surface surface =
            surface_at(world_.scene, world_.frames, world_.textures, hit, ray_.direction, cone_m);
        if constexpr (books == Books::gathered) {
            // But not what thin glass lets through: shadows through it are known.
            const float least = std::sqrt(least_alpha_);
            surface.roughness = std::max(surface.roughness, least);
            surface.coat_roughness = std::max(surface.coat_roughness, least);
        }
        if (surface.opacity < 1.0F && sequence_.next() >= surface.opacity) return pass(hit);
        if (from_camera()) out_.coverage = 1.0F;
        add_emission(hit, surface);
        if (surface.unlit || bounce_ >= world_.bounce_limit) return false;
        keep(medium_.meet(surface, sequence_));
        const Bsdf bsdf(world_.model, surface, -ray_.direction);
        add_sampled_environment(bsdf, surface);
        add_sampled_lights(bsdf, surface, Lights::Among::all);
        return scatter(bsdf, surface, cone_m);
    }

    /// Through what scatters light. True where it is turned before that distance.
    bool travel(float distance_m) {
        const Medium::Event event =
            medium_.travel(ray_.direction, distance_m, throughput_, sequence_);
        keep(event.factor);
        if (event.direction == Vec3(0.0F)) return false;
        ray_ = {ray_.origin + ray_.direction * (ray_.near_m + event.distance_m), event.direction};
        // Lights are not drawn from there: what the ray meets counts whole.
        drawn_from_m_ = ray_.origin;
        drawn_ = {.pdf = 1.0F, .is_mirror = true};
        return true;
    }
    /// The ray as it was where its direction was drawn, to what it meets.
    [[nodiscard]] Ray drawn_ray(const Hit* at_end) const {
        const float gone_m = math::dot(ray_.origin - drawn_from_m_, ray_.direction);
        return {drawn_from_m_, ray_.direction, gone_m + ray_.near_m,
                at_end != nullptr ? gone_m + at_end->distance_m : Ray{}.far_m};
    }
    void keep(const Vec3& share) {
        throughput_ *= share;
        of_light_ *= share;
    }
    /// Where rays to that side of a surface begin.
    static const Vec3& side(const Surface& surface, const Vec3& direction) {
        return math::dot(surface.face_normal, direction) > 0.0F ? surface.outside_m
                                                                : surface.beyond_m;
    }

    void add(const Vec3& nit, Vec3 LightPaths::*way) {
        out_.radiance_nit += nit;
        book_.add(nit, way);
    }
    /// Light of a ray that surfaces have scattered already.
    void add_scattered(const Vec3& nit, From from) {
        out_.radiance_nit += nit;
        book_.write(nit, first_, from, bounce_ == 1);
    }
    /// Light that was drawn, and that the surface at hand sends on.
    void add_drawn(const Vec3& nit, [[maybe_unused]] const Bsdf& bsdf,
                   [[maybe_unused]] const Vec3& direction, [[maybe_unused]] From from) {
        out_.radiance_nit += nit;
        if constexpr (books != Books::none)
            book_.write(nit, from_camera() ? bsdf.diffuse_shares(direction) : first_, from,
                        from_camera());
    }
    /// Of the sky that the ray ends in.
    [[nodiscard]] Vec3 met_sky() const {
        const EnvironmentLight::Light light = world_.environment.at(ray_.direction);
        return throughput_ * light.radiance_nit * power_share(drawn_.density(), light.pdf);
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
            add(throughput_ * share * backdrop(world_, ray_.direction, sequence_).radiance_nit,
                &LightPaths::background);
        else
            out_.coverage = 1.0F - math::luminance(share);
    }

    void add_environment() {
        if (!from_camera()) return add_scattered(met_sky(), From::sky);
        if (!world_.shows_environment) return;
        out_.coverage = 1.0F;
        add(throughput_ * backdrop(world_, ray_.direction, sequence_).radiance_nit,
            &LightPaths::background);
    }

    void add_emission(const Hit& hit, const Surface& surface) {
        if (surface.unlit) add_seen(throughput_ * surface.base_color, From::surface);
        if (surface.emissive_nit == Vec3(0.0F)) return;
        // A surface that is single-sided shines to its front alone.
        const scene::Instance& instance = world_.scene.instances[hit.instance];
        if (!surface.front && !world_.scene.material_of(instance).double_sided) return;
        // What a light's own shape shows is counted where the light was met.
        if (instance.light && !from_camera()) return;
        // Lights that are drawn are taken without their coat, so others' share of them is too.
        const float share = from_camera() || drawn_.is_mirror
                                ? through_coat(world_.model, surface, -ray_.direction)
                                : world_.lights.mesh_share(hit, drawn_ray(&hit), drawn_);
        add_seen(of_light_ * surface.emissive_nit * share, From::light);
    }
    void add_seen(const Vec3& nit, From from) {
        if (from_camera())
            add(nit, &LightPaths::emission);
        else
            add_scattered(nit, from);
    }

    void add_sampled_environment(const Bsdf& bsdf, const Surface& surface) {
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
            if (from_camera()) book_.add_open(open, bsdf.diffuse_shares(sample.direction));
        const Vec3 through =
            world_.geometry.transmittance({side(surface, sample.direction), sample.direction});
        if (through == Vec3(known_)) return;
        add_drawn(open * (through - known_), bsdf, sample.direction, From::sky);
    }

    void add_sampled_lights(const Bsdf& bsdf, const Surface& surface, Lights::Among among) {
        const std::size_t count = world_.lights.count(among);
        lights_here_ = {.among = among};
        if (count == 0) return;
        if (from_camera() && count <= most_drawn_each) {
            lights_here_.total_weight = Lights::every_light;
            for (std::size_t i = 0; i < world_.lights.count(); ++i)
                if (among == Lights::Among::all || world_.lights.has_size(i))
                    add_light(bsdf, surface, {i, 1.0F, 0.0F}, sequence_.next());
            return;
        }
        const math::Vec2 chance = sequence_.next_pair();
        const Lights::Choice choice = world_.lights.choose(surface.outside_m, chance.x, among);
        lights_here_.total_weight = choice.total_weight;
        if (choice.probability > 0.0F) add_light(bsdf, surface, choice, chance.y);
    }

    /// `pick`: which place of a light made of many, [0, 1).
    void add_light(const Bsdf& bsdf, const Surface& surface, const Lights::Choice& choice,
                   float pick) {
        const LightSample sample =
            world_.lights.sample(choice, surface.outside_m, sequence_.next_pair(), pick);
        if (sample.light == Vec3(0.0F) || (sample.has_pdf && !(sample.pdf > 0.0F))) return;
        const Scattered f = bsdf.evaluate(sample.direction);
        if (f.of_light == Vec3(0.0F)) return;
        Vec3 through(1.0F);
        if (sample.casts_shadow) {
            ++out_.rays;
            constexpr float almost = 1.0F - 1e-4F;  // the light's own mesh is no shadow
            through =
                world_.geometry.transmittance({side(surface, sample.direction), sample.direction,
                                               0.0F, sample.distance_m * almost});
        }
        if (sample.distance_m < Ray{}.far_m) {
            const bool crosses = math::dot(surface.face_normal, sample.direction) < 0.0F;
            through *= left_after(
                crosses ? medium_.extinction_beyond(surface) : medium_.extinction_per_m(),
                sample.distance_m);
        }
        if (through == Vec3(known_)) return;
        Vec3 factor = (through - known_) / choice.probability;
        if (sample.has_pdf) {
            const float own = sample.pdf * choice.probability;
            factor = (through - known_) * (power_share(own, f.pdf) / own);
        }
        add_drawn(throughput_ * f.of_light * sample.light * factor, bsdf, sample.direction,
                  From::light);
    }

    /// Draws where the light may come from, and turns the ray there. False where the path ends.
    bool scatter(const Bsdf& bsdf, const Surface& surface, float cone_m) {
        const math::Vec2 u = sequence_.next_pair();
        const math::Vec2 chance = sequence_.next_pair();
        const Bsdf::Sample sample = bsdf.sample(u, chance.x);
        if (!sample.is_valid) return false;
        if constexpr (books != Books::none)
            if (from_camera())
                first_ = sample.is_mirror ? Bsdf::DiffuseShares{}
                                          : bsdf.diffuse_shares(sample.direction);
        const Vec3& origin_m = side(surface, sample.direction);
        if (sample.is_straight && !from_camera()) {
            // The direction is the one that was drawn before the glass.
            of_light_ *= sample.scattered.of_light;
        } else {
            drawn_from_m_ = origin_m;
            drawn_ = lights_here_;
            drawn_.pdf = sample.scattered.pdf;
            drawn_.is_mirror = sample.is_mirror;
            of_light_ = throughput_ * sample.scattered.of_light / sample.scattered.pdf;
        }
        throughput_ *= sample.scattered.of_environment / sample.scattered.pdf;
        if (math::dot(surface.face_normal, sample.direction) < 0.0F) medium_.cross(surface);
        ++bounce_;
        if (bounce_ >= first_roulette) {
            const float survival =
                std::min(1.0F, std::max({throughput_.x, throughput_.y, throughput_.z}));
            if (!(chance.y < survival)) return false;
            throughput_ /= survival;
            of_light_ /= survival;
        }
        ray_ = {origin_m, sample.is_straight ? ray_.direction : sample.direction};
        cone_.width_m = cone_m;
        if (!drawn_.is_mirror) {
            const float width = 1.0F / std::sqrt(drawn_.pdf);
            cone_.spread = std::max(cone_.spread, lobe_cone * width);
            if (widens_) least_alpha_ = std::max(least_alpha_, std::min(1.0F, widening * width));
        }
        return true;
    }

    const World& world_;
    Sequence& sequence_;
    Ray ray_;
    Cone cone_;
    Vec3 throughput_{
        1.0F};  ///< for what counts as environment: the sky, and light from other surfaces
    Vec3 of_light_{1.0F};      ///< for lights, which the lecture masks otherwise
    Vec3 drawn_from_m_{0.0F};  ///< where the ray's direction was drawn: before glass that is thin
    Lights::DrawnWay drawn_;   ///< and how
    Lights::DrawnWay lights_here_;  ///< what was drawn of the lights at the surface at hand
    Medium medium_;
    float known_ = 0.0F;        ///< share of what is drawn that is counted already
    float least_alpha_ = 0.0F;  ///< of the next surface
    bool widens_ = true;        ///< that width grows along the path
    std::uint32_t bounce_ = 0;
    std::uint32_t passed_ = 0;
    PathLight out_;
    Ledger<books> book_;
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
