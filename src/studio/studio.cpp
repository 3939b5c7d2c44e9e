// The studio: its loop.
// SPDX-License-Identifier: MIT
#include "studio/studio.h"

#include "base/file.h"
#include "base/resources.h"
#include "base/text.h"
#include "image/write.h"
#include "render/plan.h"
#include "studio/editor.h"
#include "studio/fonts.h"
#include "studio/layout.h"
#include "studio/menu.h"
#include "studio/screen.h"
#include "studio/stage.h"

#include <algorithm>
#include <chrono>
#include <memory>

namespace facet::studio {
namespace {

constexpr float font_points = 15.0F;
constexpr math::Extent first_window{1440, 860};
/// Seconds that the loop sleeps where nothing is left to do: files are looked at then.
constexpr double idle_s = 1.0;
/// Seconds after the last change that count as moving.
constexpr double moving_s = 0.25;
constexpr float offscreen_frame_s = 1.0F / 60.0F;

/// ImGui's own state, which it keeps behind a pointer of its own.
struct ImGuiOwner {
    ImGuiOwner() {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.LogFilename = nullptr;
        io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
        io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
        map_keys();
    }
    ~ImGuiOwner() { ImGui::DestroyContext(); }
    ImGuiOwner(const ImGuiOwner&) = delete;
    ImGuiOwner& operator=(const ImGuiOwner&) = delete;
};

class Studio {
public:
    Studio(const StudioRequest& request, base::Log& log)
        : request_(request), log_(log), player_(request.script) {}
    base::Status open();
    base::Status run();

private:
    base::Status open_screen();
    base::Status open_scene(const std::string& scene);
    void use_scale(float scale);
    base::Status draw_frame();
    void do_wanted();
    base::Status act(const ScriptStep& step);
    base::Status step_stage();
    base::Status write_shot(const std::filesystem::path& path);
    [[nodiscard]] bool is_over() const;
    [[nodiscard]] double wait_s() const;

    const StudioRequest& request_;
    base::Log& log_;
    ImGuiOwner imgui_;
    base::ThreadPool pool_;
    std::optional<base::Texts> texts_;
    gl::ShaderSources sources_;
    // The screen has the GL context that everything below needs.
    std::optional<Screen> screen_;
    std::optional<UiRenderer> pictures_;
    std::optional<Ui> ui_;
    std::optional<Stage> stage_;
    Editor editor_;
    Layout layout_;
    Theme theme_ = Theme::dark;
    Input input_;
    ScriptPlayer player_;
    float scale_ = 0.0F;
    math::Extent area_px_;
    std::uint32_t frame_ = 0;
    std::uint32_t calm_frames_ = 0;  ///< since something happened
    std::chrono::steady_clock::time_point last_change_{};
    std::chrono::steady_clock::time_point last_frame_{};
    std::optional<std::filesystem::path> shot_;  ///< of the frame being drawn
};

base::Status Studio::open() {
    auto texts = base::Texts::load(request_.language.empty() ? "en" : request_.language);
    if (!texts) return tl::unexpected(texts.error());
    texts_ = std::move(*texts);
    if (request_.theme) theme_ = *request_.theme;
    if (auto s = open_screen(); !s) return s;
    const auto folder = base::data_folder();
    if (!folder) return tl::unexpected(folder.error());
    sources_ = {*folder / "glsl", {}};
    auto pictures = UiRenderer::create(screen_->gl(), sources_);
    if (!pictures) return tl::unexpected(pictures.error());
    pictures_ = std::move(*pictures);
    ui_.emplace(Ui{*texts_, *pictures_});
    stage_.emplace(StageTools{screen_->gl(), pool_, log_});
    editor_.document.settings = request_.settings;
    return open_scene(request_.scene);
}

base::Status Studio::open_screen() {
    math::Extent points = request_.window_points;
    if (points.width == 0) points = first_window;
    const auto plan = render::make_plan(request_.settings);
    if (!plan) return tl::unexpected(plan.error());
    auto screen = request_.offscreen ? Screen::open_offscreen(points, plan->backend, log_)
                                     : Screen::open_window(points, log_);
    if (!screen) return tl::unexpected(screen.error());
    screen_ = std::move(*screen);
    if (screen_->window() != nullptr) screen_->window()->share_clipboard();
    return {};
}

base::Status Studio::open_scene(const std::string& scene) {
    Document document{scene, editor_.document.settings};
    if (auto s = stage_->open(document, request_.offscreen); !s) return s;
    editor_.document = document;
    editor_.opened = document.settings;
    editor_.history.clear();
    editor_.unsaved = false;
    editor_.material = std::nullopt;
    editor_.light = std::nullopt;
    editor_.orbit = std::nullopt;
    for (const base::Warning& warning : stage_->warnings())
        editor_.say(Message::Kind::warning, base::to_line(warning));
    return {};
}

void Studio::use_scale(float scale) {
    if (scale == scale_) return;
    scale_ = scale;
    ui_->scale = scale;
    apply_theme(theme_, scale);
    (void)load_fonts(font_points * scale);
    if (auto s = pictures_->upload_font(screen_->gl(), *ImGui::GetIO().Fonts); !s)
        editor_.complain(s.error());
}

base::Status Studio::step_stage() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> since = now - last_change_;
    const Scenery scenery{.settings = editor_.document.settings,
                          .opened = editor_.opened,
                          .look = editor_.look,
                          .solo = editor_.material,
                          .area_px = area_px_,
                          .moving = since.count() < moving_s && input_.buttons[0]};
    return stage_->step(scenery, *pictures_);
}

void Studio::do_wanted() {
    Wanted wanted = std::exchange(editor_.wanted, {});
    if (wanted.open)
        if (auto s = open_scene(*wanted.open); !s) editor_.complain(s.error());
}

base::Status Studio::draw_frame() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<float> passed = now - last_frame_;
    last_frame_ = now;
    use_scale(input_.scale);
    feed_imgui(input_,
               request_.offscreen ? offscreen_frame_s : std::clamp(passed.count(), 1e-4F, 0.5F));
    ImGui::NewFrame();
    ui_->widgets.clear();
    const tables::Settings before = editor_.document.settings;
    PanelTools tools{*ui_, editor_, *stage_, screen_->gl()};
    draw_menu(tools);
    area_px_ = draw_panels(tools, layout_);
    draw_status(tools);
    ImGui::Render();
    if (!ImGui::IsAnyItemActive()) editor_.history.seal();
    if (!(before == editor_.document.settings)) last_change_ = now;
    do_wanted();
    if (auto s = step_stage(); !s) {
        editor_.complain(s.error());
        editor_.document.settings = before;
    }
    const auto target = screen_->begin(input_.window_px, theme_ == Theme::dark ? 0.1F : 0.8F);
    if (!target) return tl::unexpected(target.error());
    pictures_->draw(screen_->gl(), *ImGui::GetDrawData(), *target, input_.window_px);
    if (shot_)
        if (auto s = write_shot(*std::exchange(shot_, std::nullopt)); !s) return s;
    screen_->show();
    return screen_->gl().check("studio");
}

base::Status Studio::write_shot(const std::filesystem::path& path) {
    const auto bytes = image::encode(screen_->read(), {.metadata = {}});
    if (!bytes) return tl::unexpected(bytes.error());
    return base::write_file_atomically(path, *bytes);
}

base::Status Studio::act(const ScriptStep& step) {
    switch (step.verb) {
        case Verb::set:
            editor_.history.seal();
            editor_.set(step.words[0], base::join(std::span(step.words).subspan(1), " "));
            return {};
        case Verb::open:
            return open_scene(step.words[0]);
        case Verb::undo:
            editor_.history.undo(editor_.document.settings);
            return {};
        case Verb::redo:
            editor_.history.redo(editor_.document.settings);
            return {};
        case Verb::shot:
            shot_ = step.words[0];
            return {};
        case Verb::quit:
            input_.wants_close = true;
            return {};
        default:
            return {};
    }
}

bool Studio::is_over() const {
    if (input_.wants_close) return true;
    if (request_.frames > 0) return frame_ >= request_.frames;
    return request_.has_script && player_.is_done() && (request_.offscreen || !shot_);
}

double Studio::wait_s() const {
    const bool busy =
        !stage_->is_finished() || !player_.is_done() || request_.frames > 0 || calm_frames_ < 3;
    return busy ? 0.0 : idle_s;
}

base::Status Studio::run() {
    while (!is_over()) {
        screen_->poll(input_, wait_s());
        calm_frames_ = input_.is_idle() ? calm_frames_ + 1 : 0;
        const auto played = player_.play(input_, *ui_, stage_->is_finished(),
                                         [this](const ScriptStep& step) { return act(step); });
        if (!played) return played;
        ++frame_;
        if (request_.frames > 0 && frame_ == request_.frames && !request_.shot.empty())
            shot_ = request_.shot;
        if (input_.window_px.pixels() == 0) continue;  // an iconified window
        if (auto s = draw_frame(); !s) return s;
    }
    return {};
}

}  // namespace

base::Status run(const StudioRequest& request, base::Log& log) {
    Studio studio(request, log);
    if (auto s = studio.open(); !s) return s;
    return studio.run();
}

}  // namespace facet::studio
