#pragma once

#include "core/net/service.h"
#include "core/values/timing.h"

#include <QByteArray>
#include <QHostAddress>

namespace gorizont::test {

/// A protocol for tests: each request is ten bytes and gets 45 that repeat its first one. One that begins with `!`
/// breaks the connection, with `?` is answered "no" (`n`, once), with `.` not at all.
inline AnsweredRequests answerToy(QByteArrayView received, AnswerBuffer &answers)
{
    AnsweredRequests done;
    for (; received.size() - done.consumed >= 10; done.consumed += 10) {
        switch (const char first = received.at(done.consumed)) {
        case '!': done.isBroken = true; return done;
        case '.': ++done.unanswered; break;
        case '?':
            ++done.requests;
            ++done.exceptions;
            answers.append('n');
            break;
        default:
            ++done.requests;
            for (int i = 0; i < 45; ++i) {
                answers.append(first);
            }
        }
    }
    return done;
}

inline Service toyService()
{
    Service service;
    service.name = QStringLiteral("Toy TCP");
    service.portKey = QStringLiteral("IPPort9");
    service.answer = answerToy;
    return service;
}

inline QString loopback()
{
    return QStringLiteral("127.0.0.1");
}

} // namespace gorizont::test
