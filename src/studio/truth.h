// The truth beside the picture: the reference, the difference to it, and both in numbers.
// SPDX-License-Identifier: MIT
#pragma once

#include "studio/editor.h"
#include "studio/inspection.h"
#include "studio/reference_worker.h"
#include "studio/ui_renderer.h"

#include <future>
#include <optional>

namespace facet::studio {

class Truth {
public:
    explicit Truth(std::function<void()> wake) : worker_(std::move(wake)) {}

    /// Once a frame, after the stage's step: starts, stops and shows. `area_px`: the viewport.
    void update(const gl::Context& gl, Stage& stage, Editor& editor, UiRenderer& pictures,
                Inspection& inspection);
    /// Nothing more comes, or nothing is wanted.
    [[nodiscard]] bool is_quiet() const { return !worker_.is_running() && !comparing_.valid(); }

private:
    struct Compared {
        image::Image heat;
        double rmse = 0.0;
        double flip = 0.0;
    };
    struct Key {
        tables::Settings settings;
        math::Extent size;
        bool operator==(const Key&) const = default;
    };
    void forget(UiRenderer& pictures, Inspection& inspection);
    void show(const gl::Context& gl, Stage& stage, Editor& editor, UiRenderer& pictures,
              Inspection& inspection, const ReferencePicture& picture);
    [[nodiscard]] static std::optional<Compared> compare(image::Image raster, image::Image truth);
    void take_comparison(const gl::Context& gl, Editor& editor, UiRenderer& pictures,
                         Inspection& inspection);

    ReferenceWorker worker_;
    std::optional<Key> started_;  ///< what the reference is of
    std::future<std::optional<Compared>> comparing_;
    bool compare_again_ = false;
    std::optional<ReferencePicture> last_;
    std::uint32_t shown_count_ = 0;  ///< the stage's, when the reference was shown
    image::Image shown_;             ///< the reference as a screen shows it
};

}  // namespace facet::studio
