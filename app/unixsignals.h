#pragma once

#include <QObject>

class QSocketNotifier;

namespace gorizont {

/// SIGINT and SIGTERM, and SIGHUP when it is wanted, as Qt signals in the main thread. One object a program. Does nothing where there are no such signals.
class UnixSignals : public QObject
{
    Q_OBJECT

public:
    explicit UnixSignals(QObject *parent = nullptr);
    ~UnixSignals() override;

    /// From now on SIGHUP is a wish to read the files again; without this call it ends the program as usual.
    void catchHangup();

Q_SIGNALS:
    void terminated();
    void hungUp();

private:
    QSocketNotifier *m_notifier = nullptr;
};

} // namespace gorizont
