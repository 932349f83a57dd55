#include "tests/core/history/failingwrite.h"

#include <QFile>

#include <cerrno>

#include <sys/syscall.h>
#include <unistd.h>

namespace {

QString failingSuffix; // empty: nothing fails
qint64 bytesLeft = 0;

bool isFailing(int descriptor)
{
    return !failingSuffix.isEmpty()
        && QFile::symLinkTarget(QStringLiteral("/proc/self/fd/%1").arg(descriptor)).endsWith(failingSuffix);
}

} // namespace

extern "C" ssize_t write(int descriptor, const void *bytes, size_t count)
{
    if (isFailing(descriptor)) {
        if (bytesLeft == 0) {
            errno = ENOSPC;
            return -1;
        }
        count = std::min(count, static_cast<size_t>(bytesLeft));
        bytesLeft -= static_cast<qint64>(count);
    }
    return ::syscall(SYS_write, descriptor, bytes, count);
}

namespace gorizont::test {

FailingWrite::FailingWrite(const QString &suffix, qint64 bytes)
{
    failingSuffix = suffix;
    bytesLeft = bytes;
}

FailingWrite::~FailingWrite()
{
    failingSuffix.clear();
}

} // namespace gorizont::test
