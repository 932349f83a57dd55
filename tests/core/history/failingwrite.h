#pragma once

#include <QString>

namespace gorizont::test {

/// While it lives, files whose name ends with \a suffix take \a bytes more, as if the disk were full after them. It
/// stands in for the write() of the C library in the program that lists failingwrite.cpp among its sources.
class FailingWrite
{
public:
    FailingWrite(const QString &suffix, qint64 bytes);
    ~FailingWrite();
    Q_DISABLE_COPY_MOVE(FailingWrite)
};

} // namespace gorizont::test
