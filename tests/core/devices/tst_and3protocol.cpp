#include "core/devices/and3/and3protocol.h"
#include "core/protocol/checksums.h"
#include "tests/core/devices/and3frames.h"
#include "tests/support/fakeline.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::and3;
using namespace gorizont::test;

namespace {

/// tilt −3599.5″ +2720.5″, 21.38 °C, 42 s⁻¹, 5.2 %, 183301 samples
const QByteArray complexRead1 = hex("01 C9 84 8F 04 55 E1 14 50 01 34 00 0F 24 05 CC 02 00 00 CC CF DE");
const QByteArray complexRead2 = hex("02 C9 08 00 F8 FF FA 00 00 00 00 00 0F 24 60 00 00 00 00 CC C2 78");
const QByteArray firmware1 = hex("01 24 0C 03 02 00 02 BA");
const QByteArray configuration1 =
    hex("01 DD 10 20 30 40 01 07 06 07 08 09 0A 0B 0C 0D 0E 0F 10 11 12 13 14 15 16 17 18 "
        "19 1A 1B 1C 1D 1E 1F AC C4");

struct Exchanged
{
    const char *name;
    Request request;
    QByteArray answer;
};

/// A good answer to every operation.
QList<Exchanged> exchanges()
{
    return {
        {"36", Request::information(1, InformationKind::Firmware), firmware1},
        {"50", Request::mode(1, ModeBit::RebootAcknowledged, true), hex("01 32 2F 38")},
        {"99 without data", Request::reset(1), hex("01 63 FB 72")},
        {"99 with 2 bytes", Request::reset(1), hex("01 63 00 00 4F 30")},
        {"201", Request::complexRead(1), complexRead1},
        {"201 of sensor 2", Request::complexRead(2), complexRead2},
        {"203, one", Request::packets(1, 0, 1), packetsAnswer(0, 1)},
        {"203, count 0", Request::packets(1, 0, 0), packetsAnswer(0, 1)},
        {"203, four", Request::packets(1, 0, 4), packetsAnswer(0, 4)},
        {"205", Request::ringState(1, 16, 1), hex("01 CD DF 26")},
        {"206", Request::clearRing(1), hex("01 CE BC 16")},
        {"220", Request::writeConfiguration(1), hex("01 DC 00 00 81 E2")},
        {"221", Request::configuration(1, ConfigurationKind::Current), configuration1},
        {"224", Request::setByte(1, 4, 7), hex("01 E0 10 D3")},
        {"225", Request::copyConfiguration(1), hex("01 E1 31 C3")},
        // the data begin like the request and its check sum
        {"201 that begins like its echo", Request::complexRead(1),
         hex("01 C9 00 00 12 4A E1 14 00 00 00 00 0F 24 20 00 00 00 00 CC 2D 2F")},
    };
}

} // namespace

class TstAnd3Protocol : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void checkValue();
    void request_data();
    void request();
    void answer_data();
    void answer();
    void everyPrefixIsIncomplete_data() { answer_data(); }
    void everyPrefixIsIncomplete();
    void everyFlippedBitIsRefused_data() { answer_data(); }
    void everyFlippedBitIsRefused();
    void garbageBeforeIsSkipped_data() { answer_data(); }
    void garbageBeforeIsSkipped();
    void echoIsSkipped_data() { answer_data(); }
    void echoIsSkipped();
    void lateAnswerIsSkipped_data() { answer_data(); }
    void lateAnswerIsSkipped();
    void echoAloneIsNoAnswer_data() { answer_data(); }
    void echoAloneIsNoAnswer();
    void frameInsideAFrame();
    void headInsideGarbageDoesNotSwallowTheAnswer();
    void lateAnswerInPieces();
    void dataOfAnswers();
};

void TstAnd3Protocol::checkValue()
{
    QCOMPARE(crc16CcittFalse(QByteArray("123456789")), quint16(0x29B1));
}

void TstAnd3Protocol::request_data()
{
    QTest::addColumn<QByteArray>("built");
    QTest::addColumn<QByteArray>("bytes");
    const auto row = [](const char *name, const Request &request, const char *bytes) {
        QTest::newRow(name) << request.toBytes() << hex(bytes);
    };
    row("201", Request::complexRead(1), "01 C9 00 00 12 4A");
    row("201 of sensor 2", Request::complexRead(2), "02 C9 00 00 CE D1");
    row("36/4", Request::information(1, InformationKind::Firmware), "01 24 04 00 B6 64");
    row("203", Request::packets(1, 0, 1), "01 CB 00 01 53 34");
    row("203, last cell", Request::packets(1, 127, 1), "01 CB 7F 01 34 2C");
    row("50/101/1", Request::mode(1, ModeBit::RebootAcknowledged, true), "01 32 65 01 4F BD");
    row("50/6/0", Request::mode(1, ModeBit::RecordingStopped, false), "01 32 06 00 17 F3");
    row("50/6/1", Request::mode(1, ModeBit::RecordingStopped, true), "01 32 06 01 36 E3");
    row("221, current", Request::configuration(1, ConfigurationKind::Current), "01 DD 00 00 B1 D5");
    row("221, temporary", Request::configuration(1, ConfigurationKind::Temporary), "01 DD 01 00 80 E6");
    row("221, non-volatile", Request::configuration(1, ConfigurationKind::NonVolatile), "01 DD 02 00 D3 B3");
    row("206", Request::clearRing(1), "01 CE 00 00 82 CF");
    row("99", Request::reset(1), "01 63 42 63 24 07");
    row("205", Request::ringState(1, 16, 1), "01 CD 10 01 80 85");
    row("220", Request::writeConfiguration(1), "01 DC 42 63 EA D5");
    row("224", Request::setByte(1, 4, 7), "01 E0 04 07 66 EE");
    row("225", Request::copyConfiguration(1), "01 E1 00 00 75 65");
}

void TstAnd3Protocol::request()
{
    QFETCH(QByteArray, built);
    QFETCH(QByteArray, bytes);
    QCOMPARE(built.toHex(' '), bytes.toHex(' '));
}

void TstAnd3Protocol::answer_data()
{
    QTest::addColumn<qsizetype>("index");
    const QList<Exchanged> all = exchanges();
    for (qsizetype i = 0; i < all.size(); ++i) {
        QTest::newRow(all.at(i).name) << i;
    }
}

void TstAnd3Protocol::answer()
{
    QFETCH(qsizetype, index);
    const Exchanged exchanged = exchanges().at(index);
    const Search expected{Scan::complete(0, exchanged.answer.size()), false};
    QVERIFY(findAnswer(exchanged.answer, exchanged.request) == expected);
    QVERIFY(answerTo(exchanged.request)(exchanged.answer + "more") == expected.scan);
}

void TstAnd3Protocol::everyPrefixIsIncomplete()
{
    QFETCH(qsizetype, index);
    const Exchanged exchanged = exchanges().at(index);
    for (qsizetype size = 0; size < exchanged.answer.size(); ++size) {
        const Search found = findAnswer(exchanged.answer.left(size), exchanged.request);
        QVERIFY2(found.scan == Scan::incomplete(0), qPrintable(QString::number(size)));
    }
}

void TstAnd3Protocol::everyFlippedBitIsRefused()
{
    QFETCH(qsizetype, index);
    const Exchanged exchanged = exchanges().at(index);
    for (qsizetype bit = 0; bit < 8 * exchanged.answer.size(); ++bit) {
        QByteArray damaged = exchanged.answer;
        damaged[bit / 8] = static_cast<char>(damaged.at(bit / 8) ^ (1 << (bit % 8)));
        const Scan found = findAnswer(damaged, exchanged.request).scan;
        QVERIFY2(found.state != Scan::State::Complete, qPrintable(QString::number(bit)));
        // With its head intact the frame is known to be damaged, unless it may be an echo or a longer answer.
        const bool mayBeOther =
            exchanged.request.op == Op::Reset || exchanged.answer.startsWith(exchanged.request.toBytes());
        if (bit >= 16 && !mayBeOther) {
            QVERIFY2(found.state == Scan::State::Damaged && found.skip == 0, qPrintable(QString::number(bit)));
        }
    }
}

void TstAnd3Protocol::garbageBeforeIsSkipped()
{
    QFETCH(qsizetype, index);
    const Exchanged exchanged = exchanges().at(index);
    for (const char *text : {"FF", "00 00 00", "01", "01 01 02", "05 CB", "02 32 05 C9 63", "01 24 01 C9 01 CB"}) {
        const QByteArray garbage = hex(text);
        const Scan found = findAnswer(garbage + exchanged.answer, exchanged.request).scan;
        QVERIFY2(found == Scan::complete(garbage.size(), exchanged.answer.size()), text);
    }
}

void TstAnd3Protocol::echoIsSkipped()
{
    QFETCH(qsizetype, index);
    const Exchanged exchanged = exchanges().at(index);
    const QByteArray stream = exchanged.request.toBytes() + exchanged.answer;
    for (qsizetype size = 0; size < stream.size(); ++size) {
        const Scan found = findAnswer(stream.left(size), exchanged.request).scan;
        QVERIFY2(found.state == Scan::State::Incomplete, qPrintable(QString::number(size)));
    }
    const Search expected{Scan::complete(6, exchanged.answer.size()), false};
    QVERIFY(findAnswer(stream, exchanged.request) == expected);
}

void TstAnd3Protocol::lateAnswerIsSkipped()
{
    QFETCH(qsizetype, index);
    const Exchanged exchanged = exchanges().at(index);
    const QList<QByteArray> late{
        sealed({3, 50}),
        sealed({7, 36, 1, 50, 1, 201}), // the data look like heads of answers
        complexReadAnswer(7, 0x240F, 0xCC00, 9),
        packetsAnswer(PacketText::numbered(1).toBytes() + PacketText::numbered(2).toBytes(), 9),
        sealed({9, 99}),
        sealed({9, 99, 0, 0}),
    };
    for (const QByteArray &frame : late) {
        const Search expected{Scan::complete(frame.size(), exchanged.answer.size()), true};
        QVERIFY2(findAnswer(frame + exchanged.answer, exchanged.request) == expected, frame.toHex(' ').constData());
    }
}

void TstAnd3Protocol::echoAloneIsNoAnswer()
{
    QFETCH(qsizetype, index);
    const Exchanged exchanged = exchanges().at(index);
    QCOMPARE(findAnswer(exchanged.request.toBytes(), exchanged.request).scan.state, Scan::State::Incomplete);
}

/// The data of a late answer 221 hold a whole good answer 36; it is not the one that was asked for.
void TstAnd3Protocol::frameInsideAFrame()
{
    const QByteArray late = sealed(hex("01 DD") + QByteArray(5, '\x11') + firmware1 + QByteArray(19, '\x22'));
    const Request request = Request::information(1, InformationKind::Firmware);
    const Search alone{Scan::incomplete(late.size()), true};
    QVERIFY(findAnswer(late, request) == alone);
    const Search followed{Scan::complete(late.size(), firmware1.size()), true};
    QVERIFY(findAnswer(late + firmware1, request) == followed);
}

void TstAnd3Protocol::headInsideGarbageDoesNotSwallowTheAnswer()
{
    const Request request = Request::complexRead(1);
    const QByteArray noise = hex("01 C9 55");
    QByteArray stream = noise + complexRead1;
    const Scan damaged = findAnswer(stream.left(22), request).scan;
    QCOMPARE(damaged, Scan::damaged(0, noise.size()));
    stream.remove(0, damaged.skip + damaged.length);
    QCOMPARE(findAnswer(stream, request).scan, Scan::complete(0, complexRead1.size()));
}

/// While the late answer is still arriving nothing in it is taken for a damaged answer.
void TstAnd3Protocol::lateAnswerInPieces()
{
    const QByteArray late = sealed(hex("01 DD 01 24 01 02 03 04 05 06") + QByteArray(24, '\x33'));
    const Request request = Request::information(1, InformationKind::Firmware);
    for (qsizetype size = 0; size < late.size(); ++size) {
        QCOMPARE(findAnswer(late.left(size), request).scan, Scan::incomplete(0));
    }
    const Search whole{Scan::incomplete(late.size()), true};
    QVERIFY(findAnswer(late, request) == whole);
}

void TstAnd3Protocol::dataOfAnswers()
{
    QCOMPARE(dataOf(firmware1).toByteArray(), hex("0C 03 02 00"));
    QCOMPARE(dataOf(hex("01 32 2F 38")).size(), 0);
    QCOMPARE(dataOf(hex("01 32 2F")).size(), 0);
    QCOMPARE(dataOf(QByteArray()).size(), 0);
}

QTEST_GUILESS_MAIN(TstAnd3Protocol)
#include "tst_and3protocol.moc"
