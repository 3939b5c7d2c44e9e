// Files: whole reads behind a gate, atomic writes.
// SPDX-License-Identifier: MIT
#include "base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include <spdlog/fmt/fmt.h>

namespace facet::base {
namespace {

namespace fs = std::filesystem;

std::string errno_text(int error) { return std::generic_category().message(error); }

class Descriptor {
public:
    explicit Descriptor(int fd) noexcept : fd_(fd) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    [[nodiscard]] int get() const noexcept { return fd_; }

private:
    int fd_;
};

Result<Bytes> read_descriptor(int fd, std::size_t expected_bytes, std::size_t max_bytes,
                              const std::string& file) {
    Bytes bytes(std::min(expected_bytes, max_bytes) + 1);  // one more, to see the end without growing
    std::size_t filled = 0;
    while (true) {
        if (filled == bytes.size()) {
            if (filled > max_bytes)
                return fail({.code = ErrorCode::limit_reached,
                             .file = file,
                             .what = fmt::format("larger than the limit of {} bytes", max_bytes)});
            bytes.resize(std::min(bytes.size() * 2, max_bytes + 1));
        }
        const ssize_t got = ::read(fd, bytes.data() + filled, bytes.size() - filled);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0)
            return fail({.code = ErrorCode::input_invalid, .file = file, .what = errno_text(errno)});
        if (got == 0) break;
        filled += static_cast<std::size_t>(got);
    }
    bytes.resize(filled);
    return bytes;
}

/// Opens without blocking on a FIFO, then takes regular files only.
Result<Bytes> read_regular(const fs::path& path, std::size_t max_bytes) {
    const std::string file = path.string();
    const Descriptor fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    if (fd.get() < 0)
        return fail({.code = ErrorCode::input_invalid, .file = file, .what = errno_text(errno)});
    struct stat status {};
    if (::fstat(fd.get(), &status) != 0)
        return fail({.code = ErrorCode::input_invalid, .file = file, .what = errno_text(errno)});
    if (S_ISDIR(status.st_mode))
        return fail({.code = ErrorCode::input_invalid, .file = file, .what = "is a directory"});
    if (!S_ISREG(status.st_mode))
        return fail({.code = ErrorCode::input_invalid, .file = file, .what = "not a regular file"});
    const auto size = static_cast<std::size_t>(status.st_size);
    if (size > max_bytes)
        return fail({.code = ErrorCode::limit_reached,
                     .file = file,
                     .what = fmt::format("larger than the limit of {} bytes", max_bytes),
                     .found = fmt::format("{} bytes", size)});
    return read_descriptor(fd.get(), size, max_bytes, file);
}

bool is_beneath(const fs::path& path, const fs::path& folder) {
    const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    return end == folder.end() && rest != path.end();
}

Status write_all(int fd, std::span<const std::byte> bytes, const std::string& file) {
    while (!bytes.empty()) {
        const ssize_t put = ::write(fd, bytes.data(), bytes.size());
        if (put < 0 && errno == EINTR) continue;
        if (put < 0)
            return fail({.code = errno == EIO ? ErrorCode::input_invalid : ErrorCode::temporary,
                         .file = file,
                         .what = "cannot write: " + errno_text(errno),
                         .found = fmt::format("{} bytes were left", bytes.size()),
                         .remedy = "free some space or choose another folder"});
        bytes = bytes.subspan(static_cast<std::size_t>(put));
    }
    return {};
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// `.NAME.PID.tmp` beside the target; a long name is cut so that the whole stays within NAME_MAX.
fs::path temporary_beside(const fs::path& path) {
    const std::string name = path.filename().string().substr(0, 200);
    return folder_of(path) / fmt::format(".{}.{}.tmp", name, ::getpid());
}

}  // namespace

Result<Bytes> read_file(const fs::path& path, std::size_t max_bytes) {
    return read_regular(path, max_bytes);
}

Result<Bytes> read_file_beneath(const fs::path& folder, std::string_view relative,
                                std::span<const fs::path> allowed, std::size_t max_bytes) {
    const auto refuse = [&](std::string_view what, std::string_view remedy) {
        return fail({.code = ErrorCode::input_invalid,
                     .what = std::string(what),
                     .found = std::string(relative),
                     .remedy = std::string(remedy)});
    };
    if (relative.empty() || relative.find('\0') != std::string_view::npos)
        return refuse("not a file name", "");
    std::error_code error;
    const fs::path root = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
    if (error) return refuse("no such folder", "");
    const fs::path resolved = fs::weakly_canonical(root / fs::path(relative), error);
    if (error) return refuse("cannot be resolved: " + error.message(), "");
    bool inside = is_beneath(resolved, root);
    for (const fs::path& other : allowed)
        inside = inside || is_beneath(resolved, fs::weakly_canonical(other, error));
    if (!inside)
        return refuse("outside the model's folder", "--allow-read DIR if it may be read");
    if (!fs::exists(resolved, error)) return refuse("no such file", "");
    // Resolved of all links: a link put there between the two calls is refused by O_NOFOLLOW's twin below.
    const Descriptor probe(::open(resolved.c_str(), O_PATH | O_NOFOLLOW | O_CLOEXEC));
    struct stat status {};
    if (probe.get() < 0 || ::fstat(probe.get(), &status) != 0 || S_ISLNK(status.st_mode))
        return refuse("not a regular file", "");
    return read_regular(resolved, max_bytes);
}

Result<Bytes> read_stdin(std::size_t max_bytes) {
    return read_descriptor(STDIN_FILENO, 1 << 20, max_bytes, "-");
}

Status check_writable(const fs::path& path) {
    std::error_code error;
    const fs::path folder = folder_of(path);
    if (!fs::is_directory(folder, error))
        return fail({.code = ErrorCode::usage,
                     .file = path.string(),
                     .what = "no such folder",
                     .found = folder.string(),
                     .remedy = "make it, or give --mkdirs"});
    if (fs::is_directory(path, error))
        return fail({.code = ErrorCode::input_invalid, .file = path.string(), .what = "is a directory"});
    if (path.filename().string().size() > 255)
        return fail({.code = ErrorCode::input_invalid,
                     .file = path.string(),
                     .what = fmt::format("name too long ({} bytes)", path.filename().string().size())});
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        return fail({.code = ErrorCode::input_invalid,
                     .file = path.string(),
                     .what = "the folder cannot be written: " + errno_text(errno)});
    return {};
}

Status write_file_atomically(const fs::path& path, std::span<const std::byte> bytes) {
    const std::string file = path.string();
    const fs::path temporary = temporary_beside(path);
    const auto drop = [&](Error error) {
        ::unlink(temporary.c_str());
        return fail(std::move(error));
    };
    {
        const Descriptor fd(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
        if (fd.get() < 0)
            return fail({.code = errno == ENOSPC || errno == EDQUOT ? ErrorCode::temporary
                                                                    : ErrorCode::input_invalid,
                         .file = file,
                         .what = "cannot write: " + errno_text(errno)});
        if (auto written = write_all(fd.get(), bytes, file); !written) return drop(written.error());
        if (::fsync(fd.get()) != 0 && errno != EINVAL)
            return drop({.code = ErrorCode::temporary, .file = file, .what = errno_text(errno)});
    }
    if (::rename(temporary.c_str(), path.c_str()) != 0)
        return drop({.code = ErrorCode::temporary, .file = file, .what = errno_text(errno)});
    const Descriptor folder(::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder.get() >= 0) ::fsync(folder.get());  // the rename itself; not every file system has it
    return {};
}

}  // namespace facet::base
