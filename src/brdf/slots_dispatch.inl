// The slots of brdf_slots.def as switches over a choice: brdf_terms.def expanded once a slot,
// inside Terms<Real>. SPDX-License-Identifier: MIT

real slot_distribution([[maybe_unused]] real n_dot_h, [[maybe_unused]] real alpha) {
    using Chosen = tables::Distribution;
    switch (choice.distribution) {
#define FACET_WANT_distribution ~,
#define TERM(slot, name, files, call, ...) \
    FACET_SELECT(FACET_WANT_##slot case Chosen::name : return real(call);)
#include "tables/brdf_terms.def"
#undef FACET_WANT_distribution
    }
    return real(real(0));
}

real slot_smith_correlated([[maybe_unused]] real n_dot_v, [[maybe_unused]] real n_dot_l,
                           [[maybe_unused]] real alpha) {
    using Chosen = tables::Distribution;
    switch (choice.distribution) {
#define FACET_WANT_smith_correlated ~,
#define TERM(slot, name, files, call, ...) \
    FACET_SELECT(FACET_WANT_##slot case Chosen::name : return real(call);)
#include "tables/brdf_terms.def"
#undef FACET_WANT_smith_correlated
    }
    return real(real(0));
}

real slot_smith([[maybe_unused]] real n_dot_v, [[maybe_unused]] real n_dot_l,
                [[maybe_unused]] real alpha) {
    using Chosen = tables::Distribution;
    switch (choice.distribution) {
#define FACET_WANT_smith ~,
#define TERM(slot, name, files, call, ...) \
    FACET_SELECT(FACET_WANT_##slot case Chosen::name : return real(call);)
#include "tables/brdf_terms.def"
#undef FACET_WANT_smith
    }
    return real(real(0));
}

real slot_masking([[maybe_unused]] real n_dot_v, [[maybe_unused]] real n_dot_l,
                  [[maybe_unused]] real roughness, [[maybe_unused]] real alpha) {
    using Chosen = tables::Masking;
    switch (choice.masking) {
#define FACET_WANT_masking ~,
#define TERM(slot, name, files, call, ...) \
    FACET_SELECT(FACET_WANT_##slot case Chosen::name : return real(call);)
#include "tables/brdf_terms.def"
#undef FACET_WANT_masking
    }
    return real(real(0));
}

real3 slot_fresnel([[maybe_unused]] real3 f0, [[maybe_unused]] real3 edge_tint,
                   [[maybe_unused]] real v_dot_h) {
    using Chosen = tables::Fresnel;
    switch (choice.fresnel) {
#define FACET_WANT_fresnel ~,
#define TERM(slot, name, files, call, ...) \
    FACET_SELECT(FACET_WANT_##slot case Chosen::name : return real3(call);)
#include "tables/brdf_terms.def"
#undef FACET_WANT_fresnel
    }
    return real3(real(0));
}

real3 slot_diffuse([[maybe_unused]] real3 color, [[maybe_unused]] real roughness,
                   [[maybe_unused]] real n_dot_v, [[maybe_unused]] real n_dot_l,
                   [[maybe_unused]] real v_dot_h) {
    using Chosen = tables::Diffuse;
    switch (choice.diffuse) {
#define FACET_WANT_diffuse ~,
#define TERM(slot, name, files, call, ...) \
    FACET_SELECT(FACET_WANT_##slot case Chosen::name : return real3(call);)
#include "tables/brdf_terms.def"
#undef FACET_WANT_diffuse
    }
    return real3(real(0));
}

real3 slot_diffuse_albedo([[maybe_unused]] real3 color, [[maybe_unused]] real roughness,
                          [[maybe_unused]] real n_dot_v, [[maybe_unused]] real white) {
    using Chosen = tables::Diffuse;
    switch (choice.diffuse) {
#define FACET_WANT_diffuse_albedo ~,
#define TERM(slot, name, files, call, ...) \
    FACET_SELECT(FACET_WANT_##slot case Chosen::name : return real3(call);)
#include "tables/brdf_terms.def"
#undef FACET_WANT_diffuse_albedo
    }
    return real3(real(0));
}

real3 slot_multiscatter([[maybe_unused]] real3 f0, [[maybe_unused]] real e_v) {
    using Chosen = tables::Multiscatter;
    switch (choice.multiscatter) {
#define FACET_WANT_multiscatter ~,
#define TERM(slot, name, files, call, ...) \
    FACET_SELECT(FACET_WANT_##slot case Chosen::name : return real3(call);)
#include "tables/brdf_terms.def"
#undef FACET_WANT_multiscatter
    }
    return real3(real(0));
}

real3 slot_added([[maybe_unused]] real3 f0, [[maybe_unused]] real a, [[maybe_unused]] real b,
                 [[maybe_unused]] real e_average) {
    using Chosen = tables::Multiscatter;
    switch (choice.multiscatter) {
#define FACET_WANT_added ~,
#define TERM(slot, name, files, call, ...) \
    FACET_SELECT(FACET_WANT_##slot case Chosen::name : return real3(call);)
#include "tables/brdf_terms.def"
#undef FACET_WANT_added
    }
    return real3(real(0));
}

real slot_added_shape([[maybe_unused]] real e_l, [[maybe_unused]] real e_average) {
    using Chosen = tables::Multiscatter;
    switch (choice.multiscatter) {
#define FACET_WANT_added_shape ~,
#define TERM(slot, name, files, call, ...) \
    FACET_SELECT(FACET_WANT_##slot case Chosen::name : return real(call);)
#include "tables/brdf_terms.def"
#undef FACET_WANT_added_shape
    }
    return real(real(0));
}

real slot_width([[maybe_unused]] real roughness) {
    using Chosen = tables::Width;
    switch (choice.width) {
#define FACET_WANT_width ~,
#define TERM(slot, name, files, call, ...) \
    FACET_SELECT(FACET_WANT_##slot case Chosen::name : return real(call);)
#include "tables/brdf_terms.def"
#undef FACET_WANT_width
    }
    return real(real(0));
}

real3 slot_sample_half([[maybe_unused]] real3 v, real alpha, real2 u) {
    using Chosen = tables::Distribution;
    switch (choice.distribution) {
#define FACET_WANT_sample_half ~,
#define TERM(slot, name, files, call, ...) \
    FACET_SELECT(FACET_WANT_##slot case Chosen::name : return real3(call);)
#include "tables/brdf_terms.def"
#undef FACET_WANT_sample_half
    }
    return real3(real(0));
}

real slot_pdf_reflected(real n_dot_v, real n_dot_h, real v_dot_h, real alpha) {
    using Chosen = tables::Distribution;
    switch (choice.distribution) {
#define FACET_WANT_pdf_reflected ~,
#define TERM(slot, name, files, call, ...) \
    FACET_SELECT(FACET_WANT_##slot case Chosen::name : return real(call);)
#include "tables/brdf_terms.def"
#undef FACET_WANT_pdf_reflected
    }
    return real(real(0));
}

real3 slot_sample_diffuse(real2 u) {
    using Chosen = tables::Diffuse;
    switch (choice.diffuse) {
#define FACET_WANT_sample_diffuse ~,
#define TERM(slot, name, files, call, ...) \
    FACET_SELECT(FACET_WANT_##slot case Chosen::name : return real3(call);)
#include "tables/brdf_terms.def"
#undef FACET_WANT_sample_diffuse
    }
    return real3(real(0));
}

real slot_pdf_diffuse(real n_dot_l) {
    using Chosen = tables::Diffuse;
    switch (choice.diffuse) {
#define FACET_WANT_pdf_diffuse ~,
#define TERM(slot, name, files, call, ...) \
    FACET_SELECT(FACET_WANT_##slot case Chosen::name : return real(call);)
#include "tables/brdf_terms.def"
#undef FACET_WANT_pdf_diffuse
    }
    return real(real(0));
}
