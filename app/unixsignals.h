#pragma once

#include <QObject>

class QSocketNotifier;

namespace gorizont {

/// SIGINT and SIGTERM as a Qt signal in the main thread. One object a program. Does nothing where there are no such signals.
class UnixSignals : public QObject
{
    Q_OBJECT

public:
    explicit UnixSignals(QObject *parent = nullptr);
    ~UnixSignals() override;

Q_SIGNALS:
    void terminated();

private:
    QSocketNotifier *m_notifier = nullptr;
};

} // namespace gorizont
