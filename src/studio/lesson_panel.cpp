// The lesson's part of the scene panel.
// SPDX-License-Identifier: MIT
#include "studio/panels.h"

#include <spdlog/fmt/fmt.h>

namespace facet::studio {
namespace {

/// In the language, or in the first there is.
template <class T>
const T* said(const ByLanguage<T>& texts, const std::string& language) {
    const auto found = texts.find(language);
    if (found != texts.end()) return &found->second;
    return texts.empty() ? nullptr : &texts.begin()->second;
}

void draw_views(PanelTools& tools) {
    const std::vector<LessonView>& views = tools.lesson->views;
    for (std::size_t i = 0; i < views.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const std::string* label = said(views[i].labels, tools.ui.t.language());
        const std::string text =
            label == nullptr || label->empty() ? fmt::format("{}", i + 1) : *label;
        if (ImGui::Selectable((text + "###view").c_str(), tools.editor.lesson_view == i))
            tools.editor.wanted.lesson_view = i;
        tools.ui.mark(fmt::format("lesson.view[{}]", i));
        ImGui::PopID();
    }
}

}  // namespace

void draw_lesson(PanelTools& tools) {
    const LessonText* text = said(tools.lesson->texts, tools.ui.t.language());
    if (text == nullptr) return;
    ImGui::PushTextWrapPos(0.0F);
    heading(text->title.c_str());
    ImGui::TextUnformatted(text->summary.c_str());
    draw_views(tools);
    for (const std::string& note : text->notes) {
        ImGui::Bullet();
        ImGui::TextUnformatted(note.c_str());
    }
    ImGui::PopTextWrapPos();
}

}  // namespace facet::studio
