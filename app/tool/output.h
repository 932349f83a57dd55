#pragma once

#include <QJsonObject>
#include <QStringList>

namespace gorizont::tool {

/// One line of text or of JSON on stdout, at once: whoever reads the pipe is not kept waiting.
void print(const QString &line);
void print(const QJsonObject &object);

/// One sentence on stderr.
void complain(const QString &sentence);

inline const QString none = QStringLiteral("—"); ///< what is not there

QString fixed(double value, int decimals); ///< with a point

/// Keys that are always there, whether their values are known or not.
void insertNulls(QJsonObject &object, const QStringList &keys);

/// Now, UTC, ISO 8601 with milliseconds.
QString timestamp();

} // namespace gorizont::tool
