// The truth beside the picture.
// SPDX-License-Identifier: MIT
#include "studio/truth.h"

#include "image/compare.h"
#include "render/plan.h"

#include <chrono>

namespace facet::studio {
namespace {

/// Enough for a picture that looks finished; the command line renders more.
constexpr std::uint32_t truth_samples = 1024;

image::Picture picture_of(image::Image&& display) {
    return {.layers = {{.name = "", .channels = {"R", "G", "B", "A"}, .image = std::move(display)}},
            .metadata = {},
            .format = tables::ImageFormat::png};
}

/// What a screen makes of the light is not the tracer's business.
tables::Settings traced(tables::Settings settings) {
    settings.exposure = "auto";
    settings.ev = std::nullopt;
    settings.tonemap.clear();
    return settings;
}

}  // namespace

void Truth::forget(UiRenderer& pictures, Inspection& inspection) {
    if (!started_) return;
    worker_.stop();
    started_.reset();
    compare_again_ = false;
    last_.reset();
    pictures.hide(Slot::reference);
    pictures.hide(Slot::difference);
    inspection.against = {};
}

std::optional<Truth::Compared> Truth::compare(image::Image raster, image::Image truth) {
    const image::Picture a = picture_of(std::move(raster));
    const image::Picture b = picture_of(std::move(truth));
    const auto covered = image::compare(a, b, {.pixels = image::Pixels::covered});
    auto whole = image::compare(b, a, {.heat = image::Heat::flip});
    if (!whole) return std::nullopt;
    const double flip = whole->flip.value_or(0.0);
    return Compared{std::move(whole->heat), covered ? covered->rmse : whole->rmse, flip};
}

void Truth::take_comparison(const gl::Context& gl, Editor& editor, UiRenderer& pictures,
                            Inspection& inspection) {
    using namespace std::chrono_literals;
    if (!comparing_.valid() || comparing_.wait_for(0s) != std::future_status::ready) return;
    const auto compared = comparing_.get();
    if (!compared || !started_) return;
    inspection.against.rmse = compared->rmse;
    inspection.against.flip = compared->flip;
    inspection.against.is_known = true;
    if (auto s = pictures.upload(gl, Slot::difference, compared->heat); !s)
        editor.complain(s.error());
}

void Truth::show(const gl::Context& gl, Stage& stage, Editor& editor, UiRenderer& pictures,
                 Inspection& inspection, const ReferencePicture& picture) {
    auto shown = stage.encode(picture.radiance);
    if (!shown) return editor.complain(shown.error());
    inspection.against.samples = picture.samples;
    if (auto s = pictures.upload(gl, Slot::reference, *shown); !s) editor.complain(s.error());
    shown_ = std::move(*shown);
    compare_again_ = true;
}

void Truth::update(const gl::Context& gl, Stage& stage, Editor& editor, UiRenderer& pictures,
                   Inspection& inspection) {
    const Look& look = editor.look;
    const bool is_wanted =
        (look.beside == Beside::reference || look.beside == Beside::difference) &&
        look.view == "beauty" && !look.solo;
    const Key key{traced(editor.document.settings), stage.size_px()};
    if (!is_wanted || (started_ && !(*started_ == key))) forget(pictures, inspection);
    if (!is_wanted) return;
    if (!started_ && stage.is_finished()) {
        worker_.start(stage.job(), stage.plan(), stage.settings(), truth_samples);
        started_ = key;
    }
    if (const std::string trouble = worker_.trouble(); !trouble.empty())
        editor.say(Message::Kind::error, trouble);
    auto picture = worker_.take();
    const bool is_new = picture.has_value();
    if (is_new) last_ = std::move(picture);
    const bool shown_anew = stage.is_finished() && stage.shown_count() != shown_count_;
    if (started_ && last_ && (is_new || shown_anew)) {
        shown_count_ = stage.shown_count();
        show(gl, stage, editor, pictures, inspection, *last_);
    }
    take_comparison(gl, editor, pictures, inspection);
    if (compare_again_ && !comparing_.valid() && stage.shown().size == shown_.size) {
        compare_again_ = false;
        comparing_ = std::async(std::launch::async, compare, stage.shown(), shown_);
    }
}

}  // namespace facet::studio
