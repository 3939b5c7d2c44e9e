// The choice of BRDF terms: what brdf_terms.def and brdf_slots.def say, as types and as
// descriptions. SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string_view>

/// In a row of brdf_terms.def, `FACET_SELECT(FACET_WANT_##slot text)` is `text` where
/// FACET_WANT_SLOT is defined as `~,`, and nothing for every other slot: the undefined name
/// swallows the text, up to a comma outside parentheses. So one table serves a switch per slot.
#define FACET_REST(first, ...) __VA_ARGS__
#define FACET_SELECT(...) FACET_REST(__VA_ARGS__)

namespace facet::tables {

#define TERM(slot, name, ...) FACET_SELECT(FACET_WANT_##slot name, )
#define FACET_WANT_distribution ~,
enum class Distribution {
#include "tables/brdf_terms.def"
};
#undef FACET_WANT_distribution
#define TERM(slot, name, ...) FACET_SELECT(FACET_WANT_##slot name, )
#define FACET_WANT_masking ~,
enum class Masking {
#include "tables/brdf_terms.def"
};
#undef FACET_WANT_masking
#define TERM(slot, name, ...) FACET_SELECT(FACET_WANT_##slot name, )
#define FACET_WANT_fresnel ~,
enum class Fresnel {
#include "tables/brdf_terms.def"
};
#undef FACET_WANT_fresnel
#define TERM(slot, name, ...) FACET_SELECT(FACET_WANT_##slot name, )
#define FACET_WANT_diffuse ~,
enum class Diffuse {
#include "tables/brdf_terms.def"
};
#undef FACET_WANT_diffuse
#define TERM(slot, name, ...) FACET_SELECT(FACET_WANT_##slot name, )
#define FACET_WANT_multiscatter ~,
enum class Multiscatter {
#include "tables/brdf_terms.def"
};
#undef FACET_WANT_multiscatter
#define TERM(slot, name, ...) FACET_SELECT(FACET_WANT_##slot name, )
#define FACET_WANT_width ~,
enum class Width {
#include "tables/brdf_terms.def"
};
#undef FACET_WANT_width

/// One value of every slot. The default is the program's default model.
struct BrdfChoice {
    Distribution distribution{};
    Masking masking{};              ///< for lights
    Masking environment_masking{};  ///< for environment light; differs from `masking` in the
                                    ///< lecture's set only
    Fresnel fresnel{};
    Diffuse diffuse{};
    Multiscatter multiscatter{};
    Width width{};
    bool operator==(const BrdfChoice&) const = default;
};

/// A slot that the user sets, and where its value lies: `index` reads it, `set` writes it.
struct BrdfSlot {
    std::string_view key;
    std::size_t (*index)(const BrdfChoice&);
    void (*set)(BrdfChoice&, std::size_t);
};
inline constexpr auto brdf_slots = std::to_array<BrdfSlot>({
    {"distribution", [](const BrdfChoice& c) { return static_cast<std::size_t>(c.distribution); },
     [](BrdfChoice& c, std::size_t i) { c.distribution = static_cast<Distribution>(i); }},
    {"masking", [](const BrdfChoice& c) { return static_cast<std::size_t>(c.masking); },
     [](BrdfChoice& c, std::size_t i) {
         c.masking = static_cast<Masking>(i);
         c.environment_masking = c.masking;
     }},
    {"fresnel", [](const BrdfChoice& c) { return static_cast<std::size_t>(c.fresnel); },
     [](BrdfChoice& c, std::size_t i) { c.fresnel = static_cast<Fresnel>(i); }},
    {"diffuse", [](const BrdfChoice& c) { return static_cast<std::size_t>(c.diffuse); },
     [](BrdfChoice& c, std::size_t i) { c.diffuse = static_cast<Diffuse>(i); }},
    {"multiscatter", [](const BrdfChoice& c) { return static_cast<std::size_t>(c.multiscatter); },
     [](BrdfChoice& c, std::size_t i) { c.multiscatter = static_cast<Multiscatter>(i); }},
    {"width", [](const BrdfChoice& c) { return static_cast<std::size_t>(c.width); },
     [](BrdfChoice& c, std::size_t i) { c.width = static_cast<Width>(i); }},
});

/// What a row of brdf_terms.def says beside its names.
struct BrdfTermNotes {
    bool lesson = false;  ///< for `facet brdf` and lessons, not for pictures
    std::string_view help = {};
    std::string_view follows = {};  ///< the slot whose value chooses this row; empty: the row's own
};
/// One row of brdf_terms.def, in order. Within a slot the order is that of its enumeration.
struct BrdfTerm {
    std::string_view slot;
    std::string_view name;   ///< with underscores; the command line writes dashes
    std::string_view files;  ///< in glsl/brdf, without ending, spaces between
    std::string_view call;   ///< the expression, GLSL and C++
    BrdfTermNotes notes;
};
inline constexpr auto brdf_terms = std::to_array<BrdfTerm>({
#define TERM(slot, name, files, call, ...) {#slot, #name, files, #call, {__VA_ARGS__}},
#include "tables/brdf_terms.def"
});

/// One row of brdf_slots.def.
struct BrdfSlotFunction {
    std::string_view slot;
    std::string_view signature;
    bool samples = false;  ///< for drawing directions; shading does without
};
inline constexpr auto brdf_slot_functions = std::to_array<BrdfSlotFunction>({
#define SLOT(slot, ...) {#slot, #__VA_ARGS__},
#define SAMPLER(slot, ...) {#slot, #__VA_ARGS__, true},
#include "tables/brdf_slots.def"
});

}  // namespace facet::tables

template <>
struct std::hash<facet::tables::BrdfChoice> {
    [[nodiscard]] std::size_t operator()(const facet::tables::BrdfChoice& choice) const noexcept {
        // Mixed radix: no slot has 16 values, so different choices have different hashes.
        std::size_t key = static_cast<std::size_t>(choice.environment_masking);
        for (const facet::tables::BrdfSlot& slot : facet::tables::brdf_slots)
            key = key * 16 + slot.index(choice);
        return key;
    }
};
