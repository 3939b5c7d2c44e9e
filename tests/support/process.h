// Runs a program as a user would, with its streams caught and a time limit.
// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace facet::support {

/// How a program is run.
struct RunOptions {
    std::vector<std::string> environment = {};  ///< NAME=value, on top of the test's own
    std::filesystem::path folder = "/";         ///< the working directory
    std::string input = {};                     ///< on standard input, at most 64 KiB
    std::string before = {};  ///< shell code that runs first, such as `ulimit -f 0`
};

/// What it did. `exit` is 128 + N for a program that signal N ended.
struct Ran {
    int exit = -1;
    std::string out;
    std::string err;
};

namespace detail {

/// Reads both streams to their ends, so that neither can fill and block the program.
inline void drain(int out, int err, Ran& ran) {
    pollfd streams[] = {{out, POLLIN, 0}, {err, POLLIN, 0}};
    std::string* texts[] = {&ran.out, &ran.err};
    int open_count = 2;
    while (open_count > 0 && ::poll(streams, 2, 60'000) > 0) {
        for (int i = 0; i < 2; ++i) {
            if (streams[i].fd < 0 || streams[i].revents == 0) continue;
            char buffer[65536];
            const ssize_t got = ::read(streams[i].fd, buffer, sizeof buffer);
            if (got > 0) {
                texts[i]->append(buffer, static_cast<std::size_t>(got));
            } else {
                streams[i].fd = -1;
                --open_count;
            }
        }
    }
}

[[noreturn]] inline void become(const std::vector<std::string>& command,
                                const RunOptions& options) {
    std::vector<std::string> words = command;
    if (!options.before.empty())
        words.insert(words.begin(), {"/bin/sh", "-c", options.before + "; exec \"$@\"", "sh"});
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    // Not the caches of whoever runs the tests.
    ::setenv("XDG_CACHE_HOME", FACET_BINARY_DIR "/test-cache", 1);
    for (const std::string& variable : options.environment) {
        const std::size_t equals = variable.find('=');
        ::setenv(variable.substr(0, equals).c_str(), variable.substr(equals + 1).c_str(), 1);
    }
    ::alarm(120);  // a program that hangs fails its test and not the run
    if (::chdir(options.folder.c_str()) == 0) ::execv(arguments[0], arguments.data());
    ::_exit(127);
}

}  // namespace detail

/// Runs `command` (a path and its arguments) to its end.
inline Ran run(const std::vector<std::string>& command, const RunOptions& options = {}) {
    int in[2];
    int out[2];
    int err[2];
    if (::pipe2(in, O_CLOEXEC) != 0 || ::pipe2(out, O_CLOEXEC) != 0 || ::pipe2(err, O_CLOEXEC) != 0)
        return {};
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(in[0], STDIN_FILENO);
        ::dup2(out[1], STDOUT_FILENO);
        ::dup2(err[1], STDERR_FILENO);
        detail::become(command, options);
    }
    for (const int end : {in[0], out[1], err[1]}) ::close(end);
    if (!options.input.empty())
        static_cast<void>(!::write(in[1], options.input.data(), options.input.size()));
    ::close(in[1]);
    Ran ran;
    detail::drain(out[0], err[0], ran);
    for (const int end : {out[0], err[0]}) ::close(end);
    int status = 0;
    ::waitpid(child, &status, 0);
    ran.exit = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return ran;
}

/// Runs the built program.
inline Ran facet(std::vector<std::string> arguments, const RunOptions& options = {}) {
    arguments.insert(arguments.begin(), FACET_BINARY_DIR "/facet");
    return run(arguments, options);
}

inline std::size_t line_count(std::string_view text) {
    std::size_t lines = 0;
    for (const char c : text) lines += c == '\n' ? 1 : 0;
    return lines;
}

/// The words of a small and quick `facet render`.
inline std::vector<std::string> draft_render(const std::string& scene, const std::string& output,
                                             std::vector<std::string> more) {
    std::vector<std::string> all{"render",    scene,   "--size", "48x32",
                                 "--quality", "draft", "-o",     output};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace facet::support
