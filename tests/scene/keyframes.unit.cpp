// Values between keyframes against glTF's formulas.
// SPDX-License-Identifier: MIT
#include "scene/keyframes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace facet::scene {
namespace {

constexpr float unit = 1e-6F;

float at(const Keyframes& keyframes, double time_s) {
    std::array<float, 1> out{};
    sample(keyframes, time_s, out);
    return out[0];
}

const Keyframes ramp{.interpolation = Interpolation::linear,
                     .times_s = {0.5F, 1.0F, 3.0F},
                     .values = {2.0F, 4.0F, -4.0F}};

TEST(Keyframes, GoStraightFromKeyToKeyAndStayAtTheEnds) {
    EXPECT_NEAR(at(ramp, 0.75), 3.0F, unit);
    EXPECT_NEAR(at(ramp, 1.5), 2.0F, unit);
    EXPECT_EQ(at(ramp, 1.0), 4.0F);
    EXPECT_EQ(at(ramp, -7.0), 2.0F);
    EXPECT_EQ(at(ramp, 0.0), 2.0F);
    EXPECT_EQ(at(ramp, 3.0), -4.0F);
    EXPECT_EQ(at(ramp, 1e9), -4.0F);
}

TEST(Keyframes, StepKeepsAValueUntilTheNextKey) {
    Keyframes steps = ramp;
    steps.interpolation = Interpolation::step;
    EXPECT_EQ(at(steps, 0.999), 2.0F);
    EXPECT_EQ(at(steps, 1.0), 4.0F);
    EXPECT_EQ(at(steps, 2.999), 4.0F);
    EXPECT_EQ(at(steps, 3.0), -4.0F);
}

TEST(Keyframes, ACubicThatLeavesTheRangeOfFloatsStaysFinite) {
    const Keyframes steep{.interpolation = Interpolation::cubic,
                          .times_s = {0.0F, 100.0F},
                          .values = {0.0F, 0.0F, 3e38F, -3e38F, 0.0F, 0.0F}};
    EXPECT_EQ(at(steep, 50.0), std::numeric_limits<float>::max());
}

TEST(Keyframes, OneKeyIsAConstant) {
    for (const Interpolation how : {Interpolation::step, Interpolation::linear}) {
        const Keyframes one{.interpolation = how, .times_s = {1.0F}, .values = {5.0F}};
        for (const double time_s : {0.0, 1.0, 2.0}) EXPECT_EQ(at(one, time_s), 5.0F);
    }
}

// A cubic between two values with given slopes is one polynomial: through x^3 - 2 x + 1 at 1 and 3,
// slopes 3 x^2 - 2, every point must lie on it. Slopes are per second, so the way of 2 s counts.
TEST(Keyframes, ACubicWithItsOwnSlopesIsThatCubic) {
    const auto f = [](double x) { return x * x * x - 2.0 * x + 1.0; };
    const auto slope = [](double x) { return static_cast<float>(3.0 * x * x - 2.0); };
    const Keyframes cubic{.interpolation = Interpolation::cubic,
                          .times_s = {1.0F, 3.0F},
                          .values = {99.0F, static_cast<float>(f(1.0)), slope(1.0), slope(3.0),
                                     static_cast<float>(f(3.0)), 99.0F}};
    for (double x = 1.0; x <= 3.0; x += 0.125)
        EXPECT_NEAR(static_cast<double>(at(cubic, x)), f(x), 1e-5) << x;
    EXPECT_EQ(at(cubic, 0.0), static_cast<float>(f(1.0)));
    EXPECT_EQ(at(cubic, 4.0), static_cast<float>(f(3.0)));
}

/// x y z w of a turn around y.
std::array<float, 4> around_y(double degrees) {
    const double half = 0.5 * degrees * std::numbers::pi / 180.0;
    return {0.0F, static_cast<float>(std::sin(half)), 0.0F, static_cast<float>(std::cos(half))};
}

Keyframes turn(std::array<float, 4> from, std::array<float, 4> to) {
    Keyframes out{.times_s = {0.0F, 1.0F}, .width = 4};
    out.values.insert(out.values.end(), from.begin(), from.end());
    out.values.insert(out.values.end(), to.begin(), to.end());
    return out;
}

double degrees_around_y(const math::Quat& q) {
    const double angle = 2.0 * std::atan2(static_cast<double>(q.y), static_cast<double>(q.w));
    return angle * 180.0 / std::numbers::pi;
}

TEST(Keyframes, RotationsTurnEvenlyOnTheShorterArc) {
    const Keyframes quarter = turn(around_y(10.0), around_y(130.0));
    for (double t = 0.0; t <= 1.0; t += 0.125)
        EXPECT_NEAR(degrees_around_y(sample_rotation(quarter, t)), 10.0 + 120.0 * t, 1e-4) << t;
    // -q is the same rotation as q.
    std::array<float, 4> opposite = around_y(130.0);
    for (float& x : opposite) x = -x;
    const Keyframes other = turn(around_y(10.0), opposite);
    EXPECT_NEAR(degrees_around_y(sample_rotation(other, 0.5)), 70.0, 1e-4);
    // 300 degrees one way are 60 the other.
    const Keyframes most = turn(around_y(0.0), around_y(300.0));
    EXPECT_NEAR(degrees_around_y(sample_rotation(most, 0.5)), -30.0, 1e-4);
}

TEST(Keyframes, RotationsAreOfLengthOneWhateverTheirKeysAre) {
    std::array<float, 4> longer = around_y(90.0);
    for (float& x : longer) x *= 3.0F;
    Keyframes keyframes = turn(around_y(0.0), longer);
    for (const Interpolation how : {Interpolation::step, Interpolation::linear}) {
        keyframes.interpolation = how;
        for (const double t : {0.0, 0.5, 1.0})
            EXPECT_NEAR(glm::length(sample_rotation(keyframes, t)), 1.0F, unit) << t;
    }
    EXPECT_NEAR(degrees_around_y(sample_rotation(turn(around_y(0.0), longer), 0.5)), 45.0, 1e-4);
    const math::Quat none = sample_rotation(turn({0, 0, 0, 0}, {0, 0, 0, 0}), 0.5);
    EXPECT_EQ(none, math::Quat(1.0F, 0.0F, 0.0F, 0.0F));
}

TEST(Keyframes, TheSameRotationTwiceStays) {
    const Keyframes still = turn(around_y(33.0), around_y(33.0));
    for (const double t : {0.0, 0.3, 1.0})
        EXPECT_NEAR(degrees_around_y(sample_rotation(still, t)), 33.0, 1e-4);
}

TEST(Keyframes, ACubicOfRotationsIsScaledToLengthOne) {
    const auto a = around_y(0.0);
    const auto b = around_y(90.0);
    Keyframes cubic{.interpolation = Interpolation::cubic, .times_s = {0.0F, 1.0F}, .width = 4};
    const std::array<float, 4> level{};
    for (const auto& row : {level, a, level, level, b, level})
        cubic.values.insert(cubic.values.end(), row.begin(), row.end());
    const math::Quat middle = sample_rotation(cubic, 0.5);
    EXPECT_NEAR(glm::length(middle), 1.0F, unit);
    EXPECT_NEAR(degrees_around_y(middle), 45.0, 1e-4);  // level tangents: the mean of both, scaled
}

}  // namespace
}  // namespace facet::scene
