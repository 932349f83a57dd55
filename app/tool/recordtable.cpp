#include "app/tool/recordtable.h"

#include "app/tool/text.h"

namespace gorizont::tool {

using namespace usmisn;

QString RecordTable::open(const QString &path)
{
    if (!m_file.open(path, AppendFile::Mode::Continue)) {
        return m_file.error();
    }
    const QString problem = m_file.size() > 0 ? readBack() : m_file.append(csv::header()) ? QString() : m_file.error();
    if (!problem.isEmpty()) {
        m_file.close();
    }
    return problem;
}

/// A line that a kill left unfinished is cut off.
QString RecordTable::readBack()
{
    const QByteArray bytes = m_file.read(0, m_file.size());
    const qsizetype whole = bytes.lastIndexOf('\n') + 1;
    if (!bytes.startsWith(csv::header())) {
        return Text::tr("%1 is not a table of records; name another file").arg(m_file.path());
    }
    for (qsizetype at = csv::header().size(); at < whole;) {
        const qsizetype end = bytes.indexOf('\n', at) + 1;
        const auto record = csv::parse(bytes.sliced(at, end - at));
        if (!record) {
            return Text::tr("%1 is not a table of records; name another file").arg(m_file.path());
        }
        m_book.add(*record);
        at = end;
    }
    return whole == bytes.size() || m_file.cut(whole) ? QString() : m_file.error();
}

bool RecordTable::add(const Value &record)
{
    return !m_book.add(record) || m_file.append(csv::line(record));
}

} // namespace gorizont::tool
