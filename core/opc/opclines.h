#pragma once

#include "core/opc/opcimage.h"

#include <QByteArray>

#include <optional>

namespace gorizont {

/// The feed between the program and the gateways of OPC DA, protocol 1: UTF-8, one JSON object a line. Pure.
///
///     → {"hello":"GorizontServer","protocol":1,"version":"…","caption":"…","hash":"…","count":N}
///     → {"tags":[{"name":"…","type":"bool"|"double","description":"…","aliases":["…"]}, …]}      all N in their order
///     → {"ready":true}
///     → {"v":[[index,value,quality,ms], …]}                      all N at once, then what changes
///     → {"ping":true}                                            when nothing else was sent for 2 s
///     → {"end":true}                                             the program ends
///     ← {"client":"gorizont-opc-da","version":"…","pid":N,"registered":"…"}
///
/// hash         opcTagsHash()
/// count        number of tags; index counts from 0
/// aliases      left out where there are none
/// value        true, false, a number, or null: there never was one
/// quality      OpcQuality as a number
/// ms           of the reading, UTC, since 1970
/// registered   the hash of the list that the gateway was registered with; empty: it was not
namespace opclines {

constexpr int mostTags = 200; ///< in a line
constexpr int mostValues = 500; ///< in a line
constexpr qsizetype mostReceived = 4096; ///< bytes of a line of a client

QByteArray hello(const QString &caption, const QList<OpcTag> &tags);
QList<QByteArray> tagLines(const QList<OpcTag> &tags);
QByteArray ready();
QByteArray ping();
QByteArray end();

/// The line of values grows by one entry; endValues() finishes it.
QByteArray beginValues();
void appendValue(QByteArray &line, int index, const OpcSample &sample);
void endValues(QByteArray &line);

/// What a gateway says of itself.
struct Greeting
{
    QString client;
    QString version;
    qint64 pid = 0;
    QByteArray registered;
    bool operator==(const Greeting &) const = default;
};

/// Empty: \a line is none.
std::optional<Greeting> greeting(QByteArrayView line);

} // namespace opclines

} // namespace gorizont
