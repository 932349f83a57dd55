#include "core/modbus/markdowntable.h"

namespace gorizont {

QString markdownEscaped(const QString &text)
{
    static const QString signs = QStringLiteral("\\`*_[]<>|#&~");
    QString escaped;
    for (const QChar c : text) {
        if (signs.contains(c)) {
            escaped += QLatin1Char('\\');
        }
        escaped += c;
    }
    return escaped;
}

MarkdownTable::MarkdownTable(const QStringList &titles)
{
    add(titles);
    add(QStringList(titles.size(), QStringLiteral("---")));
}

void MarkdownTable::add(const QStringList &cells)
{
    m_text += QLatin1String("| ") + cells.join(QLatin1String(" | ")) + QLatin1String(" |\n");
}

} // namespace gorizont
