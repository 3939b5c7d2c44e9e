// Files: whole reads behind a gate, atomic writes.
// SPDX-License-Identifier: MIT
#include "base/file.h"

#include <fcntl.h>
#include <linux/openat2.h>
#include <spdlog/fmt/fmt.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstring>
#include <system_error>

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
    Bytes bytes(std::min(expected_bytes, max_bytes) +
                1);  // one more, to see the end without growing
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
            return fail(
                {.code = ErrorCode::input_invalid, .file = file, .what = errno_text(errno)});
        if (got == 0) break;
        filled += static_cast<std::size_t>(got);
    }
    bytes.resize(filled);
    return bytes;
}

/// Opened so, nothing blocks: not a FIFO without a writer, not a terminal.
constexpr int read_flags = O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY;

/// The contents of an open file; regular files only. `fd` is checked here: below 0, errno tells
/// why.
Result<Bytes> read_regular(const Descriptor& fd, const std::string& file, std::size_t max_bytes) {
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

/// Opens a path that has been resolved of all links; a link put into it since then is refused
/// (ELOOP).
int open_without_links(const fs::path& resolved) {
    open_how how{};
    how.flags = read_flags;
    how.resolve = RESOLVE_NO_SYMLINKS | RESOLVE_NO_MAGICLINKS;
    const long fd = ::syscall(SYS_openat2, AT_FDCWD, resolved.c_str(), &how, sizeof how);
    if (fd >= 0 || (errno != ENOSYS && errno != EPERM)) return static_cast<int>(fd);
    return ::open(resolved.c_str(), read_flags | O_NOFOLLOW);  // kernels before 5.6, some sandboxes
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

tl::unexpected<Error> refused(const fs::path& path, std::string what, std::string found = "") {
    return fail({.code = ErrorCode::input_invalid,
                 .file = path.string(),
                 .what = std::move(what),
                 .found = std::move(found)});
}

tl::unexpected<Error> cannot_write(const std::string& file, int error) {
    const bool later = error == ENOSPC || error == EDQUOT || error == EMFILE || error == ENFILE;
    return fail({.code = later ? ErrorCode::temporary : ErrorCode::input_invalid,
                 .file = file,
                 .what = "cannot write: " + errno_text(error)});
}

/// The file that writing to `path` replaces: itself, or what it links to within its own folder.
Result<fs::path> target_of(const fs::path& path) {
    const std::string name = path.filename().string();
    if (name.empty()) return refused(path, "is a directory");
    if (name.size() > NAME_MAX)
        return refused(path, fmt::format("name too long ({} bytes)", name.size()));
    std::error_code error;
    const fs::path folder = fs::canonical(folder_of(path), error);
    if (error && error != std::errc::no_such_file_or_directory)
        return refused(path, "the folder cannot be used: " + error.message(),
                       folder_of(path).string());
    if (!fs::is_directory(folder, error))
        return fail({.code = ErrorCode::usage,
                     .file = path.string(),
                     .what = "no such folder",
                     .found = folder_of(path).string(),
                     .remedy = "make it, or give --mkdirs"});
    fs::path target = path;
    if (fs::is_symlink(path, error)) {
        target = fs::weakly_canonical(path, error);
        if (error || target.parent_path() != folder)
            return refused(path, "is a link that leaves its folder", target.string());
    }
    const fs::file_status status = fs::status(target, error);
    if (fs::is_directory(status)) return refused(path, "is a directory");
    if (fs::exists(status) && !fs::is_regular_file(status))
        return refused(path, "not a regular file");
    return target;
}

/// A file without a name in `folder`: were we killed, nothing of it would stay. -1 where the file
/// system has none (NFS, some overlays) or /proc is not there to name it by.
int open_nameless(const fs::path& folder) {
    if (::access("/proc/self/fd", X_OK) != 0) return -1;
    return ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
}

/// Names it; over a name that a process of the same number once left behind.
bool give_name(int fd, const fs::path& name) {
    const std::string self = fmt::format("/proc/self/fd/{}", fd);
    const auto link = [&] {
        return ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
    };
    return link() || (errno == EEXIST && ::unlink(name.c_str()) == 0 && link());
}

Status write_and_sync(int fd, std::span<const std::byte> bytes, const std::string& file,
                      Sync sync) {
    if (auto written = write_all(fd, bytes, file); !written) return written;
    if (sync == Sync::yes && ::fsync(fd) != 0 && errno != EINVAL)
        return fail({.code = ErrorCode::temporary, .file = file, .what = errno_text(errno)});
    return {};
}

}  // namespace

bool is_beneath(const fs::path& path, const fs::path& folder) {
    if (folder.empty()) return false;  // it could not be resolved; everything would be in it
    const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    return end == folder.end() && rest != path.end();
}

Result<Bytes> read_file(const fs::path& path, std::size_t max_bytes) {
    const Descriptor fd(::open(path.c_str(), read_flags));
    return read_regular(fd, path.string(), max_bytes);
}

Result<std::string> read_text_file(const std::filesystem::path& path, std::size_t max_bytes) {
    const auto bytes = read_file(path, max_bytes);
    if (!bytes) return tl::unexpected(in_file(bytes.error(), path.string()));
    return std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size());
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
    if (!inside) return refuse("outside the model's folder", "--allow-read DIR if it may be read");
    if (!fs::exists(resolved, error)) return refuse("no such file", "");
    const Descriptor fd(open_without_links(resolved));
    return read_regular(fd, resolved.string(), max_bytes);
}

Result<Bytes> read_stdin(std::size_t max_bytes) {
    return read_descriptor(STDIN_FILENO, 1 << 20, max_bytes, "-");
}

Status check_writable(const fs::path& path) {
    if (auto target = target_of(path); !target) return tl::unexpected(target.error());
    const fs::path folder = folder_of(path);
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        return refused(path, "the folder cannot be written: " + errno_text(errno));
    return {};
}

Status write_file_atomically(const fs::path& path, std::span<const std::byte> bytes, Sync sync) {
    const auto target = target_of(path);
    if (!target) return tl::unexpected(target.error());
    const std::string file = path.string();
    const fs::path temporary = temporary_beside(*target);
    {
        const Descriptor fd(open_nameless(folder_of(*target)));
        if (fd.get() >= 0) {
            if (auto written = write_and_sync(fd.get(), bytes, file, sync); !written)
                return written;
            if (!give_name(fd.get(), temporary)) return cannot_write(file, errno);
        } else {
            const Descriptor named(::open(
                temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666));
            if (named.get() < 0) return cannot_write(file, errno);
            if (auto written = write_and_sync(named.get(), bytes, file, sync); !written) {
                ::unlink(temporary.c_str());
                return written;
            }
        }
    }
    if (::rename(temporary.c_str(), target->c_str()) != 0) {
        const int error = errno;
        ::unlink(temporary.c_str());
        return fail({.code = ErrorCode::temporary, .file = file, .what = errno_text(error)});
    }
    if (sync == Sync::no) return {};
    const Descriptor folder(::open(folder_of(*target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder.get() >= 0)
        ::fsync(folder.get());  // the rename itself; not every file system has it
    return {};
}

}  // namespace facet::base
