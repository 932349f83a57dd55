#pragma once

#include <QStringList>

namespace gorizont {

/// Text of a user as it is, whatever signs of Markdown it holds.
QString markdownEscaped(const QString &text);

/// A table of Markdown, row by row. What is put in must be Markdown already.
class MarkdownTable
{
public:
    explicit MarkdownTable(const QStringList &titles);

    void add(const QStringList &cells);
    /// With an empty line after it.
    QString text() const { return m_text + QLatin1Char('\n'); }

private:
    QString m_text;
};

} // namespace gorizont
