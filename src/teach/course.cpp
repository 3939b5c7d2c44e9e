// All the pages of a course into a folder.
// SPDX-License-Identifier: MIT
#include "teach/course.h"

#include "base/file.h"
#include "base/resources.h"
#include "base/text.h"
#include "base/texts.h"
#include "teach/page.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <span>
#include <utility>

namespace facet::teach {
namespace {

namespace fs = std::filesystem;
using base::ErrorCode;

base::Result<std::vector<Lesson>> chosen(const std::vector<std::string>& names) {
    if (names.empty()) return all_lessons();
    std::vector<Lesson> lessons;
    for (const std::string& name : names) {
        auto lesson = find_lesson(name);
        if (!lesson) return tl::unexpected(lesson.error());
        if (std::ranges::find(lessons, lesson->name, &Lesson::name) != lessons.end())
            return base::fail({.code = ErrorCode::usage,
                               .what = "two lessons of one name would be one page",
                               .found = lesson->name});
        lessons.push_back(std::move(*lesson));
    }
    return lessons;
}

base::Status check_folder(const fs::path& folder, bool force) {
    std::error_code error;
    const fs::path parent = fs::absolute(folder / "x").parent_path().parent_path();
    if (!fs::exists(folder, error)) {
        if (fs::is_directory(parent, error)) return {};
        return base::fail({.code = ErrorCode::usage,
                           .file = folder.string(),
                           .what = "no such folder",
                           .found = parent.string(),
                           .remedy = "make it first"});
    }
    if (!fs::is_directory(folder, error))
        return base::fail(
            {.code = ErrorCode::usage, .file = folder.string(), .what = "is not a folder"});
    if (force || fs::is_empty(folder, error)) return {};
    return base::fail(
        {.code = ErrorCode::usage,
         .file = folder.string(),
         .what = "the folder is not empty",
         .remedy = "--force replaces pages in it and keeps the rest, or name another"});
}

base::Status write(const fs::path& path, const std::string& text) {
    return base::write_file_atomically(path, std::as_bytes(std::span(text)));
}

base::Status make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directory(folder, error);
    if (!error) return {};
    return base::fail({.code = ErrorCode::input_invalid,
                       .file = folder.string(),
                       .what = "the folder cannot be made",
                       .found = error.message()});
}

}  // namespace

base::Result<Course> make_course(const CourseRequest& request, base::Log& log,
                                 const base::Progress& progress) {
    const auto texts = base::Texts::load(request.language);
    if (!texts) return tl::unexpected(texts.error());
    const auto lessons = chosen(request.lessons);
    if (!lessons) return tl::unexpected(lessons.error());
    if (auto s = check_folder(request.output, request.force); !s) return tl::unexpected(s.error());
    Gallery gallery(log);
    auto maker = PageMaker::create(*texts, gallery);
    if (!maker) return tl::unexpected(maker.error());
    std::vector<std::pair<std::string, std::string>> pages;
    for (std::size_t i = 0; i < lessons->size(); ++i) {
        const auto link = [&](std::size_t k) -> PageLink {
            if (k >= lessons->size()) return {};
            return {(*lessons)[k].name + ".html", (*lessons)[k].title(request.language)};
        };
        auto page = maker->lesson_page((*lessons)[i], {link(i - 1), link(i + 1)});
        if (!page) return tl::unexpected(page.error());
        pages.emplace_back((*lessons)[i].name + ".html", std::move(*page));
        if (progress)
            progress(static_cast<double>(i + 1) / static_cast<double>(lessons->size()),
                     fmt::format("{} of {} lessons", i + 1, lessons->size()));
    }
    auto index = maker->index_page(*lessons);
    if (!index) return tl::unexpected(index.error());
    pages.emplace_back("index.html", std::move(*index));
    Course course{.index = request.output / "index.html", .lesson_count = lessons->size()};
    if (auto s = make_folder(request.output); !s) return tl::unexpected(s.error());
    for (const auto& [name, page] : pages) {
        if (auto s = write(request.output / name, page); !s) return tl::unexpected(s.error());
        course.bytes += page.size();
    }
    return course;
}

base::Status make_skeleton(const fs::path& folder) {
    const std::string name = fs::absolute(folder / "x").parent_path().filename().string();
    const bool is_plain = !name.empty() && std::ranges::all_of(name, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    });
    if (!is_plain || name == "index")
        return base::fail({.code = ErrorCode::usage,
                           .file = "--new",
                           .what = "a lesson's name is of small letters, digits and dashes",
                           .found = name});
    std::error_code error;
    if (fs::exists(folder, error))
        return base::fail(
            {.code = ErrorCode::usage, .file = folder.string(), .what = "is there already"});
    const auto data = base::data_folder();
    if (!data) return tl::unexpected(data.error());
    std::vector<std::pair<std::string, base::Bytes>> files;
    for (const char* file : {"lesson.json", "en.md", "ru.md"}) {
        auto bytes =
            base::read_file(*data / "resources" / "teach" / "skeleton" / file, most_file_bytes);
        if (!bytes) return tl::unexpected(bytes.error());
        files.emplace_back(file, std::move(*bytes));
    }
    if (auto s = make_folder(folder); !s) return s;
    for (const auto& [file, bytes] : files)
        if (auto s = base::write_file_atomically(folder / file, bytes); !s) return s;
    return {};
}

}  // namespace facet::teach
