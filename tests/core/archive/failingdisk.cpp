#include "tests/core/archive/failingdisk.h"

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

using gorizont::test::DiskCall;

DiskCall failingCall = DiskCall::Write;
int callsLeft = 0; // 0: nothing fails
bool didFail = false;
bool isDiskFull = false;

bool isArchive(const char *path)
{
    return std::strstr(path, "archive.sqlite") != nullptr || std::strstr(path, "archive.spool") != nullptr;
}

bool isArchive(int descriptor)
{
    char link[64];
    char path[4096];
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
    const ssize_t length = ::readlink(link, path, sizeof path - 1);
    path[length > 0 ? length : 0] = '\0';
    return isArchive(path);
}

template <typename File> bool fails(DiskCall call, File file)
{
    if (callsLeft == 0 || call != failingCall || !isArchive(file) || --callsLeft > 0) {
        return false;
    }
    didFail = true;
    errno = call == DiskCall::Write || call == DiskCall::Truncate ? ENOSPC : EIO;
    return true;
}

bool isBeyondEnd(int descriptor, size_t count, off_t offset)
{
    struct stat state
    {
    };
    return isDiskFull && isArchive(descriptor) && ::fstat(descriptor, &state) == 0
        && offset + static_cast<off_t>(count) > state.st_size;
}

} // namespace

extern "C" {

ssize_t pwrite64(int descriptor, const void *bytes, size_t count, off_t offset)
{
    if (fails(DiskCall::Write, descriptor)) {
        return -1;
    }
    if (isBeyondEnd(descriptor, count, offset)) {
        errno = ENOSPC;
        return -1;
    }
    return ::syscall(SYS_pwrite64, descriptor, bytes, count, offset);
}

ssize_t pwrite(int descriptor, const void *bytes, size_t count, off_t offset)
{
    return pwrite64(descriptor, bytes, count, offset);
}

ssize_t write(int descriptor, const void *bytes, size_t count)
{
    return fails(DiskCall::Write, descriptor) ? -1 : ::syscall(SYS_write, descriptor, bytes, count);
}

ssize_t read(int descriptor, void *bytes, size_t count)
{
    return fails(DiskCall::Read, descriptor) ? -1 : ::syscall(SYS_read, descriptor, bytes, count);
}

int fdatasync(int descriptor)
{
    return fails(DiskCall::Sync, descriptor) ? -1 : 0;
}

int fsync(int descriptor)
{
    return fails(DiskCall::Sync, descriptor) ? -1 : 0;
}

int ftruncate64(int descriptor, off_t length) noexcept
{
    return fails(DiskCall::Truncate, descriptor) ? -1 : static_cast<int>(::syscall(SYS_ftruncate, descriptor, length));
}

int open64(const char *path, int flags, ...)
{
    std::va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = flags & O_CREAT ? va_arg(arguments, mode_t) : 0;
    va_end(arguments);
    return fails(DiskCall::Open, path) ? -1 : static_cast<int>(::syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}

int rename(const char *from, const char *to) noexcept
{
    return fails(DiskCall::Rename, from) ? -1 : static_cast<int>(::syscall(SYS_rename, from, to));
}

/// What QFile::rename() calls.
int renameat2(int fromFolder, const char *from, int toFolder, const char *to, unsigned flags) noexcept
{
    return fails(DiskCall::Rename, from)
        ? -1
        : static_cast<int>(::syscall(SYS_renameat2, fromFolder, from, toFolder, to, flags));
}
}

namespace gorizont::test {

FailingDisk::FailingDisk(DiskCall call, int nth)
{
    failingCall = call;
    callsLeft = nth;
    didFail = false;
}

FailingDisk::~FailingDisk()
{
    callsLeft = 0;
}

bool FailingDisk::hasFailed() const
{
    return didFail;
}

void fillDisk(bool isFull)
{
    isDiskFull = isFull;
}

} // namespace gorizont::test
