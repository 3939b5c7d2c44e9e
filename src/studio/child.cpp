// Another run of this program beside it.
// SPDX-License-Identifier: MIT
#include "studio/child.h"

#include "base/text.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

extern char** environ;

namespace facet::studio {
namespace {

constexpr std::size_t most_said = 65536;

std::string last_line(const std::string& text) {
    std::string last;
    for (const std::string_view line : base::split(text, '\n'))
        if (!base::trimmed(line).empty()) last = base::trimmed(line);
    return last;
}

}  // namespace

base::Result<Child> Child::start(const std::vector<std::string>& arguments) {
    const auto failed = [](const char* what) {
        return base::fail({.code = base::ErrorCode::temporary,
                           .what = what,
                           .found = std::strerror(errno),
                           .remedy = "close other programs and try again"});
    };
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return failed("no pipe to the renderer");
    std::vector<std::string> words = {"facet"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&files, ends[1], STDERR_FILENO);
    pid_t pid = -1;
    const int error =
        ::posix_spawn(&pid, "/proc/self/exe", &files, nullptr, pointers.data(), environ);
    ::posix_spawn_file_actions_destroy(&files);
    ::close(ends[1]);
    if (error != 0) {
        ::close(ends[0]);
        errno = error;
        return failed("the renderer does not start");
    }
    ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
    return Child(pid, ends[0]);
}

Child::Child(Child&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      pipe_(std::exchange(other.pipe_, -1)),
      said_(std::move(other.said_)) {}
Child& Child::operator=(Child&& other) noexcept {
    std::swap(pid_, other.pid_);
    std::swap(pipe_, other.pipe_);
    std::swap(said_, other.said_);
    return *this;
}
Child::~Child() {
    if (pid_ > 0) {
        ::kill(pid_, SIGTERM);
        ::waitpid(pid_, nullptr, 0);
    }
    if (pipe_ >= 0) ::close(pipe_);
}

void Child::read() {
    std::array<char, 4096> text{};
    ssize_t count = 0;
    while ((count = ::read(pipe_, text.data(), text.size())) > 0)
        if (said_.size() < most_said) said_.append(text.data(), static_cast<std::size_t>(count));
}

std::optional<ChildEnd> Child::poll() {
    if (pid_ <= 0) return std::nullopt;
    read();
    int status = 0;
    if (::waitpid(pid_, &status, WNOHANG) != pid_) return std::nullopt;
    pid_ = -1;
    read();
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return ChildEnd{code, last_line(said_)};
}

}  // namespace facet::studio
