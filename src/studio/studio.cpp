// The studio: its loop.
// SPDX-License-Identifier: MIT
#include "studio/studio.h"

#include "base/cache_folder.h"
#include "base/file.h"
#include "base/resources.h"
#include "base/text.h"
#include "base/texts.h"
#include "image/write.h"
#include "render/plan.h"
#include "studio/commands.h"
#include "studio/fonts.h"
#include "studio/layout.h"
#include "studio/menu.h"
#include "studio/prober.h"
#include "studio/screen.h"
#include "studio/thumbnails.h"
#include "studio/truth.h"
#include "tables/settings_text.h"

#include <algorithm>
#include <chrono>

namespace facet::studio {
namespace {

using Clock = std::chrono::steady_clock;

constexpr float font_points = 15.0F;
/// Seconds that the loop sleeps where nothing is left to do: files are looked at then.
constexpr double idle_s = 1.0;
/// The same while something goes on elsewhere, and while a caret blinks.
constexpr double soon_s = 0.1;
constexpr double caret_s = 0.4;
/// Seconds after the last change that count as moving.
constexpr double moving_s = 0.25;
/// Frames of a drag are to take no longer: 16 a second, in the largest window.
constexpr double wanted_frame_ms = 62.0;
constexpr double slowest_frame_ms = 66.0;
/// After the last input, where a sample at full size would make the next one wait.
constexpr auto patience = std::chrono::milliseconds(700);
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
    Studio(const StudioRequest& request, base::Log& log);
    base::Status open();
    base::Status run();

private:
    base::Status open_screen();
    void use_scale();
    base::Status draw_frame();
    void draw_panels_and_dialogs();
    void do_wanted();
    void go_to(std::size_t lesson_view);
    void play(float passed_s);
    base::Status act(const ScriptStep& step);
    base::Status step_stage();
    base::Status write_shot(const std::filesystem::path& path);
    [[nodiscard]] bool is_over();
    [[nodiscard]] PlayProgress progress() const;
    [[nodiscard]] double wait_s() const;

    const StudioRequest& request_;
    base::Log& log_;
    ImGuiOwner imgui_;
    base::ThreadPool pool_;
    Config config_;
    Config config_on_disk_;
    std::optional<base::Texts> texts_;
    gl::ShaderSources sources_;
    // The screen has the GL context that everything below needs.
    std::optional<Screen> screen_;
    std::optional<UiRenderer> pictures_;
    std::optional<Ui> ui_;
    std::optional<Stage> stage_;
    Editor editor_;
    std::optional<Commands> commands_;
    std::optional<Truth> truth_;
    std::optional<Thumbnails> thumbnails_;
    Inspection inspection_;
    Prober prober_;
    Input input_;
    ScriptPlayer player_;
    float scale_ = 0.0F;
    Theme theme_ = Theme::dark;
    math::Extent area_px_;
    std::uint32_t frame_ = 0;
    std::uint32_t calm_frames_ = 0;   ///< drawn since something happened
    bool skipped_ = false;            ///< the picture, in this frame
    tables::Settings good_settings_;  ///< the last that were drawn
    std::size_t good_steps_ = 0;
    bool playing_ = false;  ///< a script did something in this frame
    double ui_ms_ = 8.0;    ///< that a frame takes without its picture
    Clock::time_point last_change_{};
    Clock::time_point last_input_{};
    math::Vec2 mouse_px_{-1.0F};
    Clock::time_point last_frame_{};
    std::optional<std::filesystem::path> shot_;  ///< of the frame being drawn
};

Studio::Studio(const StudioRequest& request, base::Log& log)
    : request_(request), log_(log), player_(request.script) {
    // Without a window nobody's habits count: the same pictures everywhere.
    if (!request.offscreen) config_ = load_config();
    config_on_disk_ = config_;
    if (request.theme) config_.theme = *request.theme;
    if (!request.language.empty()) config_.language = request.language;
    if (config_.language.empty()) config_.language = request.offscreen ? "en" : desktop_language();
    if (request.window_points.width > 0) config_.window_points = request.window_points;
}

base::Status Studio::open() {
    auto texts = base::Texts::load(config_.language);
    if (!texts) return tl::unexpected(texts.error());
    texts_ = std::move(*texts);
    if (auto s = open_screen(); !s) return s;
    const auto folder = base::data_folder();
    if (!folder) return tl::unexpected(folder.error());
    sources_ = {*folder / "glsl", {}};
    auto pictures = UiRenderer::create(screen_->gl(), sources_);
    if (!pictures) return tl::unexpected(pictures.error());
    pictures_ = std::move(*pictures);
    ui_.emplace(Ui{*texts_, *pictures_});
    stage_.emplace(StageTools{screen_->gl(), pool_, log_, base::cache_folder()});
    thumbnails_.emplace(StageTools{screen_->gl(), pool_, log_, base::cache_folder()});
    commands_.emplace(CommandTools{editor_, *stage_, config_, *ui_, request_.offscreen},
                      request_.offscreen ? std::filesystem::path() : state_folder());
    truth_.emplace([this] {
        if (Window* window = screen_->window()) window->wake();
    });
    return commands_->open_scene({request_.scene, request_.settings});
}

base::Status Studio::open_screen() {
    const auto plan = render::make_plan(request_.settings);
    if (!plan) return tl::unexpected(plan.error());
    auto screen = request_.offscreen
                      ? Screen::open_offscreen(config_.window_points, plan->backend, log_)
                      : Screen::open_window(config_.window_points, log_);
    if (!screen) return tl::unexpected(screen.error());
    screen_ = std::move(*screen);
    if (screen_->window() != nullptr) screen_->window()->share_clipboard();
    return {};
}

void Studio::use_scale() {
    if (input_.scale != scale_) {
        scale_ = input_.scale;
        ui_->scale = scale_;
        const Fonts fonts = load_fonts(font_points * scale_);
        if (auto s = pictures_->upload_font(screen_->gl(), *ImGui::GetIO().Fonts); !s)
            editor_.complain(s.error());
        if (!fonts.has_cyrillic && texts_->language() == "ru")
            editor_.say(Message::Kind::warning, "apt-get install fonts-dejavu-core");
        apply_theme(config_.theme, scale_);
        theme_ = config_.theme;
    }
    if (theme_ != config_.theme) {
        theme_ = config_.theme;
        apply_theme(theme_, scale_);
    }
    if (texts_->language() == config_.language) return;
    if (auto texts = base::Texts::load(config_.language)) *texts_ = std::move(*texts);
}

base::Status Studio::step_stage() {
    const std::chrono::duration<double> since = Clock::now() - last_change_;
    const bool held = input_.buttons != std::array<bool, 3>{} || input_.wheel != 0.0F;
    const Scenery scenery{.settings = editor_.document.settings,
                          .opened = editor_.opened,
                          .look = editor_.look,
                          .solo = editor_.material,
                          .area_px = area_px_,
                          .budget_ms = std::clamp(wanted_frame_ms - ui_ms_, 12.0, 55.0),
                          .moving = editor_.plays || (since.count() < moving_s && held),
                          .patient = request_.offscreen || Clock::now() - last_input_ > patience};
    // Where both do not fit into a frame, the picture takes every other one.
    skipped_ = scenery.moving && !skipped_ && ui_ms_ + stage_->last_ms() > slowest_frame_ms;
    if (skipped_) return {};
    auto stepped = stage_->step(scenery, *pictures_);
    if (!stepped) return stepped;
    truth_->update(screen_->gl(), *stage_, editor_, *pictures_, inspection_);
    prober_.update(screen_->gl(), *stage_, editor_, *pictures_, inspection_);
    return {};
}

void Studio::do_wanted() {
    Wanted& wanted = editor_.wanted;
    if (const auto scene = std::exchange(wanted.open, std::nullopt))
        if (auto s = commands_->open_scene({*scene, request_.settings}); !s)
            editor_.complain(s.error());
    if (const auto view = std::exchange(wanted.lesson_view, std::nullopt)) go_to(*view);
    if (const auto action = std::exchange(wanted.action, std::nullopt)) commands_->act(*action);
    if (std::exchange(wanted.thumbnails, false))
        if (auto s = thumbnails_->step(*pictures_); !s) editor_.complain(s.error());
}

/// A view of the scene that is open is an edit of its settings; another scene is opened.
void Studio::go_to(std::size_t lesson_view) {
    const LessonView& view = request_.lesson->views[lesson_view];
    if (view.document.scene == editor_.document.scene) {
        editor_.history.seal();
        editor_.edit("lesson", [&](tables::Settings& s) { s = view.document.settings; });
        editor_.history.seal();
        editor_.orbit.reset();
    } else if (auto s = commands_->open_scene(view.document); !s) {
        return editor_.complain(s.error());
    }
    editor_.look.view = view.show;
    editor_.lesson_view = lesson_view;
}

void Studio::play(float passed_s) {
    const render::Job& job = stage_->job();
    editor_.plays = editor_.plays && job.clip != nullptr;
    if (editor_.plays) editor_.play(passed_s, job.clip->end_s);
}

void Studio::draw_panels_and_dialogs() {
    PanelTools tools{*ui_,        editor_,      *stage_,        screen_->gl(),
                     inspection_, *thumbnails_, request_.lesson};
    const auto action = draw_menu(tools, config_.recent);
    area_px_ = draw_panels(tools, config_.layout);
    draw_status(tools);
    commands_->draw();
    if (action) commands_->act(*action);
    commands_->drop_files(input_);
    commands_->update();
}

base::Status Studio::draw_frame() {
    const auto now = Clock::now();
    const std::chrono::duration<float> passed = now - last_frame_;
    last_frame_ = now;
    use_scale();
    feed_imgui(input_,
               request_.offscreen ? offscreen_frame_s : std::clamp(passed.count(), 1e-4F, 0.5F));
    ImGui::NewFrame();
    ui_->widgets.clear();
    const tables::Settings before = editor_.document.settings;
    play(request_.offscreen ? offscreen_frame_s : std::clamp(passed.count(), 0.0F, 0.5F));
    draw_panels_and_dialogs();
    ImGui::Render();
    if (!ImGui::IsAnyItemActive()) editor_.history.seal();
    do_wanted();
    if (!(before == editor_.document.settings)) last_change_ = now;
    const auto before_picture = Clock::now();
    if (auto s = step_stage(); !s) {
        if (playing_) return s;  // a script's step that does not work
        // What cannot be drawn was not done.
        editor_.complain(s.error());
        editor_.document.settings = good_settings_;
        editor_.history.keep(good_steps_);
    } else {
        good_settings_ = editor_.document.settings;
        good_steps_ = editor_.history.undo_count();
    }
    const auto after_picture = Clock::now();
    const auto target = screen_->begin(input_.window_px, theme_ == Theme::dark ? 0.1F : 0.8F);
    if (!target) return tl::unexpected(target.error());
    pictures_->draw(screen_->gl(), *ImGui::GetDrawData(), *target, input_.window_px);
    if (const auto shot = std::exchange(shot_, std::nullopt))
        if (auto s = write_shot(*shot); !s) return s;
    screen_->show();
    const std::chrono::duration<double, std::milli> took = Clock::now() - now;
    const std::chrono::duration<double, std::milli> picture = after_picture - before_picture;
    ui_ms_ += 0.2 * (took.count() - picture.count() - ui_ms_);
    log_.debug("frame {}: {:.1f} ms, of which the picture took {:.1f} at {}x{}", frame_,
               took.count(), stage_->last_ms(), stage_->size_px().width, stage_->size_px().height);
    return screen_->gl().check("studio");
}

base::Status Studio::write_shot(const std::filesystem::path& path) {
    const auto bytes = image::encode(screen_->read(), {.metadata = {}});
    if (!bytes) return tl::unexpected(bytes.error());
    return base::write_file_atomically(path, *bytes);
}

base::Status Studio::act(const ScriptStep& step) {
    tables::Settings& settings = editor_.document.settings;
    switch (step.verb) {
        case Verb::set: {
            const std::string value = base::join(std::span(step.words).subspan(1), " ");
            editor_.history.seal();
            if (step.words[0].find_first_of(".[") != std::string::npos) {
                editor_.set(step.words[0], value);
                return {};
            }
            base::Status assigned;
            editor_.edit(step.words[0], [&](tables::Settings& s) {
                assigned = tables::assign(s, step.words[0], {value});
            });
            return assigned;
        }
        case Verb::open:
            return commands_->open_scene({step.words[0], settings});
        case Verb::save:
            return commands_->save_to(step.words[0]);
        case Verb::undo:
            editor_.history.undo(settings);
            return {};
        case Verb::redo:
            editor_.history.redo(settings);
            return {};
        case Verb::shot:
            shot_ = step.words[0];
            return {};
        case Verb::quit:
            editor_.unsaved = false;
            input_.wants_close = true;
            return {};
        default:
            return {};
    }
}

bool Studio::is_over() {
    const bool asked = input_.wants_close || std::exchange(editor_.wanted.quit, false);
    input_.wants_close = false;
    if (asked) return commands_->may_close();
    if (request_.frames > 0) return frame_ >= request_.frames;
    return request_.has_script && request_.offscreen && player_.is_done() && !shot_;
}

PlayProgress Studio::progress() const {
    return {.picture_finished = stage_->is_finished() && !commands_->is_busy(),
            .reference_samples = inspection_.against.samples,
            .is_compared = inspection_.against.is_known};
}

double Studio::wait_s() const {
    if (player_.waits_for_truth() && stage_->is_finished()) return soon_s;
    const bool busy = editor_.plays || !stage_->is_finished() || !player_.is_done() || shot_ ||
                      request_.frames > 0 || calm_frames_ < 3 || !editor_.history.is_sealed();
    if (busy) return stage_->is_waiting() && player_.is_done() ? soon_s : 0.0;
    if (ImGui::GetIO().WantTextInput) return caret_s;
    return commands_->is_busy() || !truth_->is_quiet() ? soon_s : idle_s;
}

base::Status Studio::run() {
    while (!is_over()) {
        screen_->poll(input_, wait_s());
        if (!input_.is_idle() || input_.mouse_px != mouse_px_) last_input_ = Clock::now();
        mouse_px_ = input_.mouse_px;
        if (!input_.is_idle() || !stage_->is_finished() || !truth_->is_quiet()) calm_frames_ = 0;
        playing_ = !player_.is_done();
        const auto played = player_.play(input_, *ui_, progress(),
                                         [this](const ScriptStep& step) { return act(step); });
        if (!played) return played;
        ++frame_;
        if (request_.frames > 0 && frame_ == request_.frames && !request_.shot.empty())
            shot_ = request_.shot;
        if (input_.window_px.pixels() == 0) continue;  // an iconified window
        const bool changes = commands_->sees_changes();
        if (wait_s() == idle_s && !changes) continue;  // nothing to draw
        if (changes) calm_frames_ = 0;
        ++calm_frames_;
        if (auto s = draw_frame(); !s) return s;
    }
    commands_->discard();
    const bool has_habits = !request_.offscreen && !request_.has_script && request_.frames == 0;
    if (!has_habits) return {};
    const auto points = [&](std::uint32_t px) {
        return static_cast<std::uint32_t>(static_cast<float>(px) / std::max(scale_, 0.5F));
    };
    config_.window_points = {points(input_.window_px.width), points(input_.window_px.height)};
    if (!(config_ == config_on_disk_)) save_config(config_);
    return {};
}

}  // namespace

base::Status run(const StudioRequest& request, base::Log& log) {
    Studio studio(request, log);
    if (auto s = studio.open(); !s) return s;
    return studio.run();
}

}  // namespace facet::studio
