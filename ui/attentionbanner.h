#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace gorizont {

class AlarmWatch;

/// A strip above the pages, there only while messages wait for the dispatcher: it says what is wrong. GUI thread.
class AttentionBanner : public QFrame
{
    Q_OBJECT

public:
    /// \a alarms outlives the banner.
    explicit AttentionBanner(AlarmWatch &alarms, QWidget *parent = nullptr);

Q_SIGNALS:
    void listWanted();

private:
    QPushButton *addButton(const QString &title, const QString &objectName);
    void refresh();

    AlarmWatch &m_alarms;
    QLabel *m_text;
    QList<quint64> m_shown; ///< the messages that the text is about: what came since was not seen
};

} // namespace gorizont
