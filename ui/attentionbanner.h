#pragma once

#include <QFrame>

class QLabel;

namespace gorizont {

/// A strip above the pages, there only while sensors need attention. GUI thread.
class AttentionBanner : public QFrame
{
    Q_OBJECT

public:
    explicit AttentionBanner(QWidget *parent = nullptr);

    void setCount(int sensors);

Q_SIGNALS:
    void listWanted();

private:
    QLabel *m_text;
    int m_count = 0;
};

} // namespace gorizont
