// The program's entry: makes the process safe to run in, then hands over; catches what is left.
// SPDX-License-Identifier: MIT
#include "base/text.h"
#include "cli/program.h"

#include <fcntl.h>
#include <sys/auxv.h>
#include <unistd.h>

#include <csignal>
#include <exception>
#include <new>
#include <string>
#include <vector>

namespace {

/// A closed standard stream would let the next file opened take its number, and messages land in a
/// picture. Opened the wrong way round, so that using it still fails.
void hold_standard_streams() {
    for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(fd, F_GETFD) < 0 &&
            ::open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY) != fd)
            std::_Exit(70);
}

int guarded(int argc, char** argv) {
    facet::cli::Io io(stdout, stderr);
    try {
        const std::vector<std::string> arguments(argv + (argc > 0 ? 1 : 0), argv + argc);
        return facet::cli::run_program(arguments, environ, io);
    } catch (const std::bad_alloc&) {
        std::fputs("facet: out of memory; ask for a smaller picture, or allow more memory\n",
                   stderr);
        return static_cast<int>(facet::cli::Exit::limit_reached);
    } catch (const std::exception& error) {
        io.complain(
            {.what = "internal error", .found = error.what(), .remedy = "please report it"});
    } catch (...) {
        io.complain({.what = "internal error", .remedy = "please report it"});
    }
    static_cast<void>(io.finish());
    return static_cast<int>(facet::cli::Exit::internal);
}

}  // namespace

int main(int argc, char** argv) {
    hold_standard_streams();
    std::signal(SIGPIPE,
                SIG_IGN);  // a reader that goes away is an error of one write, not our death
    std::signal(SIGXFSZ, SIG_IGN);  // likewise a limit on the size of files
    if (::getauxval(AT_SECURE) != 0) {
        std::fputs("facet: started setuid or setgid; it uses no privilege: remove the bit\n",
                   stderr);
        return static_cast<int>(facet::cli::Exit::internal);
    }
    return guarded(argc, argv);
}
