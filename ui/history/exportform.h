#pragma once

#include "core/export/exportrequest.h"

#include <QWidget>

class QComboBox;
class QDateTimeEdit;
class QGroupBox;
class QLineEdit;

namespace gorizont {

class CheckList;

/// What to export, to fill in. GUI thread.
class ExportForm : public QWidget
{
    Q_OBJECT

public:
    /// What the form begins with.
    struct Start
    {
        QList<SensorConfig> sensors; ///< all that there are
        QList<int> chosen; ///< N
        QDate first; ///< local
        QDate last; ///< the range ends with this day
        QString station; ///< code of miniSEED
    };

    explicit ExportForm(const Start &start, QWidget *parent = nullptr);

    ExportRequest request() const;
    QString path() const;
    void setPath(const QString &path);

private:
    void addRange(const Start &start);
    void addChoices(const Start &start);
    void build();
    void follow();
    void browse();
    QLineEdit *codeField(const char *name, const QString &code, int length);
    ExportFormat format() const;

    const QList<SensorConfig> m_all;
    QDateTimeEdit *m_from;
    QDateTimeEdit *m_to;
    QComboBox *m_format;
    QComboBox *m_every;
    CheckList *m_sensors;
    CheckList *m_quantities;
    QGroupBox *m_codes;
    QLineEdit *m_network;
    QLineEdit *m_station;
    QLineEdit *m_channelX;
    QLineEdit *m_channelY;
    QLineEdit *m_path;
};

} // namespace gorizont
