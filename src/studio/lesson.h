// What a lesson shows in the studio: a text, and views that a click goes to.
// SPDX-License-Identifier: MIT
#pragma once

#include "studio/document.h"

#include <map>
#include <string>
#include <vector>

namespace facet::studio {

/// By language.
template <class T>
using ByLanguage = std::map<std::string, T, std::less<>>;

struct LessonText {
    std::string title;
    std::string summary;
    std::vector<std::string> notes;  ///< what to notice
};

struct LessonView {
    ByLanguage<std::string> labels;
    Document document;
    std::string show = "beauty";  ///< a key of views()
};

struct StudioLesson {
    ByLanguage<LessonText> texts;
    std::vector<LessonView> views;
};

}  // namespace facet::studio
