#include "core/station/fieldsequence.h"

namespace gorizont::station {

QList<Record> valuesOf(const QList<Record> &records, qsizetype count)
{
    QList<Record> values;
    for (const Record &record : records) {
        const qsizetype used = records.size() >= count ? 1 : record.fields.size();
        for (qsizetype i = 0; i < used; ++i) {
            values.append({record.line, {record.fields.at(i)}, i, record.isQuoteOpen && i + 1 == record.fields.size()});
        }
    }
    return values;
}

} // namespace gorizont::station
