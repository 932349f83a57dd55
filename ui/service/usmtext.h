#pragma once

#include "core/devices/usmisn/usmisnservice.h"

namespace gorizont {

/// What the service window of УСМ-ИСН says. Pure.
namespace usmtext {

QString serial(quint32 serial); ///< `01234567`
QString date(QDate date); ///< `14.04.2017`
QString port(const PortSettings &port); ///< `19200-N-1`
QString time(qint64 timestamp); ///< local

/// `+1.50000° ± 0.00860°, 26.33 °C`, or a sentence why there is no value.
QString value(const Result<usmisn::Value> &value);

/// What a user typed: numbers of up to eight digits with blanks or commas between them. Empty: something else.
QList<quint32> serials(const QString &text);
/// Where a device is; \a found: see Service::find().
QString place(quint32 serial, const Result<int> &found);

/// What became of a change, to stand after `Sensor 7: `.
QString addressOutcome(int from, int to, const Result<void> &changed);
QString portOutcome(const usmisn::PortChange &change, const PortSettings &wanted);
/// Which keys of the ini have to follow.
QString portReminder(const PortSettings &wanted, int portIndex);
QString startOutcome(const Result<void> &started);

} // namespace usmtext

} // namespace gorizont
